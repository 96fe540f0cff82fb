"""What a logical scenario lists: arms of entry and exit, lanes, who is ahead and who beside."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import combinations

import numpy as np

from scegen.claims.arms import arms_of, off_lane_m
from scegen.claims.boxes import box_at, same_way, seen
from scegen.claims.claim import NEVER, Claim, ClaimKind, Judged, always
from scegen.claims.told import Told, either
from scegen.claims.tolerances import SAME_LANE_M, STANDS_MPS
from scegen.claims.view import View
from scegen.motion.batch.arrays import Bools
from scegen.scenario.logical import Drive
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


def claims(told: Told) -> Iterator[Claim]:
    """Of everybody's place and way."""
    for person in told.people:
        drive = told.drive(person.id)
        if person.lanes and drive is not None:
            lanes = tuple(sorted(person.lanes))
            yield Claim(
                id=f"lane.{person.id}",
                kind=ClaimKind.LANE,
                statement=f"{person.id} starts in lane {either([str(lane) for lane in lanes])}",
                field=f"participants.{person.id}.lanes",
                unit="m",
                test=partial(_lane, drive, lanes),
            )
        if drive is None or drive.reverses is not None:
            continue
        if not person.circulating:
            yield _entry(told, drive)
        if person.maneuvers != {Maneuver.STAY}:
            yield _exit(told, drive)
    for first, second in combinations(told.logical.drives, 2):
        if first.entry == second.entry and first.rank != second.rank:
            ahead, behind = sorted((first, second), key=lambda drive: drive.rank)
            moves = Maneuver.STAY not in {ahead.maneuver, behind.maneuver}
            if moves and ahead.reverses is None and behind.reverses is None:
                yield _order(ahead.participant, behind.participant)
    for drive in told.logical.drives:
        if drive.beside is not None:
            yield _beside(drive.participant, drive.beside)
    for crossing in told.logical.crossings:
        where = f"on the {crossing.start} of arm {crossing.arm}"
        yield Claim(
            id=f"entry.{crossing.participant}",
            kind=ClaimKind.ENTRY,
            statement=f"{crossing.participant} starts {where}",
            field=f"participants.{crossing.participant}.approaches",
            unit="m",
            test=partial(_start_side, crossing.participant, crossing.arm, crossing.start),
        )


def _entry(told: Told, drive: Drive) -> Claim:
    return Claim(
        id=f"entry.{drive.participant}",
        kind=ClaimKind.ENTRY,
        statement=f"{drive.participant} comes in on arm {drive.entry}",
        field=f"participants.{drive.participant}.entries",
        unit="m",
        test=partial(_comes_in, drive, _off_its_side(told, drive)),
    )


def _off_its_side(told: Told, drive: Drive) -> bool:
    """Whether it may be on the wrong side of the road: it is in a lane of who comes towards it."""
    name = drive.participant
    facing = {
        (spacing.participant, spacing.reference)
        for spacing in told.functional.spacings
        if spacing.measure in {Measure.OVERLAP_PERCENT, Measure.LATERAL_OFFSET_M}
    }
    others = {d.participant for d in told.logical.drives if d.entry != drive.entry}
    in_line = any(name in pair and others & {*pair} for pair in facing)
    return in_line or any(
        hazard.kind is HazardKind.ONCOMING_LANE and name in hazard.by for hazard in told.hazards
    )


def _comes_in(drive: Drive, off_its_side: bool, view: View) -> Judged:
    """On its arm at the start, heading in, on the side of the traffic that comes in."""
    arm = arms_of(view)[drive.entry]
    box = box_at(view, drive.participant, 0)
    along, offset = arm.place(box)
    # Out of the strip for parking, it starts beside the lanes; a lane's width is let pass.
    side = arm.inward * offset + arm.lane_width_m / 4
    if off_its_side:
        side = np.minimum(offset - arm.edges_m[0], arm.edges_m[1] - offset)
    inside = np.min([along + 1.0, arm.length_m + 1.0 - along, side], axis=0)
    margin = np.where(arm.facing(box) > _SAME_WAY, inside, -NEVER)
    return Judged(margin, along, np.zeros(view.count))


