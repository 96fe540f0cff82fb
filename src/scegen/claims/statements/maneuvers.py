"""What somebody does on its way: turns, changes lane, overtakes, crosses, stands."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.arms import arms_of
from scegen.claims.boxes import boxes, passes
from scegen.claims.claim import NEVER, Claim, ClaimKind, Judged, Test, within
from scegen.claims.lateral import lateral_m
from scegen.claims.moments import at, first
from scegen.claims.statements.ramps import by_ramp
from scegen.claims.statements.touching import touched
from scegen.claims.told import KPH, Told, amount, either
from scegen.claims.tolerances import GAP_M, SAME_LANE_M, STANDS_MPS, TIME_S
from scegen.claims.view import View
from scegen.motion.batch.arrays import HEADING
from scegen.road.cross_section import CROSSWALK_WIDTH_M
from scegen.scenario.acts import LEAVING, LETS_BY, ActKind
from scegen.scenario.functional import Participant
from scegen.scenario.hazards import FROM_BESIDE, HAZARDS
from scegen.scenario.logical import Crossing, Drive
from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import (
    ON_FOOT,
    HazardKind,
    JunctionKind,
    Maneuver,
    Side,
)

STRAIGHT = JunctionKind.STRAIGHT
LANE_M = 2.0
"""Who goes so far to the side has changed lane."""
_TURNS_DEG, _BEGUN_DEG, _BACK_DEG = 15.0, 5.0, 140.0
_MOVES_M = 0.5


def claims(told: Told) -> Iterator[Claim]:
    """Of everybody of whom it is said."""
    for person in told.people:
        field = f"participants.{person.id}.maneuvers"
        drive, crossing = told.drive(person.id), told.crossing(person.id)
        if person.pulls_out:
            yield _stands(told, person, pulls_out=True)
        elif person.parked or person.maneuvers == {Maneuver.STAY}:
            yield _stands(told, person, pulls_out=False)
        if drive is not None and person.maneuvers:
            yield from _driven(told, drive, field)
            yield from by_ramp(person, drive, field)
        if drive is not None and _keeps_lane(told, drive):
            does = f"{person.id} keeps its lane" + (
                "" if told.functional.junction.kind is STRAIGHT else " up to the junction"
            )
            test = partial(_stays_in_lane, drive)
            yield _claim(f"lane.{person.id}", does, field, "m", test)
        crosses = crossing is not None and Maneuver.CROSS in person.maneuvers
        if crossing is not None and crosses and not _stops(told, person.id):
            yield _claim(
                f"cross.{person.id}",
                f"{person.id} crosses from one side of the road to the other",
                field,
                "m",
                partial(_crosses, told, crossing),
            )
            yield from _in_its_time(told, crossing)
        if crossing is not None:
            yield from _as_far(told, crossing)
        if crossing is not None and crossing.arm in told.functional.junction.crosswalks:
            does = f"{person.id} crosses on the crosswalk"
            test = partial(_on_crosswalk, crossing)
            yield _claim(f"crosswalk.{person.id}", does, "junction.crosswalks", "m", test)


def _keeps_lane(told: Told, drive: Drive) -> bool:
    """Whether nothing that is said lets it go sideways, nor somebody who stands in its way."""
    name = drive.participant
    person = told.functional.participant(name)
    moves = drive.changes_to or drive.reverses or drive.maneuver is not drive.turn
    if moves or drive.circulating or person.pulls_out or drive.turn is Maneuver.U_TURN:
        return False
    plain_road = told.functional.junction.kind is STRAIGHT
    beside = [h for h in told.hazards if plain_road and h.kind in FROM_BESIDE]
    beside += [h for h in told.hazards if LEAVING & {*HAZARDS[h.kind].acts}]
    beside += [h for h in told.hazards if h.kind is HazardKind.SUDDEN_TURN]
    led_around = any(
        h.kind in {HazardKind.OBSTACLE, HazardKind.STOPPING} and name in h.to for h in told.hazards
    ) or any(thing.in_way_of == name for thing in told.functional.objects)
    stands = any(p.parked or p.maneuvers == {Maneuver.STAY} for p in told.people)
    sideways = any(act.kind in LEAVING for act in told.acts_of(name))
    return not (sideways or led_around or stands or any(name in h.by for h in beside))


def _stays_in_lane(drive: Drive, view: View) -> Judged:
    """How far to a side it comes on the arm by which it comes."""
    name = drive.participant
    arm = arms_of(view)[drive.entry]
    # Beyond the junction it may come beside its own arm again.
    there = np.maximum.accumulate(arm.place(boxes(view, name))[0] > arm.straight_m, axis=1)
    aside = np.where(there, 0.0, np.abs(lateral_m(view, name, drive)))
    step = aside.argmax(axis=1)
    most = at(aside, step)
    return Judged(SAME_LANE_M - most, most, view.time_of(step))


def _stops(told: Told, name: str) -> bool:
    """Whether it is said to stop on its way."""
    own = told.acts_of(name)
    acts = any(act.kind in {ActKind.STOP, ActKind.WAIT} for act in own)
    acts |= any(act.kind is ActKind.CROSS and act.distance_m is not None for act in own)
    return acts or any(h.kind is HazardKind.STOPPING and name in h.by for h in told.hazards)


def _claim(
    name: str, statement: str, field: str, unit: str, test: Test, *, fixed: bool = True
) -> Claim:
    return Claim(
        id=f"maneuver.{name}",
        kind=ClaimKind.MANEUVER,
        statement=statement,
        field=field,
        unit=unit,
        test=test,
        scale=2.0,
        fixed=fixed,
    )


def _driven(told: Told, drive: Drive, field: str) -> Iterator[Claim]:
    name = drive.participant
    if drive.maneuver is Maneuver.LANE_CHANGE and not _is_an_act(told, drive):
        to = f" to the {drive.changes_to}" if drive.changes_to else ""
        test: Test = partial(_changes_lane, drive)
        yield _claim(f"lane_change.{name}", f"{name} changes lane{to}", field, "m", test)
    elif drive.maneuver is Maneuver.OVERTAKE and not _ended_from_beside(told, name):
        passed = [*told.functional.overtaken(name)]
        things = [t.id for t in told.functional.objects if t.in_way_of == name]
        whom = either(passed or things) if passed or things else "another who goes the same way"
        others = [p.id for p in told.people if p.id != name]
        test = partial(_overtakes, name, passed or [*others, *things])
        does = f"{name} passes {whom}"
        yield _claim(f"overtake.{name}", does, field, "m", test, fixed=False)
    if drive.turn in {Maneuver.LEFT, Maneuver.RIGHT, Maneuver.U_TURN} and drive.reverses is None:
        does = "turns back" if drive.turn is Maneuver.U_TURN else f"turns {drive.turn}"
        held_up = not any(act.kind in LETS_BY for act in told.acts_of(name))
        yield _claim(
            f"turn.{name}", f"{name} {does}", field, "deg", partial(_turns, drive, held_up)
        )


def _is_an_act(told: Told, drive: Drive) -> bool:
    """Whether its change of lane is one of the acts, to the same side: that is claimed there."""
    own = (a for a in told.acts_of(drive.participant) if a.kind is ActKind.CHANGE_LANE)
    return any(drive.changes_to in {None, act.side} for act in own)


def _ended_from_beside(told: Told, name: str) -> bool:
    """Whether all whom it could pass pull out or open a door before it, which may end it."""
    others = {p.id for p in told.people} - {name}
    coming = {*told.doors.values(), *(p.id for p in told.people if p.pulls_out)}
    return bool(others) and others <= coming


def _turns(drive: Drive, held_up: bool, view: View) -> Judged:
    """The change of heading up to the end; who is held up before it or in it is still to turn."""
    name = drive.participant
    heading = view.row(name, HEADING)
    last = view.last_step
    turned = np.degrees(at(heading, last) - heading[:, 0])
    if drive.turn is Maneuver.U_TURN:
        margin = np.abs(turned) - _BACK_DEG
    else:
        margin = (turned if drive.turn is Maneuver.LEFT else -turned) - _TURNS_DEG
    arm = arms_of(view)[drive.entry]
    along, _ = arm.place(boxes(view, name))
    begun = margin > _BEGUN_DEG - _TURNS_DEG
    waits = held_up & (begun | (at(along, last) <= arm.length_m)) & (np.abs(turned) < _TURNS_DEG)
    waits &= at(view.speed_mps(name), last) < STANDS_MPS
    return Judged(np.where(waits, 0.0, margin), turned, view.time_of(last))


def _changes_lane(drive: Drive, view: View) -> Judged:
    aside = lateral_m(view, drive.participant, drive)
    sense = {Side.LEFT: 1.0, Side.RIGHT: -1.0, None: 0.0}[drive.changes_to]
    aside = sense * aside if sense else np.abs(aside)
    step = aside.argmax(axis=1)
    most = at(aside, step)
    return Judged(most - LANE_M, most, view.time_of(step))


def _overtakes(name: str, others: list[str], view: View) -> Judged:
    """From wholly behind somebody to wholly ahead, side by side on one road."""
    best = np.full(view.count, -NEVER)
    when = np.zeros(view.count)
    for other in others:
        margin, time_s = passes(view, name, other)
        when = np.where(margin > best, time_s, when)
        best = np.maximum(best, margin)
    return Judged(best, best, when)


def _crosses(told: Told, crossing: Crossing, view: View) -> Judged:
    """Beyond the far kerb in the end, unless it has been hit as is said."""
    arm = arms_of(view)[crossing.arm]
    _, offset = arm.place(boxes(view, crossing.participant))
    last = view.last_step
    end = at(offset, last)
    right, left = arm.edges_m
    beyond = right - end if crossing.start is Side.LEFT else end - left
    hit = touched(told, view, crossing.participant)
    margin = np.where(hit & (beyond < 0.0), 0.0, beyond)
    return Judged(margin, end, view.time_of(last))


def _in_its_time(told: Told, crossing: Crossing) -> Iterator[Claim]:
    """How long it takes from kerb to kerb, where that is said."""
    for act in told.acts_of(crossing.participant):
        if act.kind is ActKind.CROSS and act.duration_s is not None:
            yield _claim(
                f"cross.{act.participant}.takes",
                f"{act.participant} takes {amount(act.duration_s)} s from kerb to kerb",
                f"acts.{act.id}.duration_s",
                "s",
                partial(_takes, crossing, act.duration_s),
                fixed=False,
            )


def _as_far(told: Told, crossing: Crossing) -> Iterator[Claim]:
    """How far from the kerb it stops, where that is said."""
    for act in told.acts_of(crossing.participant):
        if act.kind is ActKind.CROSS and act.distance_m is not None:
            yield _claim(
                f"cross.{act.participant}.stops",
                f"{act.participant} stops {amount(act.distance_m)} m from the kerb",
                f"acts.{act.id}.distance_m",
                "m",
                partial(_stops_at, crossing, act.distance_m),
                fixed=False,
            )


def _stops_at(crossing: Crossing, wanted: Interval, view: View) -> Judged:
    """Where its middle is in the end, from the kerb that it has left; unless it has been hit."""
    arm = arms_of(view)[crossing.arm]
    _, offset = arm.place(boxes(view, crossing.participant))
    right, left = arm.edges_m
    end = at(offset, view.last_step)
    far = left - end if crossing.start is Side.LEFT else end - right
    stands = at(view.speed_mps(crossing.participant), view.last_step) <= STANDS_MPS
    margin = np.where(stands, within(far, wanted, GAP_M), np.nan)
    return Judged(margin, far, view.time_of(view.last_step))


def _takes(crossing: Crossing, wanted: Interval, view: View) -> Judged:
    """From when its middle is over one kerb until it is over the other."""
    arm = arms_of(view)[crossing.arm]
    _, offset = arm.place(boxes(view, crossing.participant))
    right, left = arm.edges_m
    from_left = crossing.start is Side.LEFT
    on, off = (offset < left, offset < right) if from_left else (offset > right, offset > left)
    begins, ends = first(on), first(off)
    took = view.time_of(ends - begins)
    margin = within(took, wanted, 2 * TIME_S)
    return Judged(np.where(ends < view.steps, margin, np.nan), took, view.time_of(ends))


def _on_crosswalk(crossing: Crossing, view: View) -> Judged:
    """How far from its middle one is, along the road, while one is between the kerbs."""
    arm = arms_of(view)[crossing.arm]
    box = boxes(view, crossing.participant)
    middle = NEVER if arm.crosswalk_m is None else arm.crosswalk_m
    off = np.where(arm.on_it(box), np.abs(arm.place(box)[0] - middle), 0.0)
    step = off.argmax(axis=1)
    most = at(off, step)
    return Judged(CROSSWALK_WIDTH_M / 2 - most, most, view.time_of(step))


def _stands(told: Told, person: Participant, *, pulls_out: bool) -> Claim:
    name = person.id
    until = " until it pulls out" if pulls_out else " all the time"
    where = "is parked" if person.parked else "stands"
    field = "parked" if person.parked else "maneuvers"
    walks = person.kind in ON_FOOT and told.crossing(name) is not None
    return Claim(
        id=f"stands.{name}",
        kind=ClaimKind.STANDS,
        statement=f"{name} {where}{until}",
        field=f"participants.{name}.{field}",
        unit="km/h",
        test=partial(_pulls_out if pulls_out or walks else _still, name),
    )


def _still(name: str, view: View) -> Judged:
    speed = view.speed_mps(name)
    step = speed.argmax(axis=1)
    fastest = at(speed, step)
    return Judged((STANDS_MPS - fastest) * KPH, fastest * KPH, view.time_of(step))


def _pulls_out(name: str, view: View) -> Judged:
    """Stands at first, and moves later."""
    first = view.speed_mps(name)[:, 0]
    gone = view.place_m(name)[:, -1] - view.place_m(name)[:, 0]
    margin = np.where(gone > _MOVES_M, (STANDS_MPS - first) * KPH, -NEVER)
    return Judged(margin, first * KPH, np.zeros(view.count))
