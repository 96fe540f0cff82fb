"""Cut-in: an abrupt change into another's lane, a short gap before it.

On an arm it comes from the lane beside; in a ring it crosses from the inner lane to the outer one
just before its exit, or from the outer one to the inner, in which it is then that both go. Between
ways that enter on different arms it is one vehicle turning in front of another: they meet.
"""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.hazards.aside import close_before, come_into_lane
from scegen.concretization.hazards.parties import pairs, same_arm
from scegen.concretization.lane_choice import change_lanes, choose_ring_lane, lanes_in, routes_of
from scegen.concretization.limits import ABRUPT_LANE_CHANGE_S
from scegen.concretization.meetings import Meeting, nearest_s_m
from scegen.concretization.passing import change_length_m
from scegen.concretization.setup import Setup
from scegen.concretization.tale import outward
from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import is_ring
from scegen.motion.stretches import Stretch
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind, JunctionKind

_RING_MARGIN_M = 0.25
_LEAST_RING_CHANGE_M = 7.0
_SAME_LINE_M = 2.0


def start_inside(scene: Setup, hazard: Hazard) -> None:
    """In a ring, who changes outwards starts on the inner lane, else who is cut in on does."""
    if scene.road.kind is not JunctionKind.ROUNDABOUT:
        return
    for culprit, victim in pairs(scene, hazard):
        draft = culprit if _outwards(scene, culprit) else victim
        inner = min(routes_of(scene, draft), key=lambda route: route.ring_lane or 0)
        draft.entry_lane = draft.exit_lane = inner.entry_lane
        choose_ring_lane(scene, draft, inner=True)


def _outwards(scene: Setup, draft: DriveDraft) -> bool:
    """Whether it changes from the inner ring lane to the outer one, as towards an exit."""
    side = draft.drive.changes_to
    return side is None or outward(scene.functional, side) > 0


def come_in(scene: Setup, hazard: Hazard) -> list[Meeting]:
    """The changes of lane into the sufferers' way, and the meetings that they need."""
    meetings: list[Meeting] = []
    done: set[str] = set()
    for culprit, victim in pairs(scene, hazard):
        ring = scene.road.kind is JunctionKind.ROUNDABOUT
        beside = same_arm(culprit, victim) and lanes_in(scene, culprit) > 1
        if culprit.id in done or not (ring or beside):
            continue
        come = _in_ring if ring else come_into_lane
        meetings += come(scene, culprit, victim, hazard.kind)
        done.add(culprit.id)
    return meetings


def _in_ring(
    scene: Setup, culprit: DriveDraft, victim: DriveDraft, kind: HazardKind
) -> list[Meeting]:
    rings = [piece for piece in culprit.laid.stretches if is_ring(piece.road)]
    usable = [p for p in rings if _room_m(p) >= _LEAST_RING_CHANGE_M]
    if not usable or scene.road.ring_lanes < 2:
        raise MotionInfeasibleError(
            "the longest ring road between two arms on the way is "
            f"{max((_room_m(p) for p in rings), default=0.0):.1f} m long; a change of ring lane "
            f"needs two ring lanes and {_LEAST_RING_CHANGE_M:.0f} m",
            where=culprit.id,
            hint="Make the roundabout larger.",
        )
    theirs = {piece.road.id for piece in victim.laid.stretches}
    piece = ([p for p in usable if p.road.id in theirs] or usable)[-1]
    room = _room_m(piece)
    length = min(room, change_length_m(culprit.cruise_mps, ABRUPT_LANE_CHANGE_S))
    begin = piece.end_m - _RING_MARGIN_M - length
    end_s = culprit.laid.path_s_m(begin + length)
    target = scene.road.ring_lanes if _outwards(scene, culprit) else 1
    change_lanes(scene, culprit, [(begin, length, target)], kind)
    pose = culprit.laid.path.pose(end_s)
    place, apart = nearest_s_m(victim.laid.path, pose.x_m, pose.y_m)
    if apart > _SAME_LINE_M:
        return []
    return [close_before(scene, culprit, victim, end_s, place)]


def _room_m(piece: Stretch) -> float:
    return piece.end_m - piece.start_m - 2 * _RING_MARGIN_M
