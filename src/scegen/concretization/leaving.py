"""Who leaves its lane at a junction: for a danger, or because that is its manoeuvre.

One mechanism serves both. The lane is the one that is said, that of who suffers it, or the free
one; and who comes into another's lane is close before it then. In a ring a cut-in crosses to the
outer lane just before its exit, or to the inner one, in which it is then that both go; between ways
that enter on different arms it is one vehicle turning in front of another: they meet.
"""

from __future__ import annotations

from scegen.concretization.aside import (
    AHEAD_M,
    BEHIND_M,
    change_length_m,
    close_before,
    move_aside,
    neighbour_lane,
    over_by_m,
)
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.encounters import ahead_on_arm, culprits, same_arm, victims
from scegen.concretization.limits import ABRUPT_LANE_CHANGE_S, LANE_CHANGE_S
from scegen.concretization.meetings import STRUCTURAL, Meeting
from scegen.concretization.setup import Setup
from scegen.concretization.stationary import blocking_m
from scegen.concretization.tale import SIDEWAYS, changes_before_turning, outward
from scegen.concretization.turning_ways import is_outward
from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import is_ring
from scegen.scenario.acts import ActKind
from scegen.scenario.vocabulary import HazardKind, Maneuver, Side

_FASTER = 1.5
"""One who overtakes drives this much faster than the one overtaken (own choice)."""
_STAYS_M, _STAYS_ASTRAY_S = 1.0, 2.0
_IN_LANE_M, _IN_LANE_S = 0.85, 0.75
_BEND_RAD = 0.35
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
        return _in_ring(scene, draft, others[0]) if others else []
    if kind is HazardKind.CUT_IN:
        wide = along and scene.lanes_in(draft) > 1
        return _come_into_lane(scene, draft, along[0], kind) if wide else []
    if kind is HazardKind.ONCOMING_LANE and blocking_m(scene, draft):
        return []  # it strays round that one
    heading = draft.path.heading_rad
    if kind is HazardKind.SUDDEN_TURN and abs(heading - heading[0]).max() > _BEND_RAD:
        return []  # it turns; where there is no bend, it turns the wheel all the same
    return _out_and_back(scene, draft, along, kind)


def _in_ring(scene: Setup, draft: DriveDraft, other: DriveDraft) -> list[Meeting]:
    least_m = _LEAST_RING_CHANGE_M + 2 * _RING_MARGIN_M
    ring = [piece for piece in draft.laid.stretches if is_ring(piece.road)]
    usable = [piece for piece in ring if piece.end_m - piece.start_m >= least_m]
    if not usable or scene.road.ring_lanes < 2:
        raise MotionInfeasibleError(
            "no ring road between two arms on its way is long enough; a change of ring lane needs "
            f"two ring lanes and {_LEAST_RING_CHANGE_M:.0f} m",
            where=draft.id,
            hint="Make the roundabout larger.",
        )
    theirs = {piece.road.id for piece in other.laid.stretches}
    piece = ([piece for piece in usable if piece.road.id in theirs] or usable)[-1]
    end_m = piece.end_m - _RING_MARGIN_M
    room_m = end_m - piece.start_m - _RING_MARGIN_M
    length = min(room_m, change_length_m(draft, ABRUPT_LANE_CHANGE_S))
    lane = scene.road.ring_lanes if goes_outwards(scene, draft) else 1
    move_aside(scene, draft, lane, ends_m=end_m, over_m=length, hazard=HazardKind.CUT_IN)
    return close_before(scene, draft, other, end_m)


def _come_into_lane(
    scene: Setup, draft: DriveDraft, other: DriveDraft | None, kind: HazardKind | None = None
) -> list[Meeting]:
    """Change lanes: into another's, close before it, or into the one that leads on."""
    draft.entry_lane, target = _start_and_target(scene, draft, other)
    usual = LANE_CHANGE_S if kind is None else ABRUPT_LANE_CHANGE_S
    act = scene.first_act(draft.id, ActKind.CHANGE_LANE)
    length = change_length_m(draft, usual, act, scene.functional.junction.lanes_wide_m)
    end = over_by_m(*(each for each in (draft, other) if each is not None))
    there = move_aside(scene, draft, target, ends_m=end, over_m=length, hazard=kind)
    return [] if other is None else close_before(scene, draft, other, there)


def _start_and_target(scene: Setup, draft: DriveDraft, other: DriveDraft | None) -> tuple[int, int]:
    """The lane that one leaves and the one that it comes into: as they drive, or on the side said.

    Where nothing is said, one comes from the inside.
    """
    wanted = (other or draft).entry_lane
    both = [each for each in (draft, other) if each is not None]
    pairs = [
        (start, target)
        for target in scene.entry_lanes(draft)
        for start in (target - 1, target + 1)
        if 1 <= start <= scene.lanes_in(draft)
        and all(target in scene.entry_lanes(each) for each in both)
    ]
    if not pairs:
        raise MotionInfeasibleError(
            f"no two lanes of arm {draft.drive.entry} lie beside each other of which one leads "
            f"{' and '.join(each.id for each in both)} where they go",
            where=draft.id,
        )
    said = is_outward(scene.functional, draft.id, other.id) if other is not None else None
    if said is None and draft.drive.changes_to is not None:
        said = outward(scene.functional, draft.drive.changes_to) < 0
    now = draft.entry_lane, wanted
    start, target = min(pairs, key=lambda p: (p != now, (p[0] > p[1]) != said, p[1] != wanted))
    if other is not None:
        other.take_lane(scene.network, target)
    return start, target


