"""Stated speeds: held from the start until the first act, hazard, turn or reaction.

Who is said not to react holds the speed with which it begins, and has no reaction.
"""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.arms import arms_of
from scegen.claims.boxes import boxes
from scegen.claims.claim import Claim, ClaimKind, Judged, Test, within
from scegen.claims.moments import act_begins, speed_runs
from scegen.claims.series import at, chosen, filled, greatest, least
from scegen.claims.statements.touching import hit_s
from scegen.claims.told import KPH, Told, speed_words
from scegen.claims.tolerances import SPEED_MPS, STANDS_MPS
from scegen.claims.view import View
from scegen.motion.batch.arrays import SPEED, Floats, Ints
from scegen.scenario.acts import GAINING, SLOWING, ActKind
from scegen.scenario.control import STOPS
from scegen.scenario.functional import Participant
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.logical import Crossing
from scegen.scenario.model import Interval
from scegen.scenario.verbs import does, goes
from scegen.scenario.vocabulary import Control, HazardKind, JunctionKind, Maneuver

_CHANGES_BY = {ActKind.BRAKE: -1, ActKind.STOP: -1, ActKind.REVERSE: -1, ActKind.ACCELERATE: 1}
SPEED_CHANGES: dict[HazardKind, int] = {
    kind: _CHANGES_BY[act]
    for kind, row in HAZARDS.items()
    for act in row.acts
    if act in _CHANGES_BY
}
"""Dangers that whoever causes them makes by slowing down or speeding up."""
_COMFORT_MPS2 = 1.5
_BEFORE_TURN_M = 10.0
_REACTS_S = 5.0
"""Who has to react does so within this time before the closest approach."""
_FIRST_S = 0.5
"""A speed is held for this long at least, whatever happens."""


def claims(told: Told) -> Iterator[Claim]:
    """Of everybody whose speed is given and who does not stand."""
    for person in told.people:
        stays = (person.parked and not person.pulls_out) or person.maneuvers == {Maneuver.STAY}
        if person.unresponsive and not stays and told.drive(person.id) is not None:
            does, test = f"{person.id} brakes for nobody", partial(_no_slower, told, person)
            field = f"participants.{person.id}.unresponsive"
            yield speed_claim(f"unresponsive.{person.id}", does, field, test)
        if person.speed_mps is None or stays:
            continue
        crossing = told.crossing(person.id)
        test = partial(_holds, told, person, person.speed_mps)
        until = _until(told, person)
        verb = goes(person.kind)
        if told.reverses(person.id):
            test = partial(_fastest, told, person.id, person.speed_mps, -1)
            verb, until = "goes backwards at", ""
        elif person.pulls_out:
            test = partial(_fastest, told, person.id, person.speed_mps, 1)
            verb, until = "pulls out and becomes as fast as", ""
        if crossing is not None:
            test = partial(_walks, crossing, person.speed_mps)
            verb, until = "goes over the road at", ""
        does = f"{person.id} {verb} {speed_words(person.speed_mps)}{until}"
        yield speed_claim(f"speed.{person.id}", does, f"participants.{person.id}.speed_mps", test)


def speed_claim(name: str, statement: str, field: str, test: Test) -> Claim:
    """A statement of how fast somebody is; see Claim."""
    tolerance = SPEED_MPS * KPH
    return Claim(name, ClaimKind.SPEED, statement, field, "km/h", test, tolerance, scale=5.0)


def _until(told: Told, person: Participant) -> str:
    for act in told.acts_of(person.id):
        if act.kind in SLOWING | GAINING | {ActKind.WAIT}:
            return f" until it {does(act.kind)}"
    if told.collides:
        return " until the contact"
    return " until something concerns it"


def _fastest(told: Told, name: str, wanted: Interval, sense: int, view: View) -> Judged:
    """The greatest speed forwards or (``sense`` -1) backwards, up to a contact that is said."""
    before = np.arange(view.steps) * view.dt_s <= hit_s(told, view, name)[:, None]
    return _at_most(view, np.where(before, sense * view.row(name, SPEED), 0.0), wanted)


def _at_most(view: View, speed: Floats, wanted: Interval) -> Judged:
    """Whether the greatest speed is as is said."""
    fastest, step = greatest(speed)
    return Judged(within(fastest, wanted, SPEED_MPS) * KPH, fastest * KPH, view.time_of(step))


def _walks(crossing: Crossing, wanted: Interval, view: View) -> Judged:
    """The pace between the kerbs: the greatest speed there, which is held in their middle.

    Of one who stops at the kerb, the greatest on its way there.
    """
    there = arms_of(view)[crossing.arm].on_it(boxes(view, crossing.participant))
    walked = view.speed_mps(crossing.participant)
    pace = np.where(there, walked, 0.0)
    never = pace.max(axis=1, keepdims=True) <= STANDS_MPS
    return _at_most(view, np.where(never, walked, pace), wanted)


def _holds(told: Told, person: Participant, wanted: Interval, view: View) -> Judged:
    until = _held_until(told, person, view)
    until = np.maximum(until, round(_FIRST_S / view.dt_s))
    speed = view.speed_mps(person.id)
    _, step = greatest(np.abs(speed - wanted.middle), until=until)
    worst = at(speed, step)
    return Judged(within(worst, wanted, SPEED_MPS) * KPH, worst * KPH, view.time_of(step))


