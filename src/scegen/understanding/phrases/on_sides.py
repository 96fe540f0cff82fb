"""One from each side: sides, arms and lanes over which several are shared out."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Prep
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
