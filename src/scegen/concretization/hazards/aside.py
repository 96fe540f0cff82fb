"""Moves to the side: into another's lane, out and back, over the centre line, round somebody.

One mechanism serves dangers and manoeuvres. The lane is the one that is said, that of who suffers
it, or the free one; the move is over just before the drive slows down for its turn; and who comes
into another's lane is close before it then. In a ring a cut-in crosses to the outer lane just
before its exit, or to the inner one, in which it is then that both go; between ways that enter on
different arms it is one vehicle turning in front of another: they meet.
"""

from __future__ import annotations

from scegen.concretization.amounts import lasting_s
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.hazards.parties import culprits, same_arm, victims
from scegen.concretization.limits import (
    ABRUPT_LANE_CHANGE_S,
    CUT_IN_HEADWAY_S,
    HARD_BRAKING_MPS2,
    LANE_CHANGE_S,
    LATE_BRAKING_MPS2,
)
from scegen.concretization.meetings import STRUCTURAL, Meeting, nearest_s_m
from scegen.concretization.passing import change_length_m, move_aside, neighbour_lane, over_by_m
from scegen.concretization.profile import SpeedChange
from scegen.concretization.setup import Setup
from scegen.concretization.stationary import blocking_m
from scegen.concretization.tale import outward
from scegen.concretization.turning_ways import is_outward
from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import is_ring
from scegen.scenario.acts import ActKind
from scegen.scenario.vocabulary import HazardKind, ParticipantKind, Side

_STAYS_M, _STAYS_ASTRAY_S = 1.0, 2.0
_IN_LANE_M, _IN_LANE_S = 0.85, 0.75
_MUCH_FASTER_MPS, _GAP_M = 3.5, 1.5
_BEND_RAD = 0.35
_ABRUPT = frozenset({HazardKind.SWERVING, HazardKind.LOSS_OF_CONTROL, HazardKind.SUDDEN_TURN})
_ASIDE = (
    HazardKind.SUDDEN_TURN,
    HazardKind.CUT_IN,
    HazardKind.ONCOMING_LANE,
    HazardKind.SWERVING,
    HazardKind.LOSS_OF_CONTROL,
)
"""The dangers of those who leave their way, in the order in which they do so."""
_RING_MARGIN_M, _LEAST_RING_CHANGE_M = 0.25, 7.0
_SAME_LINE_M = 2.0


def goes_outwards(scene: Setup, draft: DriveDraft) -> bool:
    """Whether it changes from the inner ring lane to the outer one, as towards an exit.

    Else whom it cuts in on is inside.
    """
    side = draft.drive.changes_to
    return side is None or outward(scene.functional, side) > 0


def leave_lanes(scene: Setup) -> list[Meeting]:
    """The moves of those who endanger somebody by one, and the meetings that they need.

    One that leaves its lane for another danger already does both in one.
    """
    meetings: list[Meeting] = []
    for kind in _ASIDE:
        for hazard in scene.of_kind(kind):
            for draft in culprits(scene, hazard):
                if not draft.lane_changes:
                    others = victims(scene, hazard, draft)
                    meetings += _leave_lane(scene, draft, others, kind)
    return meetings


def _leave_lane(
    scene: Setup, draft: DriveDraft, others: list[DriveDraft], kind: HazardKind
) -> list[Meeting]:
    along = [other for other in others if same_arm(draft, other)]
    if kind is HazardKind.CUT_IN and scene.ring:
        return _in_ring(scene, draft, others[0], kind) if others else []
    if kind is HazardKind.CUT_IN:
        wide = along and scene.lanes_in(draft) > 1
        return come_into_lane(scene, draft, along[0], kind) if wide else []
    if kind is HazardKind.ONCOMING_LANE and blocking_m(scene, draft):
        return []  # it strays round that one
    heading = draft.laid.path.heading_rad
    if kind is HazardKind.SUDDEN_TURN and abs(heading - heading[0]).max() > _BEND_RAD:
        return []  # it turns; where there is no bend, it turns the wheel all the same
    return _out_and_back(scene, draft, along, kind)