def _out_and_back(
    scene: Setup, draft: DriveDraft, along: list[DriveDraft], kind: HazardKind
) -> list[Meeting]:
    """Out of the lane and back: as is said, else towards who suffers it, close before it."""
    act, stays_m, aside = scene.first_act(draft.id, ActKind.SWERVE), _STAYS_M, draft.entry_lane
    beside = next((o for o in along if abs(o.entry_lane - draft.entry_lane) == 1), None)
    width = act.lateral_m.middle if act is not None and act.lateral_m is not None else 0.0
    usual = ABRUPT_LANE_CHANGE_S
    if kind is HazardKind.ONCOMING_LANE:
        draft.entry_lane, aside, width = min(scene.entry_lanes(draft)), 0, 0.0
        act, stays_m = None, _STAYS_ASTRAY_S * draft.speed_mps
    elif width:
        pass  # within its lane
    elif act is not None and act.side is not None:
        aside += outward(scene.functional, act.side)
        if aside > scene.lanes_in(draft):
            # Towards the kerb, where there is no lane: as far as its own one lets it.
            aside, width, usual = draft.entry_lane, _IN_LANE_M, _IN_LANE_S
    elif beside is not None:
        aside = beside.entry_lane
    else:
        aside = neighbour_lane(scene, draft, oncoming=not scene.ring)
    offset = width if act is not None and act.side is Side.LEFT else -width
    length = change_length_m(draft, usual, act, width or scene.functional.junction.lanes_wide_m)
    there = move_aside(
        scene,
        draft,
        aside,
        ends_m=over_by_m(draft),
        over_m=length,
        stays_m=stays_m,
        hazard=kind,
        offset_m=offset,
    )
    into = beside is not None and beside.entry_lane == aside
    return close_before(scene, draft, beside, there) if beside is not None and into else []


def shape_maneuvers(scene: Setup) -> list[Meeting]:
    """Lane changes and overtakes of those who have none yet, and the meetings they need.

    Who overtakes as a danger does so, too. Who "overtakes" one that is parked beside the lanes, or
    that reverses into its way, stays in its lane.
    """
    meetings: list[Meeting] = []
    for draft in scene.drives.values():
        overtakes = HazardKind.OVERTAKING in scene.kinds_by(draft.id)
        maneuver = Maneuver.OVERTAKE if overtakes else draft.drive.maneuver
        if not draft.lane_changes and changes_before_turning(scene.functional, draft.drive):
            meetings += _free_change(scene, draft)
        if draft.lane_changes or maneuver not in SIDEWAYS:
            continue
        comes_back = maneuver is Maneuver.OVERTAKE
        ahead = ahead_on_arm(scene, draft)
        goes_round = [o for o in ahead if o.drive.beside is None and o.drive.reverses is None]
        slow = [o for o in goes_round if HazardKind.SLOW_DRIVING in scene.kinds_by(o.id)]
        if goes_round:
            meetings += _pass(scene, draft, (slow or goes_round)[-1], comes_back=comes_back)
            continue
        arms = {draft.drive.entry, draft.drive.exit}
        past = any(s.motion.arm in arms for s in scene.stands.values()) or bool(ahead)
        if draft.drive.maneuver in SIDEWAYS and not (past and comes_back):
            meetings += _free_change(scene, draft)
    return meetings


def _pass(
    scene: Setup, passer: DriveDraft, passed: DriveDraft, *, comes_back: bool
) -> list[Meeting]:
    """``passer`` overtakes ``passed`` on their entry arm, which is slower unless its speed is said.

    Returns the meeting side by side.

    Raises:
        NeedsLongerArms: the arm is too short for it.
    """
    if passer.speed_mps < passed.speed_mps * _FASTER:
        told, too = scene.has_said_speed(passer.id), scene.has_said_speed(passed.id)
        if too and not told:
            faster = min(passed.speed_mps * _FASTER, passer.body.top_speed_mps)
            _goes_at(scene, passer, faster, f"overtakes {passed.id}")
        elif not too or passer.speed_mps <= passed.speed_mps:
            _goes_at(scene, passed, passer.speed_mps / _FASTER, f"is overtaken by {passer.id}")
    strays = HazardKind.ONCOMING_LANE in scene.kinds_by(passer.id)
    if strays:
        passed.take_lane(scene.network, min(scene.entry_lanes(passed)))
    lanes = scene.entry_lanes(passer)
    if comes_back or passed.entry_lane in lanes:
        passer.entry_lane = passed.entry_lane
    aside = neighbour_lane(scene, passer, oncoming=strays or scene.lanes_in(passer) == 1)
    back = passer.entry_lane in lanes and (comes_back or aside not in lanes)
    per_m = passer.speed_mps / max(passer.speed_mps - passed.speed_mps, 1.0)
    half = (passer.body.length_m + passed.body.length_m) / 2
    before, after = per_m * (half + BEHIND_M), per_m * (half + AHEAD_M)
    ends, change = over_by_m(passer, passed), change_length_m(passer)
    middle = ends - after - change if back else ends
    stays = before + after if back else None
    over = ends if back else middle - before
    move_aside(scene, passer, aside, ends_m=over, over_m=change, stays_m=stays)
    level = middle + passer.body.centre_ahead_m - passed.body.centre_ahead_m
    return [Meeting(STRUCTURAL, passed.id, passer.id, level, middle, 0.0, "side by side")]


def _goes_at(scene: Setup, draft: DriveDraft, speed_mps: float, reason: str) -> None:
    scene.note(f"{draft.id}.speed_mps", speed_mps, reason, draft.speed_mps)
    draft.speed_mps = speed_mps


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
        and abs(other.entry_lane - draft.entry_lane) == 1
        and other.entry_lane in scene.entry_lanes(draft)
        and not other.lane_changes
    ]
    beside = max(near, key=lambda other: other is scene.ego, default=None)
    return _come_into_lane(scene, draft, beside)
