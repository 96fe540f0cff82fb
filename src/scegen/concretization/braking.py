"""Who would run into another brakes for it, as late as leaves a little room."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import partial
from math import floor, inf
from typing import NamedTuple, Protocol

import numpy as np

from scegen.claims.boxes import Boxes, same_way, seen
from scegen.concretization.amounts import BRAKING, CLOSEST_M, answering_rates_mps2, falls_back
from scegen.concretization.boxes import apart
from scegen.concretization.profile import Sort, SpeedChange
from scegen.concretization.tale import Tale
from scegen.motion.model import Array
from scegen.motion.trigger_steps import STEP_S
from scegen.scenario.vocabulary import HazardKind

_BEFORE_S = 1.0
_ROUNDS = 12
_ROUNDING, _SOFTER = 1e-6, 0.8


class Contact(NamedTuple):
    """When ``who`` runs into ``other``."""

    time_s: float
    who: str
    other: str


class Traffic(Protocol):
    """Those who move, while their numbers are being chosen."""

    def track(self, name: str, times_s: Array) -> tuple[Boxes, Array]:
        """The boxes of somebody over time, and its speeds (m/s)."""


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


def touch_s(times_s: Array, first: Boxes, second: Boxes, until_s: float = inf) -> float | None:
    """When two touch first, if they do before a time."""
    touch = (apart(first, second, 0.0) <= 0.0) & (times_s < until_s)
    return float(times_s[np.argmax(touch)]) if touch.any() else None


def had_ahead(traffic: Traffic, contact: Contact) -> tuple[bool, float]:
    """Whether one had the other ahead, just before they touch, and the cosine between them."""
    at = np.array([contact.time_s - _BEFORE_S])
    own, other = traffic.track(contact.who, at)[0], traffic.track(contact.other, at)[0]
    return float(seen(own, other).x[0]) > 0.0, float(same_way(own, other)[0])


def apart_by(
    traffic: Traffic, contact: Contact, times_s: Array, room_m: float, *, comes_on: bool = False
) -> bool:
    """Whether one comes no nearer to another; while it drives, if that one comes on."""
    (one, speed), (other, _) = (traffic.track(n, times_s) for n in (contact.who, contact.other))
    at_rest = (speed <= 0.0) & comes_on
    return bool(np.all((apart(one, other, room_m) >= room_m) | at_rest))


def answer_of(
    tale: Tale,
    contact: Contact,
    own: SpeedChange | None,
    to_mps: float,
    most_mps2: float,
    *,
    thing: bool,
) -> tuple[SpeedChange, list[float]]:
    """The braking of one for another, down to a speed at least, and how hard it may be.

    It is its ``own``, if the text tells of one without saying when.
    """
    said = tale.act(own.act) if own is not None and own.act is not None else None
    kinds = sorted(tale.kinds_by(contact.who) & BRAKING)
    if own is None:
        hazard = next(iter(kinds), HazardKind.OBSTACLE if thing else None)
        own = SpeedChange(to_mps, 0.0, hazard=hazard, sort=Sort.ACT)
    elif said is None or not falls_back(said):
        to_mps = min(own.target_mps, to_mps)
    rates = answering_rates_mps2(said, most_mps2, hard=bool(kinds))
    return replace(own, target_mps=to_mps, reacts_to=contact.other), rates


def brake_late(
    leaves: Callable[[float], bool],
    contact_s: float,
    rates_mps2: Sequence[float],
    earliest_s: float,
    brake: Callable[[float, float], None],
) -> tuple[float, float] | None:
    """The latest moment, and the rate, at which braking still leaves a little room.

    Args:
        leaves: whether there is so much room (m), as it brakes now.
        contact_s: when it would touch the other.
        rates_mps2: how hard it may brake, the first that is enough is taken; of several it may also
            be a little less.
        earliest_s: when it may begin.
        brake: lets it brake from a time on at a rate; it has been called with what is returned.

    Returns:
        When it begins (s, at a step of players) and its rate (m/s2); None if nothing helps.
    """

    def keeps(room_m: float, begins_s: float, rate_mps2: float) -> bool:
        brake(begins_s, rate_mps2)
        return leaves(room_m)

    for rate in rates_mps2:
        if not keeps(CLOSEST_M / 2, earliest_s, rate):
            continue
        latest = max(earliest_s, contact_s)
        begins = last_that(partial(keeps, CLOSEST_M, rate_mps2=rate), earliest_s, latest)
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
