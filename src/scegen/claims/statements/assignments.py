"""What a logical scenario lists: arms of entry and exit, lanes, who is ahead and who beside."""

from collections.abc import Iterator
from functools import partial
from itertools import combinations

import numpy as np

from scegen.claims.arms import arms_of
from scegen.claims.boxes import box_at, boxes, same_way, seen, to_side
from scegen.claims.claim import NEVER, Claim, ClaimKind, Judged, Test, always
from scegen.claims.series import at
from scegen.claims.statements.touching import touched
from scegen.claims.told import Told, either
from scegen.claims.tolerances import SAME_LANE_M, STANDS_MPS
from scegen.claims.view import View
from scegen.measures.nearest import least_gap_m
from scegen.motion.batch.arrays import Bools
from scegen.scenario.logical import Assignment, ConflictKind, Crossing, Drive, Heading, Walking
from scegen.scenario.roadway import Carriageway
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import HazardKind, JunctionKind, Maneuver, Side

_SAME_WAY = 0.7
_ASIDE_M = (1.0, 8.0)
_TURNS = {
    Maneuver.LEFT: "turns left",
    Maneuver.RIGHT: "turns right",
    Maneuver.U_TURN: "turns back",
    Maneuver.STRAIGHT: "goes straight on",
}
_POINTS, _BETWEEN_M = 160, 1.0
"""Of a way that are looked at, to find where it crosses another; what lies between them."""


def claims(told: Told) -> Iterator[Claim]:
    """Of everybody's place and way."""
    for assignment in told.logical.assignments:
        if isinstance(assignment, Drive):
            yield from _driven(told, assignment)
        else:
            yield from _beside_the_lanes(assignment)
    for one, other in combinations(told.logical.drives, 2):
        if one.entry == other.entry and one.rank != other.rank:
            ahead, behind = sorted((one, other), key=lambda drive: drive.rank)
            moves = Maneuver.STAY not in {ahead.maneuver, behind.maneuver}
            forwards = ahead.reverses is None and behind.reverses is None
            apart = None not in {one.lane, other.lane} and one.lane != other.lane
            if moves and forwards and not apart:
                kind, name = ClaimKind.ORDER, f"{ahead.participant}.{behind.participant}"
                does = f"{ahead.participant} is on the arm ahead of {behind.participant}"
                test: Test = partial(_ahead, ahead.participant, behind.participant)
                yield _claim(kind, name, does, ahead, "approaches", test)
    for met in told.logical.conflicts:
        drives = [told.drive(name) for name in (met.first, met.second)]
        if met.kind is ConflictKind.CROSSING and all(d and not d.reverses for d in drives):
            name = f"{met.first}.{met.second}"
            does = f"the ways of {met.first} and {met.second} cross"
            test = partial(_cross, told, met.first, met.second)
            of = told.logical.assignment(met.second)
            yield _claim(ClaimKind.CONFLICT, name, does, of, "maneuvers", test)


def _claim(
    kind: ClaimKind,
    name: str,
    statement: str,
    of: Assignment,
    part: str,
    test: Test,
    unit: str = "m",
) -> Claim:
    field = f"participants.{of.participant}.{part}"
    fixed = kind is not ClaimKind.ORDER
    return Claim(f"{kind}.{name}", kind, statement, field, unit, test, fixed=fixed)


def _driven(told: Told, drive: Drive) -> Iterator[Claim]:
    """The lane, who is beside, the arms by which it comes and leaves."""
    name = drive.participant
    person = told.functional.participant(name)
    lanes = tuple(sorted(person.lanes)) if drive.lane is None else (drive.lane,)
    if person.lanes:
        does = f"{name} starts in lane {either([str(lane) for lane in lanes])}"
        divided = told.functional.junction.carriageway is not Carriageway.UNDIVIDED
        side = -1.0 if divided and name in _astray(told) else 1.0  # nobody crosses a median
        yield _claim(ClaimKind.LANE, name, does, drive, "lanes", partial(_lane, drive, lanes, side))
    if drive.beside is not None:
        on = f" on its {drive.beside_on}" if drive.beside_on else ""
        does = f"{name} is in the lane beside {drive.beside}{on} at the start"
        test = partial(_in_lane_beside, name, drive.beside, drive.beside_on)
        yield _claim(ClaimKind.BESIDE, f"{name}.{drive.beside}", does, drive, "approaches", test)
    if drive.reverses is not None:
        return
    if drive.circulating:
        for other in _who_come_later(told, name):
            does = f"{name} is in the ring before {other.participant} is"
            test = partial(_in_the_ring, drive, other)
            who = f"ring.{name}.{other.participant}"
            yield _claim(ClaimKind.ORDER, who, does, drive, "circulating", test, "s")
    else:
        does = f"{name} comes in on arm {drive.entry}"
        test = partial(_comes_in, drive, _off_its_side(told, drive))
        yield _claim(ClaimKind.ENTRY, name, does, drive, "entries", test)
    if person.maneuvers != {Maneuver.STAY}:
        straight = told.plain_road and drive.turn is Maneuver.STRAIGHT
        leaves = "drives on" if straight else _TURNS.get(drive.turn, "drives")
        does = f"{name} {leaves} and leaves by arm {drive.exit}, if nothing holds it up"
        test = partial(_goes_out, told, drive)
        yield _claim(ClaimKind.EXIT, name, does, drive, "maneuvers", test)


