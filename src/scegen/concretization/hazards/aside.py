"""Moves to the side: into another's lane, out and back, over the centre line, round somebody.

One mechanism serves dangers and manoeuvres. The lane is the one that is said, that of who suffers
it, or the free one; the move is over just before the drive slows down for its turn; and who comes
into another's lane is close before it then.
"""

from __future__ import annotations

from scegen.concretization.amounts import lasting_s
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.hazards.parties import culprits, same_arm, victims
from scegen.concretization.lane_choice import change_lanes, entry_lanes, lanes_in, neighbour_lane
from scegen.concretization.limits import (
    ABRUPT_LANE_CHANGE_S,
    CUT_IN_HEADWAY_S,
    HARD_BRAKING_MPS2,
    LANE_CHANGE_S,
    LATE_BRAKING_MPS2,
)
from scegen.concretization.meetings import STRUCTURAL, Meeting
from scegen.concretization.passing import change_length_m, slowing_s_m
from scegen.concretization.profile import SpeedChange
from scegen.concretization.setup import Setup, require_room
from scegen.concretization.stationary import blocked_lane_ahead
from scegen.concretization.turning_ways import is_outward
from scegen.errors import MotionInfeasibleError
from scegen.scenario.acts import ActKind
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind, JunctionKind, ParticipantKind, Side

_BEFORE_SLOWING_M = 3.0
_LEAST_RUN_UP_M, _SPARE_M = 10.0, 5.0
_STAYS_M, _STAYS_ASTRAY_S = 1.0, 2.0
_IN_LANE_M, _IN_LANE_S = 0.85, 0.75
_MUCH_FASTER_MPS, _GAP_M = 3.5, 1.5
_BEND_RAD = 0.35
_ABRUPT = frozenset({HazardKind.SWERVING, HazardKind.LOSS_OF_CONTROL, HazardKind.SUDDEN_TURN})


def _lane_width_m(scene: Setup, draft: DriveDraft) -> float:
    return scene.road.arms[draft.drive.entry].lane_width_m


def come_into_lane(
    scene: Setup, draft: DriveDraft, other: DriveDraft | None, kind: HazardKind | None = None
) -> list[Meeting]:
    """Change lanes: into another's, close before it, or into the one that leads on."""
    draft.entry_lane, target = _start_and_target(scene, draft, other)
    seconds = LANE_CHANGE_S if kind is None else ABRUPT_LANE_CHANGE_S
    length = change_length_m(draft.cruise_mps, seconds)
    act = scene.first_act(draft.id, ActKind.CHANGE_LANE)
    if act is not None and kind is not None:
        length = draft.cruise_mps * lasting_s(
            act, _lane_width_m(scene, draft), length / draft.cruise_mps
        )
    end = min(slowing_s_m(each) for each in (draft, other) if each is not None) - _BEFORE_SLOWING_M
    require_room(draft.id, end - length, _LEAST_RUN_UP_M, _SPARE_M)
    change_lanes(scene, draft, [(end - length, length, target)], kind)
    return [] if other is None else [close_before(scene, draft, other, draft.laid.path_s_m(end))]


def _start_and_target(scene: Setup, draft: DriveDraft, other: DriveDraft | None) -> tuple[int, int]:
    """The lane that one leaves and the one that it comes into: as they drive, or on the side said.

    Where nothing is said, one comes from the inside, a rider from the kerb.
    """
    goals, count = entry_lanes(scene, draft), lanes_in(scene, draft)
    if other is None:
        target = draft.entry_lane if draft.entry_lane in goals else goals[0]
        start = target - 1 if target > 1 else target + 1
        if start > count:
            raise MotionInfeasibleError(
                f"arm {draft.drive.entry} has one lane: there is no lane to change into",
                where=draft.id,
            )
        for each in scene.drives.values():
            # Who travels beside it is in the lane that it wants.
            if each.drive.beside == draft.id and target in entry_lanes(scene, each):
                each.take_lane(scene.network, target)
        return start, target
    own, lanes = draft.entry_lane, [lane for lane in goals if lane in entry_lanes(scene, other)]
    if not lanes:
        raise MotionInfeasibleError(
            f"no lane of arm {draft.drive.entry} leads both {draft.id} and {other.id} where they "
            "go",
            where=draft.id,
        )
    if abs(own - other.entry_lane) == 1 and other.entry_lane in lanes:
        return own, other.entry_lane
    outward = is_outward(scene.functional, draft.id, other.id)
    if outward is None:
        outward = draft.kind is ParticipantKind.BICYCLE
    inner = [lane for lane in lanes if lane < count]
    target = inner[0] if outward and inner else lanes[0]
    other.take_lane(scene.network, target)
    inside = target > 1 and not (outward and inner)
    return target - 1 if inside else target + 1, target


