"""Who would run into another brakes for it as a driver does, as late as leaves a little room."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from math import ceil, floor, inf

from scegen.claims.boxes import gap_m
from scegen.concretization.amounts import (
    BRAKING,
    CLOSEST_M,
    answering_rates_mps2,
    falls_back,
    goes_on_when_free,
    hardest_mps2,
)
from scegen.concretization.limits import (
    COMFORTABLE_ACCELERATION_MPS2,
    COMFORTABLE_BRAKING_MPS2,
    REACTION_S,
)
from scegen.concretization.profile import Mover, Sort, SpeedChange
from scegen.concretization.tale import Tale
from scegen.concretization.traffic import Contact, Traffic, goes_along, leaves_room, unwanted
from scegen.motion.trigger_steps import STEP_S
from scegen.scenario.acts import Act, AfterAct
from scegen.scenario.hazards import HARD_BRAKING_MPS2
from scegen.scenario.vocabulary import HazardKind

_AFTER_S = 20.0
_MOVES_MPS = 0.1
_GOES_ON_S = (1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0)
_ROUNDS = 12
_ROUNDING, _SOFTER = 1e-6, 0.8
_SAME_M = 0.01
_LEAST_HARD_MPS2 = 1.05 * HARD_BRAKING_MPS2


def answer(traffic: Traffic) -> None:
    """Let everybody brake who would run into somebody, and can."""
    answer_each(partial(unwanted, traffic), partial(brake_for, traffic), 2 * len(traffic.movers))


def answer_each(
    contacts: Callable[[], Iterable[Contact]], brakes: Callable[[Contact], bool], rounds: int
) -> list[tuple[str, str]]:
    """Let everybody brake who can, whoever touches first at first; returns who touch all the same.

    So those behind answer what those nearer to the danger do.
    """
    touching: list[tuple[str, str]] = []
    for _ in range(rounds):
        found = [c for c in contacts() if (c.who, c.other) not in touching]
        if not found:
            break
        first = min(found)
        if not brakes(first):
            touching.append((first.who, first.other))
    return touching


def note_answers(tale: Tale, movers: Mapping[str, Mover]) -> None:
    """Say who brakes for whom of its own accord."""
    for name, mover in movers.items():
        for step in mover.steps:
            if step.act is None and step.reacts_to is not None:
                reason = f"brakes for {step.reacts_to}, as a driver who sees it does"
                tale.note(f"{name}.rate_mps2", step.rate_mps2, reason)


def brake_for(traffic: Traffic, contact: Contact, loose: SpeedChange | None = None) -> bool:
    """Brake as late as leaves a little room, and go on after it; not at all where nothing does.

    It is one's own braking of which nothing says when it begins, if that is told.
    """
    tale, who = traffic.tale, traffic.movers[contact.who]
    own = loose or tale.loose(who.steps, who.speed_mps)
    if own is None and traffic.follows(contact):
        return True
    before = who.steps
    waits = [s for s in before if s.act and goes_on_when_free(tale.act(s.act).when)]
    rest = [step for step in before if step is not own and step not in waits]
    who.steps = rest
    timed = who.timing()
    said = tale.act(own.act) if own is not None and own.act is not None else None
    answer, rates = _answer(traffic, contact, own, said)

    def brake(begins_s: float, rate: float) -> None:
        who.steps = [*rest, timed(replace(answer, rate_mps2=rate), begins_s)]

    rests_m = traffic.rests_m(contact, answer.act)
    exact = rests_m > -inf
    if own is not None and exact:  # as soft as it is told, if that is enough
        rates = sorted({own.rate_mps2, *(rate for rate in rates if rate > own.rate_mps2)})
    # Braking before one speeds up by an act of one's own would be undone by it.
    gains = [step.begins_s for step in rest if step.target_mps > who.speed_mps]
    found = None
    for sees_s in _sees_s(traffic, contact):
        earliest = max([sees_s, *gains, 0.0])
        leaves = _leaving(traffic, contact, rests_m, min(earliest, contact.time_s))
        found = found or brake_late(leaves, contact.time_s, rates, earliest, brake, exact=exact)
    if found is None:
        who.steps = before
        return _eases(traffic, contact.other)
    if own is not None and own.act is not None:
        traffic.put_off(own.act, found[0] - own.begins_s)
    if waits or (traffic.go_on and (own is None or (said is not None and falls_back(said)))):
        _go_on(traffic, contact, waits)
    return True


def _eases(traffic: Traffic, name: str) -> bool:
    """Let one brake no harder than it must to be a danger, if that is open; whether it does now.

    Not one who brakes for somebody itself.
    """
    tale, ahead = traffic.tale, traffic.movers.get(name)
    if ahead is None:
        return False
    awaited = {act.when.act for act in tale.acts if isinstance(act.when, AfterAct)}
    for step in ahead.steps:
        hard = step.hazard is HazardKind.HARD_BRAKING
        least = _LEAST_HARD_MPS2 if hard else COMFORTABLE_BRAKING_MPS2
        said = step.act is not None and tale.act(step.act).rate_mps2 is not None
        fixed = said or step.reacts_to is not None or step.act in awaited
        if not fixed and step.rate_mps2 > least:
            eased = replace(step, rate_mps2=least)
            ahead.steps = [eased if each is step else each for each in ahead.steps]
            return True
    return False


def _leaving(
    traffic: Traffic, contact: Contact, rests_m: float, since_s: float
) -> Callable[[float], bool]:
    """Whether one leaves so much room since then, and comes to rest no nearer than is said."""
    last = traffic.times_s[-1:]

    def leaves(room_m: float) -> bool:
        if not leaves_room(traffic, contact, room_m, since_s):
            return False
        ends = (traffic.track(name, last)[0] for name in contact[1:])
        return rests_m == -inf or not gap_m(*ends)[0] < rests_m - _SAME_M

    return leaves


def _sees_s(traffic: Traffic, contact: Contact) -> Iterator[float]:
    """When one may brake for another: as a driver reacts.

    Who cannot stop any more for somebody who steps out brakes as it sees that one.
    """
    for reaction_s in (REACTION_S, *(() if contact.other in traffic.movers else (0.0,))):
        seen_s = traffic.seen_s(*contact[1:]) + reaction_s
        yield ceil(seen_s / STEP_S - _ROUNDING) * STEP_S


def _answer(
    traffic: Traffic, contact: Contact, own: SpeedChange | None, said: Act | None
) -> tuple[SpeedChange, list[float]]:
    """The braking of one for another, as slow as that one at least, and how hard it may be."""
    tale, body = traffic.tale, traffic.movers[contact.who].body
    to_mps = _slowest_mps(traffic, contact)
    kinds = sorted(tale.kinds_by(contact.who) & BRAKING)
    if own is None:
        thing = all(each.id != contact.other for each in tale.functional.participants)
        hazard = next(iter(kinds), HazardKind.OBSTACLE if thing else None)
        own = SpeedChange(to_mps, 0.0, hazard=hazard, sort=Sort.ACT)
    elif said is None or not falls_back(said):
        to_mps = min(own.target_mps, to_mps)
    rates = answering_rates_mps2(said, hardest_mps2(body, tale.grip_mps2), hard=bool(kinds))
    return replace(own, target_mps=to_mps, reacts_to=contact.other), rates


def _slowest_mps(traffic: Traffic, contact: Contact) -> float:
    """How slow whoever one runs into becomes; 0 for one who goes another way."""
    _, who, other = contact
    if other not in traffic.movers or other in traffic.backs:
        return 0.0
    until = traffic.times_s[traffic.times_s < contact.time_s + _AFTER_S]
    speed = traffic.track(other, until)[1]
    if not (traffic.in_line(who, other) or goes_along(traffic, contact, until[-1:])):
        return 0.0
    slowest = float(speed[until >= contact.time_s].min())
    return slowest if slowest > _MOVES_MPS else 0.0


def _go_on(traffic: Traffic, contact: Contact, said: list[SpeedChange]) -> None:
    """Drive on as soon as that is free, by its own act if that is said; else stay as slow.

    No faster than the other, if that one goes along.
    """
    who, last = traffic.movers[contact.who], traffic.times_s[-1:]
    most_mps = who.speed_mps
    if contact.other in traffic.movers and goes_along(traffic, contact, last):
        most_mps = min(most_mps, float(traffic.track(contact.other, last)[1][0]))
    kept = who.steps
    if not said and (most_mps <= kept[-1].target_mps or any(step.act for step in kept[:-1])):
        return
    rate = min(COMFORTABLE_ACCELERATION_MPS2, who.body.max_acceleration_mps2)
    usual = SpeedChange(most_mps, rate, s_m=kept[-1].s_m, sort=Sort.ACT)
    for then_s in _GOES_ON_S:
        who.steps = [*kept, who.after(next(iter(said), usual), then_s)]
        goes = (
            float(traffic.track(contact.who, last)[1][0]) >= who.steps[-1].target_mps - _MOVES_MPS
        )
        if goes and leaves_room(traffic, contact, CLOSEST_M - 0.1):
            return
    who.steps = kept


def brake_late(
    leaves: Callable[[float], bool],
    contact_s: float,
    rates_mps2: Sequence[float],
    earliest_s: float,
    brake: Callable[[float, float], None],
    *,
    exact: bool = False,
) -> tuple[float, float] | None:
    """The latest moment, and the rate, at which braking still leaves a little room.

    Args:
        leaves: whether there is so much room (m), as it brakes now.
        contact_s: when it would touch the other.
        rates_mps2: how hard it may brake, the first that is enough is taken; of several it may also
            be a little less.
        earliest_s: when it may begin.
        brake: lets it brake from a time on at a rate; it has been called with what is returned.
        exact: that it need not begin at a step of players.

    Returns:
        When it begins (s) and its rate (m/s2); None if nothing helps.
    """

    def keeps(room_m: float, begins_s: float, rate_mps2: float) -> bool:
        brake(begins_s, rate_mps2)
        return leaves(room_m)

    for rate in rates_mps2:
        if not keeps(CLOSEST_M / 2, earliest_s, rate):
            continue
        latest = max(earliest_s, contact_s)
        begins = last_that(partial(keeps, CLOSEST_M, rate_mps2=rate), earliest_s, latest)
        if not exact:
            begins = max(earliest_s, floor(begins / STEP_S + _ROUNDING) * STEP_S)
        enough = rate
        if len(rates_mps2) > 1:
            enough = last_that(partial(keeps, CLOSEST_M, begins), rate, _SOFTER * rate)
        brake(begins, enough)
        return begins, enough
    return None


def last_that(holds: Callable[[float], bool], good: float, bad: float) -> float:
    """The last value on the way from one to another at which something holds, by halves."""
    for _ in range(_ROUNDS):
        middle = (good + bad) / 2
        good, bad = (middle, bad) if holds(middle) else (good, middle)
    return good
