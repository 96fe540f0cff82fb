"""Swerving and loss of control: two quick lane changes there and back."""

from __future__ import annotations

from scegen.concretization.amounts import lasting_s
from scegen.concretization.courses import SpeedChange
from scegen.concretization.drafts import DriveDraft, Setup
from scegen.concretization.hazards.rule import Rule, culprits, same_arm, victims
from scegen.concretization.lane_choice import (
    change_lanes,
    entry_lanes,
    lanes_in,
    neighbour_lane,
)
from scegen.concretization.limits import (
    ABRUPT_LANE_CHANGE_S,
    CUT_IN_HEADWAY_S,
    HARD_BRAKING_MPS2,
)
from scegen.concretization.meetings import STRUCTURAL, Meeting
from scegen.concretization.passing import slowing_s_m
from scegen.concretization.room import NeedsLongerArms
from scegen.road.defaults import LANE_WIDTH_M
from scegen.scenario.acts import ActKind
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind, JunctionKind, Side

_STAYS_M = 1.0
_IN_LANE_M, _IN_LANE_S = 0.85, 0.75


def swerve(scene: Setup, draft: DriveDraft, hazard: Hazard) -> list[Meeting]:
    """Out of the lane and back before the junction: as is said, else towards the sufferer.

    Close before it, if it drives in a lane beside. One that leaves its lane for another danger
    (cuts in, strays into oncoming traffic) does both in one.
    """
    if draft.lane_changes:
        return []
    act = scene.first_act(draft.id, ActKind.SWERVE)
    beside = sufferer_beside(scene, hazard, draft)
    width = act.lateral_m.middle if act is not None and act.lateral_m is not None else 0.0
    aside = draft.entry_lane
    usual = max(8.0 / draft.cruise_mps, ABRUPT_LANE_CHANGE_S)
    if not width and act is not None and act.side is not None:
        outward = act.side.value == scene.functional.junction.driving_side.value
        aside += 1 if outward else -1
        if aside > lanes_in(scene, draft):
            # Towards the kerb, where there is no lane: as far as its own one lets it.
            aside, width, usual = draft.entry_lane, _IN_LANE_M, _IN_LANE_S
    elif not width and beside is not None:
        aside = beside.entry_lane
    elif not width and meet_at_centre_line(scene, hazard, draft):
        aside = 0
    elif not width:
        ring = scene.road.kind is JunctionKind.ROUNDABOUT
        aside = neighbour_lane(scene, draft, oncoming=not ring)
    offset = width if act is not None and act.side is Side.LEFT else -width
    lasts = usual if act is None else lasting_s(act, width or LANE_WIDTH_M, usual)
    length = lasts * draft.cruise_mps
    out = stray(scene, draft, aside, length, _STAYS_M, hazard.kind, offset_m=offset)
    if beside is None or beside.entry_lane != aside:
        return []
    return [close_before(scene, draft, beside, out + length)]


def stray(
    scene: Setup,
    draft: DriveDraft,
    aside: int,
    length_m: float,
    stays_m: float,
    kind: HazardKind,
    *,
    offset_m: float = 0.0,
) -> float:
    """Out to the side and back into its lane before it slows down; returns where it begins.

    Raises:
        NeedsLongerArms: the arm is too short for it.
    """
    whole = 2 * length_m + stays_m
    end = slowing_s_m(draft) - 2.0
    start = end - whole
    if start < 10.0:
        raise NeedsLongerArms(15.0 - start, draft.id)
    ways = [(start, length_m, aside), (end - length_m, length_m, draft.entry_lane)]
    change_lanes(scene, draft, ways, kind, offset_m=offset_m)
    return start


def sufferer_beside(scene: Setup, hazard: Hazard, draft: DriveDraft) -> DriveDraft | None:
    """The sufferer in a lane next to one who causes a danger, on the same arm."""
    for other in victims(scene, hazard, draft):
        if same_arm(draft, other) and abs(other.entry_lane - draft.entry_lane) == 1:
            return other
    return None


def meet_at_centre_line(scene: Setup, hazard: Hazard, draft: DriveDraft) -> bool:
    """Put one who strays and those who come towards it next to the centre line, if any come."""
    oncoming = [
        other
        for other in victims(scene, hazard, draft)
        if other.drive.entry == draft.drive.exit and other.drive.exit == draft.drive.entry
    ]
    for each in (draft, *oncoming) if oncoming else ():
        inner = min(entry_lanes(scene, each))
        if inner != each.entry_lane and not each.lane_changes:
            each.entry_lane = inner
            each.lay(scene.network)
    return bool(oncoming) and draft.entry_lane == 1


def close_before(scene: Setup, draft: DriveDraft, other: DriveDraft, place_m: float) -> Meeting:
    """At a place of its way, one is as close before another as a cut-in."""
    place = draft.laid.path_s_m(place_m)
    headway = float(scene.rng.uniform(*CUT_IN_HEADWAY_S))
    gap = headway * other.cruise_mps + draft.body.rear_m + other.body.front_m
    reason = f"comes into its lane {headway:.2f} s ahead"
    return Meeting(STRUCTURAL, draft.id, other.id, place, max(0.0, place - gap), 0.0, reason)


def _swerving(scene: Setup, hazard: Hazard) -> list[Meeting]:
    return [m for draft in culprits(scene, hazard) for m in swerve(scene, draft, hazard)]


def _losing(scene: Setup, hazard: Hazard) -> list[Meeting]:
    return [m for draft in culprits(scene, hazard) for m in swerve(scene, draft, hazard)]


def _brake(scene: Setup, hazard: Hazard) -> None:
    """Loss of control ends in hard braking to walking pace."""
    for draft in culprits(scene, hazard):
        changes = draft.lane_changes
        if not changes:
            continue
        place = draft.laid.path_s_m(changes[-1].position_m)
        rate = draft.braking_mps2(HARD_BRAKING_MPS2[0])
        draft.add_speed_change(
            SpeedChange(place, 2.0, rate, HazardKind.LOSS_OF_CONTROL, hold_s=1.0)
        )


SWERVING = Rule(shape=_swerving)
LOSS_OF_CONTROL = Rule(shape=_losing, act=_brake)
