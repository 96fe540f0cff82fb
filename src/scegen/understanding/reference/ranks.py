"""Places in a row: "the ego is fifth in a row of eight cars"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Word
from scegen.understanding.entity import Entity
from scegen.understanding.words.ordinals import POSITIONS
from scegen.understanding.words.tokens import Token


def rank(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """``the ego is fifth in a row of eight cars``: one of the eight, with four in front of it.

    The same is said by "the last of three cars", "the last in a platoon of three cars".
    """
    named = [c for c in chunks if isinstance(c, Mention)]
    for k, (place, prep, row) in enumerate(zip(chunks, chunks[1:], chunks[2:], strict=False)):
        if not isinstance(row, Mention) or row.mod("num") is None:
            continue
        bare = isinstance(place, Mention) and not place.heads
        label = tokens[place.j - 1].low if bare or isinstance(place, Word) else ""
        within = isinstance(prep, Word) and prep.value in ({"of", "in"} if bare else {"in"})
        if label not in POSITIONS or not within:
            continue
        is_, before = [None, None, *chunks[:k]][:-3:-1] if bare else (None, None)
        if bare:  # "the ego is the last of three cars"
            told = isinstance(is_, Word) and (is_.cat, is_.value) == ("aux", "be")
            who = [before] if told and isinstance(before, Mention) else []
        else:
            who = [m for m in named for p in m.pps if p.target is row]
            who += [m for e in events for p in e.pps if p.target is row for m in e.subject]
        if len(who) == 1:
            row.ranked = (who[0], POSITIONS[label])


def with_the_ranked(row: Mention, others: list[Entity]) -> list[Entity]:
    """The row, with whom it was said to be in it at their place.

    The others are in order.
    """
    if row.ranked is None:
        return others
    who, place = row.ranked
    at = place if place >= 0 else len(others) + 1 + place
    return [*others[:at], *who.entities, *others[at:]]