def close_before(
    scene: Setup,
    draft: DriveDraft,
    other: DriveDraft,
    place_s_m: float,
    other_s_m: float | None = None,
) -> Meeting:
    """At a place of its way, one is close before another; one who is much faster brakes late.

    ``other_s_m`` is the same place on the other's way, if that differs: in a ring, where nobody is
    much faster.
    """
    there = place_s_m if other_s_m is None else other_s_m
    closing = other.cruise_mps - draft.cruise_mps if other_s_m is None else 0.0
    if closing < _MUCH_FASTER_MPS:
        headway = float(scene.rng.uniform(*CUT_IN_HEADWAY_S))
        gap = headway * other.cruise_mps
        reason = f"comes into its lane {headway:.2f} s ahead"
    else:
        gap = _GAP_M + closing**2 / (2 * LATE_BRAKING_MPS2)
        reason = f"comes up behind {draft.id}"
    met = max(0.0, there - gap - draft.body.rear_m - other.body.front_m)
    return Meeting(STRUCTURAL, draft.id, other.id, place_s_m, met, 0.0, reason)


def out_and_back(scene: Setup, draft: DriveDraft, hazard: Hazard) -> list[Meeting]:
    """Out of the lane and back: as is said, else towards who suffers it, close before it.

    One that leaves its lane for another danger already does both in one.
    """
    if draft.lane_changes:
        return []
    if hazard.kind is HazardKind.ONCOMING_LANE:
        return _over_the_line(scene, draft, hazard)
    act = scene.first_act(draft.id, ActKind.SWERVE)
    near = (other for other in victims(scene, hazard, draft) if same_arm(draft, other))
    beside = next((o for o in near if abs(o.entry_lane - draft.entry_lane) == 1), None)
    width = act.lateral_m.middle if act is not None and act.lateral_m is not None else 0.0
    aside = draft.entry_lane
    usual = max(8.0 / draft.cruise_mps, ABRUPT_LANE_CHANGE_S)
    if not width and act is not None and act.side is not None:
        aside += 1 if act.side.value == scene.functional.junction.driving_side.value else -1
        if aside > lanes_in(scene, draft):
            # Towards the kerb, where there is no lane: as far as its own one lets it.
            aside, width, usual = draft.entry_lane, _IN_LANE_M, _IN_LANE_S
    elif not width and beside is not None:
        aside = beside.entry_lane
    elif not width:
        ring = scene.road.kind is JunctionKind.ROUNDABOUT
        aside = neighbour_lane(scene, draft, oncoming=not ring)
    offset = width if act is not None and act.side is Side.LEFT else -width
    lasts = usual if act is None else lasting_s(act, width or _lane_width_m(scene, draft), usual)
    length = lasts * draft.cruise_mps
    out = _stray(scene, draft, aside, length, _STAYS_M, hazard.kind, offset_m=offset)
    if beside is None or beside.entry_lane != aside:
        return []
    return [close_before(scene, draft, beside, draft.laid.path_s_m(out + length))]


def _over_the_line(scene: Setup, draft: DriveDraft, hazard: Hazard) -> list[Meeting]:
    """Over the centre line; whom it then meets it meets head-on."""
    if not blocked_lane_ahead(scene, draft):
        draft.entry_lane = min(entry_lanes(scene, draft))
        quick = scene.kinds_by(draft.id) & _ABRUPT
        seconds = ABRUPT_LANE_CHANGE_S if quick else LANE_CHANGE_S
        length = change_length_m(draft.cruise_mps, seconds)
        _stray(scene, draft, 0, length, _STAYS_ASTRAY_S * draft.cruise_mps, hazard.kind)
    return []


def _stray(
    scene: Setup,
    draft: DriveDraft,
    aside: int,
    length_m: float,
    stays_m: float,
    kind: HazardKind,
    *,
    offset_m: float = 0.0,
) -> float:
    """Out to the side and back into its lane; returns where it begins."""
    end = slowing_s_m(draft) - _BEFORE_SLOWING_M
    start = end - 2 * length_m - stays_m
    require_room(draft.id, start, _LEAST_RUN_UP_M, _SPARE_M)
    ways = [(start, length_m, aside), (end - length_m, length_m, draft.entry_lane)]
    change_lanes(scene, draft, ways, kind, offset_m=offset_m)
    return start


def swerve(scene: Setup, hazard: Hazard) -> list[Meeting]:
    """Out of the lane and back, everybody who causes a danger."""
    return [m for draft in culprits(scene, hazard) for m in out_and_back(scene, draft, hazard)]


def turn_the_wheel(scene: Setup, hazard: Hazard) -> list[Meeting]:
    """One whose way has no bend turns the wheel all the same: into the lane beside, and back."""
    meetings: list[Meeting] = []
    for draft in culprits(scene, hazard):
        heading = draft.laid.path.heading_rad
        if abs(heading - heading[0]).max() <= _BEND_RAD:
            meetings += out_and_back(scene, draft, hazard)
    return meetings


def brake_out_of_control(scene: Setup, hazard: Hazard) -> None:
    """Loss of control ends in hard braking to walking pace."""
    for draft in culprits(scene, hazard):
        for change in draft.lane_changes[-1:]:
            rate = draft.braking_mps2(HARD_BRAKING_MPS2[0])
            place = draft.laid.path_s_m(change.position_m)
            slows = SpeedChange(2.0, rate, s_m=place, hazard=hazard.kind)
            draft.hold(slows, 1.0)