def _no_slower(told: Told, person: Participant, view: View) -> Judged:
    """The most by which it is ever slower than at first."""
    speed = view.speed_mps(person.id)
    slowest, step = least(speed, until=_held_until(told, person, view))
    lost = speed[:, 0] - slowest
    return Judged((SPEED_MPS - lost) * KPH, lost * KPH, view.time_of(step))


def _held_until(told: Told, person: Participant, view: View) -> Ints:
    """The last step in which the stated speed must be held (c,)."""
    name = person.id
    closest = view.last_step if person.unresponsive else _closest(told, view, name)
    ends = [_own_change(told, person, view), view.last_step, closest]
    between = told.functional.outcome.between if told.functional.outcome else ()
    # Who is to hit one that stands before it on its arm comes no farther.
    meets = {*told.logical.stand_before(name)} & {*between}
    if _turns(told, name) and not (told.collides and name in between and meets):
        ends.append(_before_turn(told, name, view))
    hits = told.collides and (not between or name in between)
    hit = hit_s(told, view, name)
    happens = np.isfinite(hit)
    ends.append(np.where(happens, view.step_of(np.where(happens, hit, 0.0)), view.steps))
    if not hits and not person.unresponsive and _may_react(told, name):
        ends.append(_others_begin(told, name, view, closest))
    return np.asarray(np.min(ends, axis=0))


def _own_change(told: Told, person: Participant, view: View) -> Ints:
    """When its own first act or danger that changes its speed begins."""
    acts = [a for a in told.acts_of(person.id) if a.kind in SLOWING | GAINING | {ActKind.WAIT}]
    begins = [act_begins(told, act, view) for act in acts]
    own = [h.kind for h in told.hazards if person.id in h.by and h.kind in SPEED_CHANGES]
    for kind in own if not acts else ():
        run = speed_runs(view, person.id, SPEED_CHANGES[kind])[0]
        begins.append(np.where(run.happens, run.begin, view.steps))
    return np.asarray(np.min([*begins, np.full(view.count, view.steps)], axis=0))


def _closest(told: Told, view: View, name: str) -> Ints:
    """When those who concern it (or else all, or things) come nearest to it; the end if none."""
    others = [other.id for other in told.people if other.id != name]
    things = [other for other in view.index if other != name]
    found = [(np.full(view.count, np.inf), np.full(view.count, np.nan))]
    for other in sorted(told.concerned_by(name)) or others or things:
        apart = filled(view.of_pair("distance_m", name, other), np.inf)
        found.append((apart, view.of_pair("closest_s", name, other)))
    _, nearest = chosen(found, np.argmin)
    return np.where(np.isfinite(nearest), view.step_of(nearest), view.last_step)


def _turns(told: Told, name: str) -> bool:
    """Whether its way or the rules at the junction make it slow down."""
    drive = told.drive(name)
    junction = told.functional.junction
    if drive is None or told.plain_road:
        exits = told.functional.participant(name).maneuvers == {Maneuver.EXIT}
        return drive is not None and (drive.turn is Maneuver.U_TURN or exits)
    return (
        drive.turn is not Maneuver.STRAIGHT
        or junction.kind is JunctionKind.ROUNDABOUT
        or junction.control in STOPS | {Control.YIELD, Control.SIGNALS}
        or any(c.yields == name for c in told.logical.conflicts)
    )


def _before_turn(told: Told, name: str, view: View) -> Ints:
    """When comfortable braking to a stop before the junction would begin."""
    drive = told.drive(name)
    if drive is None:
        return np.full(view.count, view.steps)
    arm = arms_of(view)[drive.entry]
    speed = view.speed_mps(name)[:, 0]
    room = speed**2 / (2.0 * _COMFORT_MPS2) + _BEFORE_TURN_M
    return arm.comes_to(view, name, arm.length_m - room)


def _may_react(told: Told, name: str) -> bool:
    """Whether something happens to it: the ego, and whom others endanger, or meet by their acts.

    On a road without a junction who is faster comes up to who is slower.
    """
    acting = {act.participant for act in told.functional.acts}
    acting |= {d.participant for d in told.logical.drives if d.changes_to is not None}
    acting |= {by for hazard in told.hazards for by in hazard.by}
    own = told.functional.participant(name).speed_mps if told.plain_road else None
    acting |= {p.id for p in told.people if own and p.speed_mps and p.speed_mps.high < own.low}
    return name == told.ego or bool(acting & told.concerned_by(name))


def _others_begin(told: Told, name: str, view: View, closest: Ints) -> Ints:
    """When the first of the others' acts begins; without one, some time before the approach.

    Who brakes at that time may have begun before: from high speed it takes longer.
    """
    others = [act for act in told.functional.acts if act.participant != name]
    soon = closest - round(_REACTS_S / view.dt_s)
    braking = speed_runs(view, name, -1)[0]
    soon = np.where(braking.happens & (braking.end > soon), np.minimum(soon, braking.begin), soon)
    if not others:
        return soon
    begins = [act_begins(told, act, view) for act in others]
    return np.asarray(np.maximum(np.min(begins, axis=0), soon))
