"""Lanes that are counted or pointed back at: "two lanes over", "half in the next one"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Place, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_MOVING = frozenset({"move", "swerve", "try", "dash", "enter", "cross", "sharp_turn", "pull_out"})
_SIDES = frozenset({"left", "right", "adjacent", "opposite"})


def count_lanes(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks with such lanes as places."""
    if not any(isinstance(c, Place) and c.kind == "lane" for c in chunks):
        return chunks
    found: list[Chunk] = []
    skipped: set[int] = set()
    for k, chunk in enumerate(chunks):
        if id(chunk) in skipped:
            continue
        before = found[-1] if found else None
        after = chunks[k + 1] if k + 1 < len(chunks) else None
        if not (isinstance(chunk, Place) and _counted(chunk) and _aside(after, chunks, k, tokens)):
            found.append(chunk)
            continue
        if isinstance(before, Event) and before.name in _MOVING and not before.nominal:
            before.name = "lane_change"  # "moves two lanes over"
            found.append(chunk)
            continue
        skipped |= (
            {id(after)}
            if tokens[getattr(after, "i", 0)].low in word_list("lanes_away_over")
            else set()
        )
        changed = isinstance(before, Event) and before.name == "lane_change"
        if changed or (isinstance(before, Word) and before.cat == "prep"):
            found.append(chunk)
            continue
        side = _side_after(chunks, k)
        if side is not None:
            chunk.mods, chunk.j = [*chunk.mods, *_ways(side)], side.j
            skipped |= {id(c) for c in chunks[k + 1 : k + 3]}
        chunk.mods = [*chunk.mods, Term("dir", "adjacent", chunk.i, chunk.j)]
        found += [Word(Term("prep", "in", chunk.i, chunk.i)), chunk]
    return found


def _counted(place: Place) -> bool:
    return place.kind == "lane" and bool(place.mods) and place.mods[0].cat in {"num", "det"}


def _aside(after: Chunk | None, chunks: list[Chunk], k: int, tokens: list[Token]) -> bool:
    """``two lanes over``, ``one lane to the left``."""
    if not isinstance(after, Word):
        return False
    single = chunks[k].i + 1 < len(tokens) and isinstance(chunks[k], Place)
    if tokens[after.i].low in word_list("lanes_away_over"):
        return single
    numbered = any(m.cat == "num" for m in getattr(chunks[k], "mods", []))
    return numbered and _side_after(chunks, k) is not None


def _side_after(chunks: list[Chunk], k: int) -> Place | None:
    """``two lanes to the left``, ``the one on the right``."""
    word, side = (chunks[m] if m < len(chunks) else None for m in (k + 1, k + 2))
    leads = isinstance(word, Word) and word.cat == "prep" and word.value in {"to", "in"}
    sided = isinstance(side, Place) and side.kind == "side" and bool(set(side.dirs) & _SIDES)
    return side if leads and sided and isinstance(side, Place) else None


def _ways(side: Place) -> list[Term]:
    return [m for m in side.mods if m.cat == "dir"]
