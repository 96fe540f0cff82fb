"""Cut-in: an abrupt change into another's lane, a short gap before it.

On an arm it comes from the lane beside; in a ring it crosses from the inner lane to the outer one
just before its exit. Between ways that enter on different arms it is one vehicle turning in
front of another: they meet.
"""

from __future__ import annotations

from scegen.concretization.abreast import is_outward
from scegen.concretization.amounts import lasting_s
from scegen.concretization.courses import SpeedChange
from scegen.concretization.drafts import DriveDraft, Setup
from scegen.concretization.hazards.rule import (
    Rule,
    culprits,
    pairs,
    same_arm,
)
from scegen.concretization.lane_choice import (
    change_lanes,
    choose_ring_lane,
    entry_lanes,
    lanes_in,
    routes_of,
)
from scegen.concretization.limits import (
    ABRUPT_LANE_CHANGE_S,
    CUT_IN_HEADWAY_S,
    LATE_BRAKING_MPS2,
)
from scegen.concretization.meetings import STRUCTURAL, Meeting, nearest_s_m
from scegen.concretization.passing import (
    change_length_m,
    slowing_s_m,
    speed_for_change_mps,
)
from scegen.concretization.room import NeedsLongerArms
from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import is_ring
from scegen.motion.stretches import Stretch
from scegen.road.defaults import LANE_WIDTH_M
from scegen.scenario.acts import ActKind
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind, JunctionKind, ParticipantKind

_RING_MARGIN_M = 0.25
_LEAST_RING_CHANGE_M = 7.0
_SAME_LINE_M = 2.0
_MUCH_FASTER_MPS = 3.5
_GAP_M = 1.5


def _prepare(scene: Setup, hazard: Hazard) -> None:
    """In a ring, start on the inner lane."""
    if scene.road.kind is not JunctionKind.ROUNDABOUT:
        return
    for draft in culprits(scene, hazard):
        inner = min(routes_of(scene, draft), key=lambda route: route.ring_lane or 0)
        draft.entry_lane = draft.exit_lane = inner.entry_lane
        choose_ring_lane(scene, draft, inner=True)


def come_in(scene: Setup, hazard: Hazard) -> list[Meeting]:
    """The changes of lane into the sufferers' way, and the meetings that they need."""
    meetings: list[Meeting] = []
    done: set[str] = set()
    for culprit, victim in pairs(scene, hazard):
        if culprit.id in done:
            continue
        if scene.road.kind is JunctionKind.ROUNDABOUT:
            meetings += _in_ring(scene, culprit, victim)
            done.add(culprit.id)
        elif same_arm(culprit, victim) and lanes_in(scene, culprit) > 1:
            meetings += on_arm(scene, culprit, victim, HazardKind.CUT_IN)
            done.add(culprit.id)
    return meetings


def on_arm(
    scene: Setup, culprit: DriveDraft, victim: DriveDraft, kind: HazardKind
) -> list[Meeting]:
    """Into the sufferer's lane, close before it; one who is much faster brakes late."""
    lanes = [n for n in entry_lanes(scene, culprit) if n in entry_lanes(scene, victim)]
    if not lanes:
        raise MotionInfeasibleError(
            f"no lane of arm {culprit.drive.entry} leads both {culprit.id} and {victim.id} "
            "where they go",
            where=culprit.id,
        )
    target, start = _lanes(scene, culprit, victim, lanes)
    victim.entry_lane = target
    victim.lay(scene.network)
    culprit.entry_lane = start
    length = change_length_m(culprit.cruise_mps, ABRUPT_LANE_CHANGE_S)
    act = scene.first_act(culprit.id, ActKind.CHANGE_LANE)
    if act is not None:
        length = culprit.cruise_mps * lasting_s(act, LANE_WIDTH_M, length / culprit.cruise_mps)
    end = min(slowing_s_m(culprit), slowing_s_m(victim)) - 5.0
    if end - length < 10.0:
        raise NeedsLongerArms(15.0 - (end - length), culprit.id)
    change_lanes(scene, culprit, [(end - length, length, target)], kind)
    closing = victim.cruise_mps - culprit.cruise_mps
    if closing < _MUCH_FASTER_MPS:
        return [_close_behind(scene, culprit, victim, end, end)]
    gap = _GAP_M + closing**2 / (2 * LATE_BRAKING_MPS2)
    place = end - culprit.body.rear_m - gap - victim.body.front_m
    reason = f"comes up behind {culprit.id}"
    return [Meeting(STRUCTURAL, culprit.id, victim.id, end, place, 0.0, reason)]


def _lanes(
    scene: Setup, culprit: DriveDraft, victim: DriveDraft, lanes: list[int]
) -> tuple[int, int]:
    """(the sufferer's lane, the one it is cut in from): as they drive, or on the side said.

    Where nothing is said, the cut-in comes from the inside, a rider's from the kerb.
    """
    own, other = culprit.entry_lane, victim.entry_lane
    if abs(own - other) == 1 and other in lanes:
        return other, own
    outward = is_outward(scene.functional, culprit.id, victim.id)
    if outward is None:
        outward = culprit.kind is ParticipantKind.BICYCLE
    count = lanes_in(scene, culprit)
    inner = [lane for lane in lanes if lane < count]
    if outward and inner:
        return inner[0], inner[0] + 1
    target = lanes[0]
    return target, target - 1 if target > 1 else target + 1


def _close_behind(
    scene: Setup, culprit: DriveDraft, victim: DriveDraft, place_m: float, victim_m: float
) -> Meeting:
    headway = float(scene.rng.uniform(*CUT_IN_HEADWAY_S))
    gap = headway * victim.cruise_mps + culprit.body.rear_m + victim.body.front_m
    reason = f"cut-in {headway:.2f} s ahead"
    return Meeting(STRUCTURAL, culprit.id, victim.id, place_m, max(0.0, victim_m - gap), 0, reason)


def _in_ring(scene: Setup, culprit: DriveDraft, victim: DriveDraft) -> list[Meeting]:
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
    piece = usable[-1]
    room = _room_m(piece)
    length = min(room, change_length_m(culprit.cruise_mps, ABRUPT_LANE_CHANGE_S))
    begin = piece.end_m - _RING_MARGIN_M - length
    end_s = culprit.laid.path_s_m(begin + length)
    change_lanes(scene, culprit, [(begin, length, scene.road.ring_lanes)], HazardKind.CUT_IN)
    fastest = speed_for_change_mps(length)
    speed = culprit.course.speed_at(end_s - length)
    if speed > fastest:
        culprit.add_speed_change(SpeedChange(max(1.0, end_s - length - speed), fastest, 3.0))
    pose = culprit.laid.path.pose(end_s)
    place, apart = nearest_s_m(victim.laid.path, pose.x_m, pose.y_m)
    if apart > _SAME_LINE_M:
        return []
    return [_close_behind(scene, culprit, victim, end_s, place)]


def _room_m(piece: Stretch) -> float:
    return piece.end_m - piece.start_m - 2 * _RING_MARGIN_M


CUT_IN = Rule(prepare=_prepare, shape=come_in)
