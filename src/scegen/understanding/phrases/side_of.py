"""``the lane right of the ego``: as "to the right of the ego"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word
from scegen.understanding.words.terms import Term

_SIDES = frozenset({"left", "right"})


def sides_of(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with a side that somebody is on as the place that it is."""
    found: list[Chunk] = []
    for k, chunk in enumerate(chunks):
        if isinstance(chunk, Word) and _is_place(chunk, k, chunks):
            found += [
                Word(Term("prep", "to", chunk.i, chunk.i)),
                Place(chunk.i, chunk.j, [chunk.term], None, kind="side"),
            ]
        else:
            found.append(chunk)
    return found


def _is_place(word: Word, k: int, chunks: list[Chunk]) -> bool:
    """A bare side before "of" and somebody; not the way of a turn, nor after a number."""
    of, whom = (chunks[m] if m < len(chunks) else None for m in (k + 1, k + 2))
    before = chunks[k - 1] if k else None
    sided = word.cat == "dir" and word.value in _SIDES
    owned = isinstance(of, Word) and of.value == "of" and isinstance(whom, Mention)
    owned = owned and not getattr(whom, "possessor", False)  # "right of the ego's centre line"
    measured = isinstance(before, Word) and before.cat in {"quantity", "prep"}
    turns = isinstance(before, Event) and before.name in {"turn", "sharp_turn", "lane_change"}
    return sided and owned and not (measured or turns)