def _who_come_later(told: Told, name: str) -> list[Drive]:
    """Those who are not in the ring already as one is: the ego, of the ego those whom it meets."""
    met = told.concerned_by(name) if name == told.ego else {told.ego}
    return [d for d in told.logical.drives if d.participant in met and not d.circulating]


def _beside_the_lanes(other: Assignment) -> Iterator[Claim]:
    """The arm and the side of it on which somebody stands, walks or begins to cross."""
    if isinstance(other, Drive):
        return
    name = other.participant
    side = other.start if isinstance(other, Crossing) else other.side
    test = partial(_start_side, name, other.arm, side)
    does = f"{name} starts on the {side} of arm {other.arm}"
    yield _claim(ClaimKind.ENTRY, name, does, other, "approaches", test)
    if isinstance(other, Walking):
        test = partial(_walks, name, other.arm, other.heading)
        does = f"{name} walks along arm {other.arm}, {other.heading}"
        yield _claim(ClaimKind.EXIT, name, does, other, "maneuvers", test)


def _astray(told: Told) -> set[str]:
    """Who is said to drive on the wrong side."""
    return {n for h in told.hazards if h.kind is HazardKind.ONCOMING_LANE for n in h.by}


def _off_its_side(told: Told, drive: Drive) -> bool:
    """Whether it may be on the wrong side of the road.

    It is said to drive there, or one of two who face each other in one line is, and not which.
    """
    wrong = _astray(told)
    others = {d.participant for d in told.logical.drives if d.entry != drive.entry} - wrong
    name = drive.participant
    return name in wrong or any(
        name in pair and others & {*pair}
        for spacing in told.functional.spacings
        if spacing.measure in {Measure.OVERLAP_PERCENT, Measure.LATERAL_OFFSET_M}
        for pair in [(spacing.participant, spacing.reference)]
        if spacing.participant != spacing.reference
    )


def _reach_m(view: View, arm: int) -> float:
    """How far from its outer end an arm reaches; a road without a junction is one road."""
    arms = arms_of(view)
    plain = view.concrete.road.kind is JunctionKind.STRAIGHT
    return sum(each.length_m for each in arms) if plain else arms[arm].length_m


def _comes_in(drive: Drive, off_its_side: bool, view: View) -> Judged:
    """On its arm at the start, heading in, on the side of the traffic that comes in."""
    arm = arms_of(view)[drive.entry]
    ends_m = _reach_m(view, drive.entry)
    box = box_at(view, drive.participant, 0)
    along, offset = arm.place(box)
    # Out of the strip for parking, it starts beside the lanes; a lane's width is let pass.
    side = arm.inward * offset + arm.lane_width_m / 4
    if off_its_side:
        side = np.minimum(offset - arm.edges_m[0], arm.edges_m[1] - offset)
    inside = np.min([along + 1.0, ends_m + 1.0 - along, side], axis=0)
    margin = np.where(arm.facing(box) > _SAME_WAY, inside, -NEVER)
    return Judged(margin, along, np.zeros(view.count))


def _in_the_ring(drive: Drive, ego: Drive, view: View) -> Judged:
    """How long before the ego it comes in; it does, and an ego that never does comes last."""
    own, others = (
        view.time_of(arm.comes_to(view, one.participant, arm.length_m))
        for one, arm in ((one, arms_of(view)[one.entry]) for one in (drive, ego))
    )
    never = own >= view.time_of(np.full(view.count, view.steps))
    return Judged(np.where(never, -NEVER, others - own), others - own, own)


