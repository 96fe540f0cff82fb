"""Coming up behind one who is slower or stands: the one behind brakes late, down to its pace.

Somebody in a queue who is faster than the one ahead, and does not go round it, would drive
through it. It brakes so that it is close behind when both are equally fast. Those who stand move
off once it has come to a stop behind them.
"""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft, Scene
from scegen.concretization.hazards.rule import (
    BRAKES,
    brake_behind,
    braking_of,
    in_line_before,
)
from scegen.concretization.limits import (
    COMFORTABLE_ACCELERATION_MPS2,
    LATE_BRAKING_MPS2,
)
from scegen.concretization.marks import Mark
from scegen.concretization.meetings import STRUCTURAL, Meeting
from scegen.concretization.passing import slowing_s_m
from scegen.concretization.room import NeedsLongerArms
from scegen.scenario.concrete import SpeedPhase, StoodStill
from scegen.scenario.vocabulary import HazardKind, Maneuver

_STAYS_OR_PASSES = frozenset({Maneuver.STAY, Maneuver.LANE_CHANGE, Maneuver.OVERTAKE})
_FASTER = 1.15
_GAP_M = 1.2
_QUEUE_GAP_M = 2.0
_BEFORE_LINE_M = 2.0
_LEAST_PLACE_M = 40.0
_STOOD_S = 200.0
_MOVES_OFF_S = 1.0
_ONE_BY_ONE_S = 0.8


def stands_in_line(scene: Scene, draft: DriveDraft) -> bool:
    """Whether one who is said to stay stands in the lane of somebody who stops behind it."""
    return draft.drive.maneuver is Maneuver.STAY and bool(_from_behind(scene, draft))


def _from_behind(scene: Scene, draft: DriveDraft) -> list[DriveDraft]:
    """Those who come from behind in the same lane and do not go round, the first first."""
    passing = {
        name
        for hazard in scene.functional.hazards
        if hazard.kind is HazardKind.OVERTAKING
        for name in hazard.by
    }
    coming = [
        other
        for other in scene.drives.values()
        if other.drive.maneuver not in _STAYS_OR_PASSES
        and other.id not in passing
        and other.drive.entry == draft.drive.entry
        and other.entry_lane == draft.entry_lane
        and other.drive.rank > draft.drive.rank
        and not other.lane_changes
    ]
    return sorted(coming, key=lambda other: other.drive.rank)


def prepare_standing(scene: Scene) -> None:
    """Those who stand drive on like the others once they move off."""
    for draft in scene.drives.values():
        if stands_in_line(scene, draft):
            behind = _from_behind(scene, draft)[0]
            pace = min(behind.cruise_mps, draft.body.top_speed_mps)
            scene.note(f"{draft.id}.speed_mps", pace, "moves off in the end", draft.cruise_mps)
            draft.cruise_mps = pace


def come_up(scene: Scene) -> list[Meeting]:
    """The braking of those who come up behind others, and the meetings that it needs."""
    meetings: list[Meeting] = []
    paces = {draft.id: draft.cruise_mps for draft in scene.drives.values()}
    for draft in sorted(scene.drives.values(), key=lambda d: d.drive.rank):
        line = in_line_before(scene, draft)
        if not line or draft.drive.maneuver is Maneuver.STAY:
            continue
        lead = line[-1]
        if (
            draft.comes_up
            or draft.lane_changes
            or lead.lane_changes
            or draft.drive.beside
            or lead.drive.beside
        ):
            continue
        standing = [other for other in line if stands_in_line(scene, other)]
        if lead in standing:
            meetings += _up_to_standing(scene, draft, standing)
            paces[draft.id] = 0.0
        elif draft.cruise_mps > _FASTER * paces[lead.id] and not _otherwise(scene, draft, lead):
            meetings += _up_to_slower(scene, draft, lead, paces[lead.id])
            paces[draft.id] = paces[lead.id]
    return meetings