def _in_ring(
    scene: Setup, culprit: DriveDraft, victim: DriveDraft, kind: HazardKind
) -> list[Meeting]:
    rooms = {
        piece.end_m - _RING_MARGIN_M: (piece.end_m - piece.start_m - 2 * _RING_MARGIN_M, piece.road)
        for piece in culprit.laid.stretches
        if is_ring(piece.road)
    }
    usable = [end_m for end_m, (room_m, _) in rooms.items() if room_m >= _LEAST_RING_CHANGE_M]
    if not usable or scene.road.ring_lanes < 2:
        raise MotionInfeasibleError(
            "the longest ring road between two arms on the way is "
            f"{max((room_m for room_m, _ in rooms.values()), default=0.0):.1f} m long; a change of "
            f"ring lane needs two ring lanes and {_LEAST_RING_CHANGE_M:.0f} m",
            where=culprit.id,
            hint="Make the roundabout larger.",
        )
    theirs = {piece.road.id for piece in victim.laid.stretches}
    end_m = ([end for end in usable if rooms[end][1].id in theirs] or usable)[-1]
    length = min(rooms[end_m][0], change_length_m(culprit.cruise_mps, ABRUPT_LANE_CHANGE_S))
    end_s = culprit.laid.path_s_m(end_m)
    target = scene.road.ring_lanes if goes_outwards(scene, culprit) else 1
    move_aside(scene, culprit, target, ends_m=end_m, over_m=length, hazard=kind)
    pose = culprit.laid.path.pose(end_s)
    place, apart = nearest_s_m(victim.laid.path, pose.x_m, pose.y_m)
    return [] if apart > _SAME_LINE_M else [close_before(scene, culprit, victim, end_s, place)]


def come_into_lane(
    scene: Setup, draft: DriveDraft, other: DriveDraft | None, kind: HazardKind | None = None
) -> list[Meeting]:
    """Change lanes: into another's, close before it, or into the one that leads on."""
    draft.entry_lane, target = _start_and_target(scene, draft, other)
    seconds = LANE_CHANGE_S if kind is None else ABRUPT_LANE_CHANGE_S
    length = change_length_m(draft.cruise_mps, seconds)
    act = scene.first_act(draft.id, ActKind.CHANGE_LANE)
    if act is not None and kind is not None:
        width_m = scene.functional.junction.lanes_wide_m
        length = draft.cruise_mps * lasting_s(act, width_m, length / draft.cruise_mps)
    end = over_by_m(draft, other)
    move_aside(scene, draft, target, ends_m=end, over_m=length, hazard=kind)
    return [] if other is None else [close_before(scene, draft, other, draft.laid.path_s_m(end))]


def _start_and_target(scene: Setup, draft: DriveDraft, other: DriveDraft | None) -> tuple[int, int]:
    """The lane that one leaves and the one that it comes into: as they drive, or on the side said.

    Where nothing is said, one comes from the inside, a rider from the kerb.
    """
    own, count = draft.entry_lane, scene.lanes_in(draft)
    lanes = [*scene.entry_lanes(draft)]
    outward = False
    if other is None:
        target = own if own in lanes else lanes[0]
        taking = [each for each in scene.drives.values() if each.drive.beside == draft.id]
    else:
        lanes = [lane for lane in lanes if lane in scene.entry_lanes(other)]
        if not lanes:
            raise MotionInfeasibleError(
                f"no lane of arm {draft.drive.entry} leads both {draft.id} and {other.id} where "
                "they go",
                where=draft.id,
            )
        if abs(own - other.entry_lane) == 1 and other.entry_lane in lanes:
            return own, other.entry_lane
        said = is_outward(scene.functional, draft.id, other.id)
        inner = [lane for lane in lanes if lane < count]
        outward = bool(inner) and (draft.kind is ParticipantKind.BICYCLE if said is None else said)
        target, taking = (inner if outward else lanes)[0], [other]
    start = target - 1 if target > 1 and not outward else target + 1
    if start > count:
        raise MotionInfeasibleError(
            f"arm {draft.drive.entry} has one lane: there is no lane to change into",
            where=draft.id,
        )
    for each in taking:  # who travels beside it is in the lane that it wants
        if target in scene.entry_lanes(each):
            each.take_lane(scene.network, target)
    return start, target


