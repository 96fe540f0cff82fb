"""Telegraphic style: "Ego straight, truck from the left: right turn", "Cut-in by a van".

What is left out is put back before the clauses are read: "goes" before a bare direction, the
colon after a heading that says who or where, and who does what a noun names.
"""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word
from scegen.understanding.lookahead import BOUNDARIES
from scegen.understanding.terms import Term

_WAYS = frozenset({"left", "right", "straight"})
_SEPARATORS = frozenset({",", "and", "but", "or", "while", "when", "as", "(", "both"})
_AFTER = frozenset({"prep", "conj", "sub", "manner", "env", "locus", "control"})
_WITHIN = frozenset({"prep", "locus", "dir", "manner", "label"})
_NAMED = frozenset({"cut_in", "lane_change", "merge", "u_turn", "hard_brake", "swerve"})
_DOER = frozenset({"of", "by"})


def spell_out(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with what telegraphic style leaves out.

    Args:
        chunks: the chunks of the text.
    """
    chunks = _after_headings(chunks)
    for k, chunk in enumerate(chunks):
        if isinstance(chunk, Event) and not chunk.nominal and _named_doing(chunks, k):
            chunk.nominal = True
    return [_going(chunks, k) or chunk for k, chunk in enumerate(chunks)]


def _is(chunk: Chunk | None, value: str) -> bool:
    return isinstance(chunk, Word) and chunk.value == value


def _ends(chunk: Chunk | None) -> bool:
    return chunk is None or (isinstance(chunk, Word) and chunk.value in BOUNDARIES)


def _at(chunks: list[Chunk], k: int) -> Chunk | None:
    return chunks[k] if 0 <= k < len(chunks) else None


def _after_headings(chunks: list[Chunk]) -> list[Chunk]:
    """``From the left: a truck``, ``Ego: straight``: the colon adds nothing."""
    kept: list[Chunk] = []
    begin = 0
    comma = 0
    for k, chunk in enumerate(chunks):
        comma = k + 1 if _is(chunk, ",") else comma
        title = chunks[max(begin, comma) : k]
        if _is(chunk, ":") and title and _adds_nothing(title, chunks, k):
            if isinstance(title[0], Word) and title[0].cat == "dir":
                _describe(title[0].term, chunks, k)
        else:
            kept.append(chunk)
        if _ends(chunk):
            begin = k + 1
    return kept


def _adds_nothing(title: list[Chunk], chunks: list[Chunk], k: int) -> bool:
    first, following = title[0], _at(chunks, k + 1)
    if isinstance(first, Word) and first.cat == "dir":
        return len(title) == 1 and isinstance(following, Mention)
    placed = isinstance(first, Word) and first.cat in {"prep", "locus"}
    if placed:
        simple = all(isinstance(c, Word | Place) or _ego(c) for c in title)
        return simple and isinstance(following, Mention)
    way = isinstance(following, Word) and following.cat == "dir" and following.value in _WAYS
    named = isinstance(first, Mention) and not any(isinstance(c, Event) for c in title)
    return way and named


def _ego(chunk: Chunk) -> bool:
    return isinstance(chunk, Mention) and any(h.data.get("ego") for h in chunk.heads)


def _describe(term: Term, chunks: list[Chunk], k: int) -> None:
    """``Oncoming: a van and a bus``: both are."""
    for chunk in chunks[k + 1 :]:
        if _ends(chunk) or isinstance(chunk, Event):
            return
        if isinstance(chunk, Mention) and chunk.heads and chunk.prep is None and not _ego(chunk):
            chunk.mods = [*chunk.mods, term]


def _named_doing(chunks: list[Chunk], k: int) -> bool:
    """``Cut-in by a van``, ``Hard braking of the lead car``: a doing, with who does it."""
    following, who = _at(chunks, k + 1), _at(chunks, k + 2)
    event = chunks[k]
    said = isinstance(event, Event) and event.form in {"base", "ing"}
    opens = _ends(_at(chunks, k - 1))
    doer = isinstance(following, Word) and following.value in _DOER and isinstance(who, Mention)
    placed = isinstance(following, Word) and following.cat in {"prep", "locus", "manner"}
    bare = isinstance(event, Event) and event.form == "base" and event.name in _NAMED
    return said and opens and (doer or (bare and placed))


def _going(chunks: list[Chunk], k: int) -> Event | None:
    """``ego straight``: goes straight."""
    way = chunks[k]
    if not isinstance(way, Word) or way.cat != "dir" or way.value not in _WAYS:
        return None
    following = _at(chunks, k + 1)
    free = _ends(following) or (
        isinstance(following, Word) and (following.value == "," or following.cat in _AFTER)
    )
    opener = _clause_opener(chunks, k)
    if not free or _is(following, "of") or opener is None:
        return None
    return Event("move", way.i, way.j, "s", mods=[way.term], drives=True)


def _clause_opener(chunks: list[Chunk], k: int) -> Mention | None:
    """The participant with which the clause before chunk ``k`` begins, if it has no verb."""
    opener: Mention | None = None
    depth = 0
    preposed = False
    for m in range(k - 1, -1, -1):
        chunk = chunks[m]
        if _is(chunk, ")"):
            depth += 1
        elif _is(chunk, "(") and depth:
            depth -= 1
        elif isinstance(chunk, Mention):
            before = _at(chunks, m - 1)
            preposed = isinstance(before, Word) and before.cat in {"prep", "locus"}
            opener = None if preposed else chunk
            if opener is not None and not _introduced(chunks, m - 1):
                return None
            if opener is not None:
                return opener
        elif isinstance(chunk, Event) or (
            isinstance(chunk, Word) and chunk.cat not in _WITHIN and not depth
        ):
            return None
    return None


def _introduced(chunks: list[Chunk], m: int) -> bool:
    """Whether a clause begins after chunk ``m``."""
    before = _at(chunks, m)
    if _ends(before):
        return True
    if not isinstance(before, Word) or before.value not in _SEPARATORS:
        return False
    return before.value != "(" and not isinstance(_at(chunks, m - 1), Event)
