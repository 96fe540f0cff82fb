"""Places in a row: "the ego is fifth in a row of eight cars"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Word
from scegen.understanding.draft import Entity
from scegen.understanding.words.ordinals import POSITIONS
from scegen.understanding.words.tokens import Token


def rank(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """``the ego is fifth in a row of eight cars``: one of the eight, with four in front of it.

    Args:
        chunks: the chunks of the text.
        events: its events.
        tokens: its tokens.
    """
    for place, prep, row in zip(chunks, chunks[1:], chunks[2:], strict=False):
        label = tokens[place.i].low if isinstance(place, Word) else ""
        within = isinstance(prep, Word) and prep.value == "in"
        if label not in POSITIONS or not within or not isinstance(row, Mention):
            continue
        named = [c for c in chunks if isinstance(c, Mention)]
        who = [m for m in named for p in m.pps if p.target is row]
        who += [m for e in events for p in e.pps if p.target is row for m in e.subject]
        if len(who) == 1 and row.mod("num") is not None:
            row.ranked = (who[0], POSITIONS[label])


def with_the_ranked(row: Mention, others: list[Entity]) -> list[Entity]:
    """The row, with whom it was said to be in it at their place.

    Args:
        row: the words for it.
        others: all but that one, in order.
    """
    if row.ranked is None:
        return others
    who, place = row.ranked
    at = place if place >= 0 else len(others) + 1 + place
    return [*others[:at], *who.entities, *others[at:]]
