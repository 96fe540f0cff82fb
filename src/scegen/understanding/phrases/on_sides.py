"""One from each side: sides, arms and lanes over which several are shared out."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Prep, Word
from scegen.understanding.words.terms import Term

_A_PAIR = 2
"""Of two sides named, there may still be any number of vehicles."""


def from_everywhere(prep: Prep) -> bool:
    """``from all directions``, ``from every side``.

    Args:
        prep: a phrase of place.
    """
    target = prep.target
    if prep.value not in {"from", "in"} or not isinstance(target, Place):
        return False
    quantified = any(m.cat == "quant" and m.value == "all" for m in target.mods)
    return quantified and target.kind in {"direction", "side", "exit", "leg", "road"}


def each_side(prep: Prep) -> bool:
    """``from each side``: one from the left, one from the right.

    Args:
        prep: a phrase of place.
    """
    target = prep.target
    single = isinstance(target, Place) and target.head is not None and target.head.form != "s"
    if isinstance(target, Place) and target.kind == "lane" and prep.value == "in":
        every = any((m.cat, m.value) == ("quant", "all") for m in target.mods)
        return every and "adjacent" in target.dirs  # "a van in each adjacent lane"
    return from_everywhere(prep) and single and isinstance(target, Place) and target.kind == "side"


def each_of(chunks: list[Chunk]) -> list[Chunk]:
    """``in each of the two adjacent lanes``, ``one from each side``: in each, from each."""
    found: list[Chunk] = []
    first: Place | None = None
    for chunk in chunks:
        before = found[-1] if found else None
        on = isinstance(before, Word) and (before.cat, before.value) == ("prep", "in")
        if on and isinstance(chunk, Place) and {m.value for m in chunk.mods} == {"one"}:
            first = chunk  # "a bus on one side, a truck on the other": beside who is between them
        other = isinstance(chunk, Mention) and chunk.pronoun == "other"
        if on and other and first is not None and isinstance(chunk, Mention):
            chunk = Place(chunk.i, chunk.j, list(chunk.mods), None, kind="side")  # noqa: PLW2901
            for place in (first, chunk):
                place.mods = [*place.mods, Term("dir", "adjacent", place.i, place.j)]
        part, word = found[-2:] if len(found) > 1 else (None, None)
        if isinstance(chunk, Place) and isinstance(part, Mention) and isinstance(word, Word):
            every = any((m.cat, m.value) == ("quant", "all") for m in chunk.mods)
            if part.pronoun in {"all", "both"} and word.value == "of":
                del found[-2:]
                mods = [m for m in chunk.mods if m.cat not in {"det", "num"}]
                chunk.mods = [Term("quant", "all", chunk.i, chunk.i), *mods]
            elif part.pronoun == "one" and word.value == "from" and every and chunk.kind == "side":
                del found[-2]
        found.append(chunk)
    return found


def sides_of(events: list[Event], chunks: list[Chunk]) -> dict[int, int]:
    """Mentions of those who come one from each of some sides -> how many sides; 0: all."""
    found: dict[int, int] = {}
    for event in events:
        sides = {m.value for p in event.pps if p.value == "from" for m in _compass(p)}
        if any(each_side(p) for p in event.pps):
            found |= {id(m): _A_PAIR for m in event.subject}
        elif any(from_everywhere(p) for p in event.pps):
            found |= {id(m): 0 for m in event.subject}
        elif len(sides) > _A_PAIR:
            found |= {id(m): len(sides) for m in event.subject}
    for chunk in chunks:
        if isinstance(chunk, Mention) and any(each_side(p) for p in chunk.pps):
            found[id(chunk)] = _A_PAIR
        elif isinstance(chunk, Mention) and any(from_everywhere(p) for p in chunk.pps):
            found[id(chunk)] = 0
    return found


def _compass(prep: Prep) -> list[Term]:
    target = prep.target
    return [m for m in target.mods if m.cat == "compass"] if isinstance(target, Place) else []
