"""Everybody in time while numbers are chosen: who would run into whom, and with what room."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, permutations
from math import inf
from typing import NamedTuple

import numpy as np

from scegen.claims.boxes import Boxes, same_way, seen
from scegen.concretization.amounts import BRAKING
from scegen.concretization.boxes import apart
from scegen.concretization.profile import Mover
from scegen.concretization.tale import Tale
from scegen.motion.model import Array
from scegen.scenario.outcome import OutcomeKind

_BEFORE_S, _ALONG = 1.0, 0.5
"""So long before a contact it is seen who had whom ahead; the least cosine of going the same way.
"""


class Contact(NamedTuple):
    """When ``who`` runs into ``other``."""

    time_s: float
    who: str
    other: str


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


def unwanted(traffic: Traffic) -> Iterator[Contact]:
    """The contacts that somebody should brake for who reacts.

    Whoever is to crash before is halted by it.
    """
    drive_on = {p.id for p in traffic.tale.functional.participants if p.unresponsive}
    for (time_s, *pair), crashed in _unasked(traffic):
        for who, other in permutations(pair):
            contact = Contact(time_s, who, other)
            brakes = who in traffic.movers and who not in crashed | drive_on
            if brakes and _runs_in(traffic, contact):
                yield contact


def goes_wrong(traffic: Traffic) -> bool:
    """Whether two touch who are not to, but as a crash that is said leads to others."""
    return any(not crashed & {*contact[1:]} for contact, crashed in _unasked(traffic))


def _unasked(traffic: Traffic) -> Iterator[tuple[Contact, frozenset[str]]]:
    """The contacts that nobody asked for, with those who have crashed before as they are to."""
    crashed: frozenset[str] = frozenset()
    for contact in contacts(traffic):
        if traffic.tale.contact_wanted(*contact[1:]):
            crashed |= {*contact[1:]}
        else:
            yield contact, crashed


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


def goes_along(traffic: Traffic, contact: Contact, at_s: Array) -> bool:
    """Whether both head the same way at a time."""
    own, other = (traffic.track(name, at_s)[0] for name in contact[1:])
    return float(same_way(own, other)[0]) > _ALONG


def leaves_room(traffic: Traffic, contact: Contact, room_m: float, since_s: float = 0.0) -> bool:
    """Whether one comes no nearer to another since then; while it drives, if that one comes on."""
    times_s = traffic.times_s[traffic.times_s >= since_s]
    (one, speed), (other, _) = (traffic.track(name, times_s) for name in contact[1:])
    comes_on = contact.other in traffic.backs & traffic.movers.keys()
    at_rest = (speed <= 0.0) & comes_on
    return bool(np.all((apart(one, other, room_m) >= room_m) | at_rest))