def close_before(
    scene: Setup,
    draft: DriveDraft,
    other: DriveDraft,
    place_s_m: float,
    other_s_m: float | None = None,
) -> Meeting:
    """At a place of its way, one is close before another; one who is much faster brakes late.

    ``other_s_m`` is the same place on the other's way, if that differs.
    """
    there = place_s_m if other_s_m is None else other_s_m
    closing = other.course.speed_at(there) - draft.course.speed_at(place_s_m)
    if closing < _MUCH_FASTER_MPS:
        headway = float(scene.rng.uniform(*CUT_IN_HEADWAY_S))
        gap = headway * other.cruise_mps
        reason = f"comes into its lane {headway:.2f} s ahead"
    else:
        gap = _GAP_M + closing**2 / (2 * LATE_BRAKING_MPS2)
        reason = f"comes up behind {draft.id}"
    met = max(0.0, there - gap - draft.body.rear_m - other.body.front_m)
    return Meeting(STRUCTURAL, draft.id, other.id, place_s_m, met, 0.0, reason)


def _out_and_back(
    scene: Setup, draft: DriveDraft, along: list[DriveDraft], kind: HazardKind
) -> list[Meeting]:
    """Out of the lane and back: as is said, else towards who suffers it, close before it."""
    act, stays_m = scene.first_act(draft.id, ActKind.SWERVE), _STAYS_M
    beside = next((o for o in along if abs(o.entry_lane - draft.entry_lane) == 1), None)
    width = act.lateral_m.middle if act is not None and act.lateral_m is not None else 0.0
    aside = draft.entry_lane
    usual = max(8.0 / draft.cruise_mps, ABRUPT_LANE_CHANGE_S)
    if kind is HazardKind.ONCOMING_LANE:
        draft.entry_lane, aside, width = min(scene.entry_lanes(draft)), 0, 0.0
        act, stays_m = None, _STAYS_ASTRAY_S * draft.cruise_mps
        if not scene.kinds_by(draft.id) & _ABRUPT:
            usual = LANE_CHANGE_S
    elif not width and act is not None and act.side is not None:
        aside += outward(scene.functional, act.side)
        if aside > scene.lanes_in(draft):
            # Towards the kerb, where there is no lane: as far as its own one lets it.
            aside, width, usual = draft.entry_lane, _IN_LANE_M, _IN_LANE_S
    elif not width and beside is not None:
        aside = beside.entry_lane
    elif not width:
        aside = neighbour_lane(scene, draft, oncoming=not scene.ring)
    offset = width if act is not None and act.side is Side.LEFT else -width
    over_m = width or scene.functional.junction.lanes_wide_m
    length = draft.cruise_mps * (usual if act is None else lasting_s(act, over_m, usual))
    out = move_aside(
        scene,
        draft,
        aside,
        ends_m=over_by_m(draft),
        over_m=length,
        stays_m=stays_m,
        hazard=kind,
        offset_m=offset,
    )
    if beside is None or beside.entry_lane != aside:
        return []
    return [close_before(scene, draft, beside, draft.laid.path_s_m(out + length))]


def brake_out_of_control(scene: Setup) -> None:
    """Loss of control ends in hard braking to walking pace."""
    kind = HazardKind.LOSS_OF_CONTROL
    for draft in (each for hazard in scene.of_kind(kind) for each in culprits(scene, hazard)):
        for change in draft.lane_changes[-1:]:
            rate = draft.braking_mps2(HARD_BRAKING_MPS2[0])
            place = draft.laid.path_s_m(change.position_m)
            draft.hold(SpeedChange(2.0, rate, s_m=place, hazard=kind), 1.0)
