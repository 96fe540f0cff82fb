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
from scegen.concretization.hazards.parties import ahead_on_arm, culprits, same_arm, victims
from scegen.concretization.limits import (
    ABRUPT_LANE_CHANGE_S,
    HARD_BRAKING_MPS2,
    LANE_CHANGE_S,
)
from scegen.concretization.meetings import DANGER, STRUCTURAL, Meeting, drives_meet
from scegen.concretization.passing import (
    change_length_m,
    close_before,
    move_aside,
    neighbour_lane,
    over_by_m,
    pass_drive,
)
from scegen.concretization.profile import SpeedChange
from scegen.concretization.setup import Setup
from scegen.concretization.stationary import blocking_m, goes_round_a_thing
from scegen.concretization.tale import SIDEWAYS, outward
from scegen.concretization.turning_ways import is_outward
from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import is_ring
from scegen.scenario.acts import ActKind
from scegen.scenario.vocabulary import HazardKind, Maneuver, ParticipantKind, Side

_STAYS_M, _STAYS_ASTRAY_S = 1.0, 2.0
_IN_LANE_M, _IN_LANE_S = 0.85, 0.75
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


def goes_outwards(scene: Setup, draft: DriveDraft) -> bool:
    """Whether it changes from the inner ring lane to the outer one, as towards an exit.

    Else whom it cuts in on is inside.
    """
    side = draft.drive.changes_to
    return side is None or outward(scene.functional, side) > 0


def leave_lanes(scene: Setup) -> list[Meeting]:
    """The moves to the side that dangers and manoeuvres ask for, and the meetings that they need.

    One that leaves its lane for a danger already does all in one.
    """
    meetings: list[Meeting] = []
    for kind in _ASIDE:
        for hazard in scene.of_kind(kind):
            for draft in culprits(scene, hazard):
                if not draft.lane_changes:
                    others = victims(scene, hazard, draft)
                    meetings += _leave_lane(scene, draft, others, kind)
    moves = [m for d in scene.drives.values() if not d.lane_changes for m in _manoeuvre(scene, d)]
    return [*meetings, *moves, *_side_by_side(scene, moves)]


def _leave_lane(
    scene: Setup, draft: DriveDraft, others: list[DriveDraft], kind: HazardKind
) -> list[Meeting]:
    along = [other for other in others if same_arm(draft, other)]
    if kind is HazardKind.CUT_IN and scene.ring:
        return _in_ring(scene, draft, others[0], kind) if others else []
    if kind is HazardKind.CUT_IN:
        wide = along and scene.lanes_in(draft) > 1
        return _come_into_lane(scene, draft, along[0], kind) if wide else []
    if kind is HazardKind.ONCOMING_LANE and blocking_m(scene, draft):
        return []  # it strays round that one
    heading = draft.laid.path.heading_rad
    if kind is HazardKind.SUDDEN_TURN and abs(heading - heading[0]).max() > _BEND_RAD:
        return []  # it turns; where there is no bend, it turns the wheel all the same
    return _out_and_back(scene, draft, along, kind)


def _manoeuvre(scene: Setup, draft: DriveDraft) -> list[Meeting]:
    """Past the one ahead on its arm, the one that the text calls slow or the nearest.

    Else into a lane beside; who overtakes as a danger does so, too.
    """
    changes = draft.drive.maneuver in SIDEWAYS
    overtakes = HazardKind.OVERTAKING in scene.kinds_by(draft.id)
    if not (changes or overtakes):
        return []
    ahead = [other for other in ahead_on_arm(scene, draft) if other.drive.beside is None]
    ahead = [other for other in ahead if other.drive.reverses is None]
    slow = [other for other in ahead if HazardKind.SLOW_DRIVING in scene.kinds_by(other.id)]
    if ahead:
        comes_back = overtakes or draft.drive.maneuver is Maneuver.OVERTAKE
        return pass_drive(scene, draft, (slow or ahead)[-1], comes_back=comes_back)
    return _free_change(scene, draft) if changes and not _has_cause(scene, draft) else []


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
    target = scene.road.ring_lanes if goes_outwards(scene, culprit) else 1
    move_aside(scene, culprit, target, ends_m=end_m, over_m=length, hazard=kind)
    return close_before(scene, culprit, [victim], end_m)


def _come_into_lane(
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
    return close_before(scene, draft, [] if other is None else [other], end)


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
    return close_before(scene, draft, [] if beside is None else [beside], out + length)


def brake_out_of_control(scene: Setup) -> None:
    """Loss of control ends in hard braking to walking pace."""
    kind = HazardKind.LOSS_OF_CONTROL
    for draft in (each for hazard in scene.of_kind(kind) for each in culprits(scene, hazard)):
        for change in draft.lane_changes[-1:]:
            rate = draft.braking_mps2(HARD_BRAKING_MPS2[0])
            place = draft.laid.path_s_m(change.position_m)
            draft.hold(SpeedChange(2.0, rate, s_m=place, hazard=kind), 1.0)


def _has_cause(scene: Setup, draft: DriveDraft) -> bool:
    """Whether it goes round what stands or lies in its lane, or "overtakes" without leaving it.

    That is who passes one that is parked beside the lanes, or one that reverses into its way.
    """
    arms = {draft.drive.entry, draft.drive.exit}
    standing = {s.standing.in_lane for s in scene.stands.values() if s.standing.arm in arms}
    past = False in standing
    past |= any(other.drive.reverses is not None for other in ahead_on_arm(scene, draft))
    stays = past and draft.drive.maneuver is Maneuver.OVERTAKE
    return stays or True in standing or goes_round_a_thing(scene, draft)


def _free_change(scene: Setup, draft: DriveDraft) -> list[Meeting]:
    """A change into the lane of one beside it, rather the ego's, or into the one that leads on."""
    if scene.lanes_in(draft) < 2 and draft.drive.maneuver is Maneuver.OVERTAKE:
        raise MotionInfeasibleError(
            f"nobody is ahead of it on arm {draft.drive.entry} whom it could overtake",
            where=draft.id,
            hint="Let another vehicle enter on that arm before it, or let it drive straight on.",
        )
    near = [
        other
        for other in scene.drives.values()
        if (other.id == draft.drive.beside or other.drive.beside == draft.id)
        and same_arm(other, draft)
        and abs(other.entry_lane - draft.entry_lane) == 1
        and other.entry_lane in scene.entry_lanes(draft)
        and not other.lane_changes
    ]
    beside = max(near, key=lambda other: other is scene.ego, default=None)
    return _come_into_lane(scene, draft, beside)


def _side_by_side(scene: Setup, meetings: list[Meeting]) -> list[Meeting]:
    """Those who travel beside another are level with it half way along the arm.

    Where one turns across the other, they are so there.
    """
    arranged = {frozenset((m.first, m.second)) for m in meetings}
    found = []
    # The second in the same lane drives in a line with the first.
    taken: set[tuple[str, int]] = set()
    for draft in scene.drives.values():
        beside = scene.drives.get(draft.drive.beside or "")
        if beside is None or not same_arm(draft, beside):
            continue
        if frozenset((beside.id, draft.id)) in arranged or (beside.id, draft.entry_lane) in taken:
            continue
        taken.add((beside.id, draft.entry_lane))
        point = drives_meet(beside, draft)
        place = draft.junction_s_m * 0.6
        priority, places, words = STRUCTURAL + 1, (place, place), "side by side"
        if point is not None:
            priority, places = DANGER, (point.first_s_m, point.second_s_m)
            words += ", one turns across the other"
        found.append(Meeting(priority, beside.id, draft.id, *places, 0.0, words))
    return found
