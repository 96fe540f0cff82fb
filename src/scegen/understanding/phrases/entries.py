"""Entries of a protocol: "Lead car, same lane: 30 km/h", "Other road users: none"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Word
from scegen.understanding.phrases.lookahead import (
    BOUNDARIES,
    cat_at,
    chunk_at,
    free_mentions,
    value_at,
)

_SMALL = frozenset({"manner", "prep"})
_NOBODY = "nobody"


def read_entries(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks; a speed behind a colon is that of who opens the entry, "none" denies who does.

    Args:
        chunks: of the text.
    """
    found: list[Chunk] = []
    begin, k = 0, 0
    while k < len(chunks):
        chunk = chunks[k]
        after = _entry(found[begin:], chunks, k) if chunk.value == ":" else None
        if after is not None:
            k = after
            continue
        found.append(chunk)
        if chunk.value in BOUNDARIES:
            begin = len(found)
        k += 1
    return found


def _entry(title: list[Chunk], chunks: list[Chunk], k: int) -> int | None:
    """Where the text goes on behind what an entry says of who opens it."""
    who = [m for m in free_mentions(title) if m.heads and not m.possessor]
    if not who or any(isinstance(c, Event) and not c.nominal for c in title):
        return None
    m = k + 1
    while cat_at(chunks, m) in _SMALL:
        m += 1
    value = chunk_at(chunks, m)
    last = m + 1 == len(chunks) or value_at(chunks, m + 1) in {".", ";", ","}
    if isinstance(value, Mention) and value.pronoun == _NOBODY and last:
        who[0].negated = True
        return m + 1
    if isinstance(value, Word) and (value.cat, value.value) == ("quantity", "speed"):
        for each in who:
            each.mods = [*each.mods, value.term]
        return m + 1
    return None
