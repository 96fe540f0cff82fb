"""Cutting in in a ring: across to the outer lane just before one's exit, or to the inner one."""

from scegen.concretization.aside import change_length_m, close_before
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.encounters import culprits, victims
from scegen.concretization.limits import ABRUPT_LANE_CHANGE_S
from scegen.concretization.meetings import Meeting
from scegen.concretization.setup import Setup
from scegen.concretization.tale import outward
from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import is_ring
from scegen.scenario.concrete import LaneChange
from scegen.scenario.vocabulary import HazardKind

_MARGIN_M, _LEAST_CHANGE_M = 0.25, 7.0


def goes_outwards(scene: Setup, draft: DriveDraft) -> bool:
    """Whether it changes from the inner ring lane to the outer one, as towards an exit.

    Else whom it cuts in on is inside.
    """
    side = draft.drive.changes_to
    return side is None or outward(scene.functional, side) > 0


def cut_in_in_rings(scene: Setup) -> list[Meeting]:
    """The moves of those who cut in in a ring, who are close before the others then."""
    meetings: list[Meeting] = []
    for hazard in scene.of_kind(HazardKind.CUT_IN) if scene.ring else ():
        for draft in culprits(scene, hazard):
            for other in victims(scene, hazard, draft)[:1]:
                meetings += _cut_in(scene, draft, other)
    return meetings


def _cut_in(scene: Setup, draft: DriveDraft, other: DriveDraft) -> list[Meeting]:
    least_m = _LEAST_CHANGE_M + 2 * _MARGIN_M
    ring = [piece for piece in draft.laid.stretches if is_ring(piece.road)]
    usable = [piece for piece in ring if piece.end_m - piece.start_m >= least_m]
    if not usable or scene.road.ring_lanes < 2:
        raise MotionInfeasibleError(
            "no ring road between two arms on its way is long enough; a change of ring lane needs "
            f"two ring lanes and {_LEAST_CHANGE_M:.0f} m",
            where=draft.id,
            hint="Make the roundabout larger.",
        )
    theirs = {piece.road.id for piece in other.laid.stretches}
    piece = ([piece for piece in usable if piece.road.id in theirs] or usable)[-1]
    end_m = piece.end_m - _MARGIN_M
    room_m = end_m - piece.start_m - _MARGIN_M
    length = min(room_m, change_length_m(draft, ABRUPT_LANE_CHANGE_S))
    lane = scene.road.ring_lanes if goes_outwards(scene, draft) else 1
    change = LaneChange(
        position_m=round(end_m - length, 3),
        length_m=round(length, 3),
        lane_after=lane,
        hazard=HazardKind.CUT_IN,
    )
    draft.lane_changes.append(change)
    draft.lay(scene.network)
    return close_before(scene, draft, other, end_m)
