"""Parts of bodies that touch, told without a verb: "our front into its tail", "front into it"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place
from scegen.understanding.phrases.doings_named import teller_at
from scegen.understanding.phrases.lookahead import chunk_at, ends, value_at
from scegen.understanding.words.terms import Term

ARTICLES = ("det", "num", "possessive", "quant")
_BODY = frozenset({"side", "front", "flank", "portion", "middle"})
_PACE = frozenset({"quantity", "dir", "manner"})


def touching(chunks: list[Chunk], k: int) -> list[Chunk]:
    """``our front into its tail``, ``…, middle of our front``: parts touch, without a verb.

    So it is in ``…, front into the taxi``; "40 km/h straight into the van" drives into it.
    """
    at, last = chunks[k].i, chunk_at(chunks, k - 1)
    opens = ends(last) or last.value == ","
    if not (opens or chunks[k].value == "into"):
        return []
    marks = [m for m, c in enumerate(chunks) if ends(c) or c.value == ","]
    before = chunks[max((m + 1 for m in marks if m < k), default=0) : k]
    after = chunks[k : min((m for m in marks if m >= k), default=len(chunks))]
    if chunks[k].value == "into" and _owned(before) and _of_bodies(before + after[1:]):
        return [Event("collide", at, at, "s", lemma="hit")]
    if opens and _of_bodies(after):
        aside = all(c.kind == "side" and c.owner is None for c in after if isinstance(c, Place))
        doing = [] if aside else [Event("collide", at, at, "base", nominal=True)]
        return [*doing, Term("prep", "in", at, at)]  # "…, right side": there it is
    into = next((m for m, c in enumerate(after) if c.value == "into"), 0)
    whom, paced = after[into + 1 :], all(c.cat in _PACE for c in after[:into])
    touched = isinstance(chunk_at(whom, 0), Mention) or _of_bodies(whom)
    own = _of_bodies(after[:into]) and not _owned(after)
    if not (opens and into and touched and (paced or own)):
        return []
    who = [teller_at(at)] if ends(last) else []
    if paced:
        return [*who, Event("move", at, at, "s")]
    return [*who, Event("collide", at, at, "s"), Term("prep", "with", at, at)]


def _owned(parts: list[Chunk]) -> bool:
    """``our front``, ``front of the ego``, unlike a bare ``front`` of whoever acts."""
    first, whose = chunk_at(parts, 0), value_at(parts, 1) == "of"
    return isinstance(first, NounPhrase) and (whose or first.mod(*ARTICLES) is not None)


def _of_bodies(chunks: list[Chunk]) -> bool:
    """``the left end of the ego's front``: a part of somebody, and nothing else."""
    parts = [c for c in chunks if not (isinstance(c, Mention) or c.value == "of")]
    return bool(parts) and all(isinstance(c, Place) and c.kind in _BODY for c in parts)
