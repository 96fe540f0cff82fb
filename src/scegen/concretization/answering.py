"""Who would run into another brakes for it as a driver does, as late as leaves a little room."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import combinations, permutations
from math import ceil, floor, inf
from typing import NamedTuple, Protocol

import numpy as np

from scegen.claims.boxes import Boxes, gap_m, same_way, seen
from scegen.concretization.amounts import (
    BRAKING,
    CLOSEST_M,
    answering_rates_mps2,
    falls_back,
    goes_on_when_free,
    hardest_mps2,
)
from scegen.concretization.boxes import apart
from scegen.concretization.limits import COMFORTABLE_ACCELERATION_MPS2, REACTION_S
from scegen.concretization.profile import Sort, SpeedChange
from scegen.concretization.tale import Tale
from scegen.motion.model import Array
from scegen.motion.trigger_steps import STEP_S
from scegen.scenario.bodies import Body
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.vocabulary import HazardKind

_BEFORE_S, _AFTER_S = 1.0, 20.0
_ALONG = 0.5
"""The least cosine between two who go the same way."""
_MOVES_MPS = 0.1
_GOES_ON_S = (1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0)
_ROUNDS = 12
_ROUNDING, _SOFTER = 1e-6, 0.8
_SAME_M = 0.01


class Contact(NamedTuple):
    """When ``who`` runs into ``other``."""

    time_s: float
    who: str
    other: str


class Mover(Protocol):
    """One who may brake; ``steps`` are the changes of its speed."""

    body: Body
    steps: list[SpeedChange]

    @property
    def speed_mps(self) -> float:
        """The speed before all steps."""

    def timing(self) -> Callable[[SpeedChange, float], SpeedChange]:
        """What lets a step begin at a moment, as this one drives now."""

    def after(self, step: SpeedChange, then_s: float) -> SpeedChange:
        """A step that comes so long after the others are over."""


@dataclass(frozen=True, slots=True)
class Traffic:
    """Everybody in time while numbers are chosen.

    ``movers`` may brake, ``touchable`` are they and all that they may run into; ``track`` gives the
    boxes of somebody over time, nan where it is gone, and its speeds (m/s), ``seen_s`` when to one
    another becomes a danger, and ``in_line`` whether two come by the same arm. Those who go back
    (``backs``) come on towards who has stopped for them. ``follows`` lets one follow another as in
    traffic if it can, ``rests_m`` is how far before another one is to come to rest that brakes for
    it by some act, and ``put_off`` is told of an act that begins so much later. All may ``go_on``
    of their own accord.
    """

    tale: Tale
    movers: Mapping[str, Mover]
    touchable: Sequence[str]
    times_s: Array
    track: Callable[[str, Array], tuple[Boxes, Array]]
    seen_s: Callable[[str, str], float]
    in_line: Callable[[str, str], bool]
    backs: frozenset[str]
    follows: Callable[[Contact], bool] = lambda _: False
    rests_m: Callable[[Contact, str | None], float] = lambda *_: -inf
    put_off: Callable[[str, float], None] = lambda *_: None
    go_on: bool = False


def answer(traffic: Traffic) -> None:
    """Let everybody brake who would run into somebody, and can."""
    answer_each(partial(_unwanted, traffic), partial(brake_for, traffic), 2 * len(traffic.movers))


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


def contacts(traffic: Traffic, of: str | None = None) -> list[Contact]:
    """All who touch, or those whom one touches, each pair once, the first first."""
    names, movers, times_s = traffic.touchable, traffic.movers, traffic.times_s
    tracks = {name: traffic.track(name, times_s)[0] for name in names}
    found = []
    for one, other in combinations(names, 2):
        if of in {None, one, other} and (one in movers or other in movers):
            touch = apart(tracks[one], tracks[other], 0.0) <= 0.0
            if touch.any():
                found.append(Contact(float(times_s[np.argmax(touch)]), one, other))
    return sorted(found)


def runs_first_into(traffic: Traffic, name: str) -> Contact | None:
    """Into whom one runs first."""
    turned = (
        Contact(c.time_s, name, c[2] if c.who == name else c.who) for c in contacts(traffic, name)
    )
    return next((contact for contact in turned if _runs_in(traffic, contact)), None)


def _unwanted(traffic: Traffic) -> Iterator[Contact]:
    """The contacts that somebody should brake for; whoever is to crash before is halted by it."""
    crashed: set[str] = set()
    for time_s, *pair in contacts(traffic):
        if traffic.tale.contact_wanted(*pair):
            crashed |= {*pair}
            continue
        for who, other in permutations(pair):
            contact = Contact(time_s, who, other)
            if who in traffic.movers and who not in crashed and _runs_in(traffic, contact):
                yield contact


def _runs_in(traffic: Traffic, contact: Contact) -> bool:
    """Whether it is one's own contact: whoever comes up behind another brakes for it.

    So does who is said to brake for it, and who is said to get away; who reverses, unless the other
    comes faster.
    """
    time_s, who, other = contact
    tale, at = traffic.tale, np.array([time_s])
    if {who, other} & traffic.backs & traffic.movers.keys():
        own, its = (float(traffic.track(name, at)[1][0]) for name in contact[1:])
        return own >= its
    ahead, along = had_ahead(traffic, contact)
    if other not in traffic.movers:
        return ahead
    follows = along > _ALONG and (
        traffic.in_line(who, other) or other not in tale.endangered_by(who)
    )
    outcome = tale.functional.outcome
    avoided = outcome is not None and outcome.kind is OutcomeKind.AVOIDED
    gets_away = avoided and who in tale.endangered_by(other)
    return ahead and (follows or gets_away or other in tale.endangered_by(who, *BRAKING))


def had_ahead(traffic: Traffic, contact: Contact) -> tuple[bool, float]:
    """Whether one had the other ahead, just before they touch, and the cosine between them."""
    at = np.array([contact.time_s - _BEFORE_S])
    own, other = (traffic.track(name, at)[0] for name in contact[1:])
    return float(seen(own, other).x[0]) > 0.0, float(same_way(own, other)[0])


def brake_for(traffic: Traffic, contact: Contact, loose: SpeedChange | None = None) -> bool:
    """Brake as late as leaves a little room, and go on after it; not at all where nothing does.

    It is one's own braking of which nothing says when it begins, if that is told.
    """
    tale, who = traffic.tale, traffic.movers[contact.who]
    own = loose or tale.loose(who.steps, who.speed_mps)
    if own is None and traffic.follows(contact):
        return True
    slowest = _slowest_mps(traffic, contact)
    before = who.steps
    waits = [s for s in before if s.act and goes_on_when_free(tale.act(s.act).when)]
    rest = [step for step in before if step is not own and step not in waits]
    who.steps = rest
    timed = who.timing()
    answer, rates = _answer(tale, contact, own, slowest, who.body)
    answer = replace(answer, there=own is None and (contact.other in traffic.backs))

    def brake(begins_s: float, rate: float) -> None:
        who.steps = [*rest, timed(replace(answer, rate_mps2=rate), begins_s)]

    rests_m, last = traffic.rests_m(contact, answer.act), traffic.times_s[-1:]
    if own is not None and rests_m > -inf:  # as soft as it is told, if that is enough
        rates = sorted({own.rate_mps2, *(rate for rate in rates if rate > own.rate_mps2)})

    def leaves(room_m: float) -> bool:
        rest = (traffic.track(name, last)[0] for name in contact[1:])
        return leaves_room(traffic, contact, room_m) and not gap_m(*rest)[0] < rests_m - _SAME_M

    # Braking before one speeds up by an act of one's own would be undone by it.
    gains = [step.begins_s for step in rest if step.target_mps > who.speed_mps]
    found = None
    # Who cannot stop for somebody who steps out any more brakes as it sees that one.
    for reaction_s in (REACTION_S, *(() if contact.other in traffic.movers else (0.0,))):
        sees_s = ceil((traffic.seen_s(*contact[1:]) + reaction_s) / STEP_S - _ROUNDING) * STEP_S
        earliest = max([sees_s, *gains, 0.0])
        found = found or brake_late(
            leaves, contact.time_s, rates, earliest, brake, exact=rests_m > -inf
        )
    if found is None:
        who.steps = before
        return False
    if own is not None and own.act is not None:
        traffic.put_off(own.act, found[0] - own.begins_s)
    if waits or (own is None and traffic.go_on):
        _go_on(traffic, contact, waits)
    return True


def _answer(
    tale: Tale, contact: Contact, own: SpeedChange | None, to_mps: float, body: Body
) -> tuple[SpeedChange, list[float]]:
    """The braking of one for another, down to a speed at least, and how hard it may be."""
    said = tale.act(own.act) if own is not None and own.act is not None else None
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
    if not (traffic.in_line(who, other) or _goes_along(traffic, contact, until[-1:])):
        return 0.0
    slowest = float(speed[until >= contact.time_s if speed[0] < _MOVES_MPS else ...].min())
    return slowest if slowest > _MOVES_MPS else 0.0


def _goes_along(traffic: Traffic, contact: Contact, at_s: Array) -> bool:
    own, other = (traffic.track(name, at_s)[0] for name in contact[1:])
    return float(same_way(own, other)[0]) > _ALONG


def leaves_room(traffic: Traffic, contact: Contact, room_m: float) -> bool:
    """Whether one comes no nearer to another; while it drives, if that one comes on."""
    (one, speed), (other, _) = (traffic.track(name, traffic.times_s) for name in contact[1:])
    comes_on = contact.other in traffic.backs & traffic.movers.keys()
    at_rest = (speed <= 0.0) & comes_on
    return bool(np.all((apart(one, other, room_m) >= room_m) | at_rest))


def _go_on(traffic: Traffic, contact: Contact, said: list[SpeedChange]) -> None:
    """Drive on as soon as that is free, by its own act if that is said; else stay as slow.

    No faster than the other, if that one goes along.
    """
    who, last = traffic.movers[contact.who], traffic.times_s[-1:]
    most_mps = who.speed_mps
    if contact.other in traffic.movers and _goes_along(traffic, contact, last):
        most_mps = min(most_mps, float(traffic.track(contact.other, last)[1][0]))
    kept = who.steps
    if not said and (most_mps <= kept[-1].target_mps or any(step.act for step in kept)):
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