def _goes_out(told: Told, drive: Drive, view: View) -> Judged:
    """On its exit arm in the end; before it only where it stands, or has been hit.

    One that is still on a road without a junction goes the right way.
    """
    name = drive.participant
    arms = arms_of(view)
    entry, leaving = arms[drive.entry], arms[drive.exit]
    last = view.last_step
    box = box_at(view, name, last)
    along, _ = entry.place(box)
    back, _ = leaving.place(box)
    gone = leaving.length_m - back
    away = np.hypot(
        box.x - (leaving.x_m + leaving.length_m * leaving.cos),
        box.y - (leaving.y_m + leaving.length_m * leaving.sin),
    )
    out = leaving.facing(box) < -_SAME_WAY
    margin = np.where(out & (gone >= 0.0), gone, -np.minimum(away, NEVER))
    on_entry = (along <= entry.length_m) & (entry.facing(box) > _SAME_WAY)
    excused = _is_held_up(told, name, view)
    wrong = np.zeros(view.count, dtype=np.bool_)
    for number, arm in enumerate(arms):
        if number not in {drive.entry, drive.exit}:
            reached = arm.length_m - arm.place(box)[0]
            wrong |= (arm.facing(box) < -0.95) & (reached > 5.0) & (away > gone + 5.0)
    excused = (excused | (on_entry & told.plain_road)) & ~wrong
    margin = np.where(excused, np.maximum(margin, 0.0), margin)
    return Judged(margin, np.where(excused & (gone < 0.0), np.nan, gone), view.time_of(last))


def _is_held_up(told: Told, name: str, view: View) -> Bools:
    """Whether it has been hit as is said, or stands in the end (c,)."""
    stands = at(view.speed_mps(name), view.last_step) < STANDS_MPS
    return touched(told, view, name) | stands


def _lane(drive: Drive, lanes: tuple[int, ...], side: float, view: View) -> Judged:
    """Counted from the middle of the road, on its own ``side`` (1) or on the other (-1)."""
    arm = arms_of(view)[drive.entry]
    box = box_at(view, drive.participant, 0)
    offset = side * arm.place(box)[1]
    off = np.min([np.abs(offset - arm.lane_in_m(number)) for number in lanes], axis=0)
    return Judged(arm.lane_width_m / 2 - off, off, np.zeros(view.count))


def _ahead(ahead: str, behind: str, view: View) -> Judged:
    """In one lane by the free length between them; else by who is nearer to the junction."""
    frame = box_at(view, behind, 0)
    place = seen(frame, box_at(view, ahead, 0))
    free = place.rear - frame.half_length
    margin = np.where(np.abs(place.y) < SAME_LANE_M, free, place.x)
    return Judged(margin, free, np.zeros(view.count))


def _in_lane_beside(name: str, other: str, side: Side | None, view: View) -> Judged:
    frame, box = box_at(view, other, 0), box_at(view, name, 0)
    aside = to_side(side, seen(frame, box).y)
    inside = np.minimum(aside - _ASIDE_M[0], _ASIDE_M[1] - aside)
    margin = np.where(same_way(frame, box) > _SAME_WAY, inside, -NEVER)
    return Judged(margin, aside, np.zeros(view.count))


def _start_side(name: str, arm_number: int, side: Side, view: View) -> Judged:
    """On its side of the arm's centre line, seen by traffic that comes in."""
    arms = arms_of(view)
    if arm_number >= len(arms):
        return always(view, holds=False)
    along, offset = arms[arm_number].place(box_at(view, name, 0))
    beyond_m = _reach_m(view, arm_number) + 2.0 - along
    margin = np.min([to_side(side, offset), along, beyond_m], axis=0)
    return Judged(margin, offset, np.zeros(view.count))


def _walks(name: str, arm_number: int, heading: Heading, view: View) -> Judged:
    """How far it has come along the arm in the end, the way that it is to go."""
    along, _ = arms_of(view)[arm_number].place(boxes(view, name))
    gone = at(along, view.last_step) - along[:, 0]
    gone = gone if heading is Heading.INWARD else -gone
    return Judged(gone, gone, view.time_of(view.last_step))


def _cross(told: Told, first: str, second: str, view: View) -> Judged:
    """Whether two, each at a time of its own, come over the same ground; who stays may not."""
    sparse = slice(None, None, max(1, view.steps // _POINTS))
    a, b = boxes(view, first), boxes(view, second)
    reach = a.half_width + b.half_width + _BETWEEN_M
    apart = np.empty(view.count)
    x, y, its_x, its_y = (np.ascontiguousarray(p[:, sparse]) for p in (a.x, a.y, b.x, b.y))
    for c in range(view.count):
        apart[c] = least_gap_m(x[c], y[c], its_x[c], its_y[c], 0.0)
    margin = reach - apart
    if margin.min() < 0.0:
        for name in (first, second):
            excused = _is_held_up(told, name, view)
            margin = np.where(excused, np.maximum(margin, 0.0), margin)
    return Judged(margin, apart, np.zeros(view.count))
