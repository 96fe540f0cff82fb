"""Entries of a protocol: "Lead car, same lane: 30 km/h", "Other road users: none"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Word
from scegen.understanding.phrases.lookahead import BOUNDARIES, GOVERNING

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
        after = _entry(found[begin:], chunks, k) if _is(chunk, ":") else None
        if after is not None:
            k = after
            continue
        found.append(chunk)
        if isinstance(chunk, Word) and chunk.value in BOUNDARIES:
            begin = len(found)
        k += 1
    return found


def _entry(title: list[Chunk], chunks: list[Chunk], k: int) -> int | None:
    """Where the text goes on behind what an entry says of who opens it."""
    who = [c for c in title if isinstance(c, Mention) and _free(c, title)]
    if not who or any(isinstance(c, Event) and not c.nominal for c in title):
        return None
    m = k + 1
    while m < len(chunks) and getattr(chunks[m], "cat", "") in _SMALL:
        m += 1
    value = chunks[m] if m < len(chunks) else None
    if isinstance(value, Mention) and value.pronoun == _NOBODY and _ends(chunks, m + 1):
        who[0].negated = True
        return m + 1
    if isinstance(value, Word) and (value.cat, value.value) == ("quantity", "speed"):
        for each in who:
            each.mods = [*each.mods, value.term]
        return m + 1
    return None


def _free(who: Mention, title: list[Chunk]) -> bool:
    """Whether an entry is about somebody: no word of place governs who is named in it."""
    at = next(n for n, c in enumerate(title) if c is who)
    before = title[at - 1] if at else None
    governed = isinstance(before, Word) and before.cat in GOVERNING
    return bool(who.heads) and not (who.possessor or governed)


def _ends(chunks: list[Chunk], m: int) -> bool:
    return m >= len(chunks) or _is(chunks[m], ".") or _is(chunks[m], ";") or _is(chunks[m], ",")


def _is(chunk: Chunk, value: str) -> bool:
    return isinstance(chunk, Word) and chunk.value == value