def _otherwise(scene: Scene, draft: DriveDraft, lead: DriveDraft) -> bool:
    """Whether a danger already says how the two come together or part."""
    if any(mark.hazard is not None for mark in (*draft.marks, *lead.marks)):
        return True
    kinds = {
        hazard.kind
        for hazard in scene.functional.hazards
        if {draft.id, lead.id} & {*hazard.by} and hazard.kind is not HazardKind.SLOW_DRIVING
    }
    # One who comes up behind one slow one reacts to it; several would drive through each other.
    following = [each for each in scene.drives.values() if lead in in_line_before(scene, each)]
    alone = not in_line_before(scene, lead) and following == [draft]
    slow = any(
        hazard.kind is HazardKind.SLOW_DRIVING and lead.id in hazard.by
        for hazard in scene.functional.hazards
    )
    return bool(kinds) or (slow and alone) or lead.drive.maneuver is Maneuver.STAY


def _up_to_standing(scene: Scene, draft: DriveDraft, standing: list[DriveDraft]) -> list[Meeting]:
    """Stop behind the last of a queue; ``standing`` from the front."""
    places: list[tuple[DriveDraft, float]] = []
    head = standing[0]
    if scene.network.junctions:
        place = head.junction_s_m - head.body.front_m - _BEFORE_LINE_M
    else:
        place = max(head.laid.path.length_m / 2, _LEAST_PLACE_M)
    ahead: DriveDraft | None = None
    for number, one in enumerate(standing):
        if ahead is not None:
            place -= ahead.body.rear_m + _QUEUE_GAP_M + one.body.front_m
        one.stands_at_m = place
        places.append((one, place))
        one.marks = [m for m in one.marks if m.hazard is not HazardKind.STOPPING]
        rate = one.braking_mps2(LATE_BRAKING_MPS2)
        braking = one.cruise_mps**2 / (2 * rate)
        one.add_mark(Mark(max(0.1, place - braking), 0.0, rate, hold_s=_STOOD_S))
        waits = _MOVES_OFF_S + number * _ONE_BY_ONE_S
        one.moves_off = SpeedPhase(
            trigger=StoodStill(participant=draft.id, duration_s=round(waits + 0.013, 3)),
            target_speed_mps=one.cruise_mps,
            rate_mps2=one.acceleration_mps2(COMFORTABLE_ACCELERATION_MPS2),
        )
        ahead = one
    last = standing[-1]
    rest = place - last.body.rear_m - _GAP_M - draft.body.front_m
    hazard, rate = braking_of(scene, draft)
    braking = draft.cruise_mps**2 / (2 * rate)
    if rest - braking < draft.body.rear_m + draft.cruise_mps:
        raise NeedsLongerArms(draft.cruise_mps + braking - rest + 10.0, draft.id)
    draft.marks = [m for m in draft.marks if m.hazard not in BRAKES]
    draft.comes_up = True
    hold = _MOVES_OFF_S + (len(standing) + 1) * _ONE_BY_ONE_S + 1.0
    draft.add_mark(Mark(rest - braking, 0.0, rate, hazard, hold_s=hold))
    reason = f"comes up behind {last.id}, which stands"
    return [
        Meeting(STRUCTURAL, one.id, draft.id, at_m, rest - 0.3, _STOOD_S / 2, reason)
        for one, at_m in places
    ]


def _up_to_slower(
    scene: Scene, draft: DriveDraft, lead: DriveDraft, pace_mps: float
) -> list[Meeting]:
    """Brake to the pace of the one ahead, and be close behind it then."""
    if scene.network.junctions:
        place = min(slowing_s_m(draft), slowing_s_m(lead)) - draft.cruise_mps
    else:
        place = draft.laid.path.length_m / 2
    brake_behind(scene, draft, place, pace_mps)
    bodies = lead.body.rear_m + _GAP_M + draft.body.front_m
    reason = f"comes up behind {lead.id}"
    return [Meeting(STRUCTURAL, lead.id, draft.id, place + bodies, place, 0.0, reason)]