def _exit(told: Told, drive: Drive) -> Claim:
    does = _TURNS.get(drive.turn, "drives")
    plain_road = told.functional.junction.kind is JunctionKind.STRAIGHT
    leaves = "drives on" if plain_road and drive.turn is Maneuver.STRAIGHT else does
    return Claim(
        id=f"exit.{drive.participant}",
        kind=ClaimKind.EXIT,
        statement=f"{drive.participant} {leaves} and leaves by arm {drive.exit}",
        field=f"participants.{drive.participant}.maneuvers",
        unit="m",
        test=partial(_goes_out, told, drive),
        scale=20.0,
    )


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
    plain_road = told.functional.junction.kind is JunctionKind.STRAIGHT
    speed = view.speed_mps(name)[np.arange(view.count), last]
    excused = _touched(told, view, name) | (speed < STANDS_MPS)
    wrong = np.zeros(view.count, dtype=np.bool_)
    for number, arm in enumerate(arms):
        if number not in {drive.entry, drive.exit}:
            reached = arm.length_m - arm.place(box)[0]
            wrong |= (arm.facing(box) < -0.95) & (reached > 5.0) & (away > gone + 5.0)
    excused |= on_entry & plain_road
    margin = np.where(excused & ~wrong, np.maximum(margin, 0.0), margin)
    return Judged(margin, gone, view.time_of(last))


def _touched(told: Told, view: View, name: str) -> Bools:
    """Whether it was in a contact that is said."""
    hit = np.zeros(view.count, dtype=np.bool_)
    for other in view.index:
        if other != name and told.may_touch(name, other):
            hit |= ~np.isnan(view.of_pair("contact_s", name, other))
    return hit


def _lane(drive: Drive, lanes: tuple[int, ...], view: View) -> Judged:
    arm = arms_of(view)[drive.entry]
    box = box_at(view, drive.participant, 0)
    off = off_lane_m(arm, box, lanes, inwards=True)
    return Judged(arm.lane_width_m / 2 - off, off, np.zeros(view.count))


def _order(ahead: str, behind: str) -> Claim:
    return Claim(
        id=f"order.{ahead}.{behind}",
        kind=ClaimKind.ORDER,
        statement=f"{ahead} is on the arm ahead of {behind}",
        field=f"participants.{ahead}.approaches",
        unit="m",
        test=partial(_ahead, ahead, behind),
    )


def _ahead(ahead: str, behind: str, view: View) -> Judged:
    """In one lane by the free length between them; else by who is nearer to the junction."""
    frame = box_at(view, behind, 0)
    place = seen(frame, box_at(view, ahead, 0))
    free = place.rear - frame.half_length
    margin = np.where(np.abs(place.y) < SAME_LANE_M, free, place.x)
    return Judged(margin, free, np.zeros(view.count))


def _beside(name: str, other: str) -> Claim:
    return Claim(
        id=f"beside.{name}.{other}",
        kind=ClaimKind.BESIDE,
        statement=f"{name} is in the lane beside {other} at the start",
        field=f"participants.{name}.approaches",
        unit="m",
        test=partial(_in_lane_beside, name, other),
    )


def _in_lane_beside(name: str, other: str, view: View) -> Judged:
    frame, box = box_at(view, other, 0), box_at(view, name, 0)
    aside = np.abs(seen(frame, box).y)
    inside = np.minimum(aside - _ASIDE_M[0], _ASIDE_M[1] - aside)
    margin = np.where(same_way(frame, box) > _SAME_WAY, inside, -NEVER)
    return Judged(margin, aside, np.zeros(view.count))


def _start_side(name: str, arm_number: int, side: Side, view: View) -> Judged:
    """On its side of the arm's centre line, seen by traffic that comes in."""
    arms = arms_of(view)
    if arm_number >= len(arms):
        return always(view, holds=False)
    along, offset = arms[arm_number].place(box_at(view, name, 0))
    margin = offset if side is Side.LEFT else -offset
    margin = np.minimum(margin, np.minimum(along, arms[arm_number].length_m + 2.0 - along))
    return Judged(margin, offset, np.zeros(view.count))
