"""Lanes that are counted or pointed back at: "two lanes over", "half in the next one"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Place, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import chunk_at, value_at
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_MOVING = frozenset({"move", "swerve", "try", "dash", "enter", "cross", "sharp_turn", "pull_out"})
_SIDES = frozenset({"left", "right", "adjacent", "opposite"})


def count_lanes(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks with such lanes as places."""
    found: list[Chunk] = []
    skipped: set[int] = set()
    for k, chunk in enumerate(chunks):
        if k in skipped:
            continue
        before, after = chunk_at(found, len(found) - 1), chunk_at(chunks, k + 1)
        over = isinstance(after, Word) and tokens[after.i].low in word_list("lanes_away_over")
        side = _side_after(chunks, k)
        if not (isinstance(chunk, Place) and _counted(chunk)) or not (
            over or (side is not None and chunk.has("num"))
        ):
            found.append(chunk)
            continue
        if isinstance(before, Event) and before.name in _MOVING and not before.nominal:
            before.name = "lane_change"  # "moves two lanes over"
            found.append(chunk)
            continue
        if over:
            skipped.add(k + 1)
        changed = isinstance(before, Event) and before.name == "lane_change"
        if changed or (before is not None and before.cat == "prep"):
            found.append(chunk)
            continue
        if side is not None:
            chunk.mods, chunk.j = [*chunk.mods, *side.ways], side.j
            skipped |= {k + 1, k + 2}
        chunk.mods = [*chunk.mods, Term("dir", "adjacent", chunk.i, chunk.j)]
        found += [Word(Term("prep", "in", chunk.i, chunk.i)), chunk]
    return found


def _counted(place: Place) -> bool:
    return place.kind == "lane" and bool(place.mods) and place.mods[0].cat in {"num", "det"}


def _side_after(chunks: list[Chunk], k: int) -> Place | None:
    """``two lanes to the left``, ``the one on the right``."""
    side = chunk_at(chunks, k + 2)
    if value_at(chunks, k + 1) not in {"to", "in"} or not isinstance(side, Place):
        return None
    return side if side.kind == "side" and _SIDES & set(side.dirs) else None
