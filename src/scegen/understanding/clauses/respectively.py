"""Shares out what is said of several at once: "A and B travel north and east respectively"."""

from __future__ import annotations

from dataclasses import replace
from itertools import groupby

from scegen.understanding.chunks import Event, Mention, Prep
from scegen.understanding.phrases.nominal import WAYS
from scegen.understanding.words.terms import Term

_SHARED = ("compass", "dir")


def share_out(events: list[Event], terms: list[Term]) -> list[Event]:
    """The events with statements about several participants taken apart.

    Nobody drives north and east at once: as many ways as participants are one for each, in
    order, whether "respectively" is said or not. With it, the same holds for verbs ("stop and
    turn left, respectively").
    """
    found = [each for event in events for each in _apart(event)]
    for mark in [t.i for t in terms if t.value == "respectively"]:
        _verbs(found, mark)
    return found


def _members(event: Event) -> list[Mention]:
    """One mention for each participant that acts."""
    return [replace(m, entities=[e]) for m in event.subject for e in m.entities]


def _apart(event: Event) -> list[Event]:
    count = len(event.doers)
    if count < 2 or event.alternative is not None:
        return [event]
    shares = [ways for cat in _SHARED if (ways := _ways(event, cat, count))]
    sides = _sides(event, count)
    if not (shares or sides):
        return [event]
    gone = {m.i for share in shares for m in share}
    mods = [m for m in event.mods if m.i not in gone]
    pps = [p for p in event.pps if p not in sides]
    return [
        replace(
            event,
            subject=[who],
            mods=[*mods, *(share[k] for share in shares)],
            pps=[*pps, *sides[k : k + 1]],
        )
        for k, who in enumerate(_members(event))
    ]


def _ways(event: Event, cat: str, count: int) -> list[Term]:
    """Headings or turns, if there are as many different ones as participants."""
    ways = [m for m in event.mods if m.cat == cat and (cat != "dir" or m.value in WAYS)]
    return ways if len(ways) == count and len({w.value for w in ways}) > 1 else []


def _sides(event: Event, count: int) -> list[Prep]:
    """``approach from the north and from the east``, ``in the left and in the right lane``."""
    for word, group in groupby(event.pps, key=lambda p: p.value):
        sides = [p for p in group if p.place is not None]
        alike = word in {"from", "to"} or all(p.names("lane") for p in sides)
        if alike and len(sides) == count:
            return sides
    return []


def _verbs(events: list[Event], mark: int) -> None:
    """As many verbs as participants before the word: one for each."""
    before = [e for e in events if e.i < mark and e.subject and not e.nominal and e.control is None]
    if not before:
        return
    last = before[-1]
    alike = [e for e in before if e.sentence == last.sentence and e.doers == last.doers]
    members = _members(last)
    if len(alike) == len(members) > 1:
        for event, who in zip(alike, members, strict=True):
            event.subject = [who]
