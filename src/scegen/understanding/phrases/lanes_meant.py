"""Words that stand for a lane: "the left one of two lanes", "the truck in it"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_LANES = frozenset({"lane", "ramp"})  # "the right lane ends"
_SIDES = frozenset({"left", "right", "adjacent"})
_OF_A_LANE = 3
"""Phrases: the side, "of", the lane."""


def lanes_meant(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks with a lane in place of each "one" and "it" that means one.

    Args:
        chunks: the chunks of the text.
        tokens: its tokens.
    """
    if not any(isinstance(c, Place) and c.kind in _LANES for c in chunks):
        return chunks
    found: list[Chunk] = []
    named: Place | None = None
    chunks = _within_a_lane(chunks, tokens)
    for k, chunk in enumerate(chunks):
        lane = _lane(chunk, k, chunks, named)
        if lane is not None and found and found[-1].i == lane.i:
            found.pop()  # "the left" of "the left one"
        found.append(lane or chunk)
        part = len(found) > 2 and found[-3] is named and getattr(found[-2], "value", "") == "of"
        if isinstance(found[-1], Place) and found[-1].kind in _LANES and not part:
            named = found[-1]
    return found


def _within_a_lane(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``on the right-hand side of the lane``, ``to the left of its lane``: in that lane."""
    found: list[Chunk] = []
    after = 0
    for k, chunk in enumerate(chunks):
        lane = _whole(k, chunks) if isinstance(chunk, Place) else None
        if isinstance(chunk, Place) and lane is not None and _is_within(chunk, lane, k, chunks):
            where = tokens[chunk.i - 1].low
            if where in word_list("inside") or (where == "to" and _keeps(k, chunks) and _its(lane)):
                sides = [m for m in chunk.mods if m.cat == "dir"]
                found.append(Place(chunk.i, lane.j, sides, None, kind="within_lane"))
                after = k + _OF_A_LANE
        if k >= after:
            found.append(chunk)
    return found


def _is_within(side: Place, lane: Place, k: int, chunks: list[Chunk]) -> bool:
    """One side of one lane, of which no more is said."""
    several = lane.mod("num") is not None or (lane.head is not None and lane.head.form == "s")
    sided = side.kind == "side" and bool({"left", "right"} & set(side.dirs))
    further = chunks[k + _OF_A_LANE : k + _OF_A_LANE + 1]
    more = bool(further) and isinstance(further[0], Place)
    return sided and not several and not more and side.i > 0


def _keeps(k: int, chunks: list[Chunk]) -> bool:
    """``keeps to the right of its lane``, but ``half a metre to the right of …``."""
    return k > 1 and isinstance(chunks[k - 2], Event)


def _its(lane: Place) -> bool:
    return any((m.cat, m.value) == ("possessive", "its") for m in lane.mods)


def _lane(chunk: Chunk, k: int, chunks: list[Chunk], named: Place | None) -> Place | None:
    if not isinstance(chunk, Place | Mention):
        return None
    before, whole = chunks[k - 1] if k else None, _whole(k, chunks)
    if isinstance(chunk, Place) and chunk.kind == "side":
        named_side = chunk.mod("det") is not None and chunk.head is None and _sided(chunk)
        after = before is not None and getattr(before, "value", "") in {"to", "on"}
        if not named_side or after or (whole is None and not _to_another(k, chunks)):
            return None
        return _as_lane(chunk, chunk, chunk.mods)
    if not isinstance(chunk, Mention):
        return None
    if chunk.pronoun == "one":
        side = before if isinstance(before, Place) and before.kind == "side" else chunk
        of = whole or named
        if of is None or not _sided(side) or side.head not in (None, chunk.head):
            return None
        return _as_lane(side, chunk, side.mods)
    within = isinstance(before, Word) and (before.cat, before.value) == ("prep", "in")
    used = isinstance(before, Event) and before.name == "use"
    if chunk.pronoun == "it" and named is not None and (used or within):
        sides = [m for m in named.mods if m.cat == "dir"]
        return _as_lane(chunk, chunk, sides)
    return None


def _to_another(k: int, chunks: list[Chunk]) -> bool:
    """``from the left to the right lane``."""
    before, after, lane = (
        chunks[m] if 0 <= m < len(chunks) else None for m in (k - 1, k + 1, k + 2)
    )
    leads = isinstance(after, Word) and after.value in {"to", "into"}
    named = isinstance(lane, Place) and lane.kind == "lane"
    return isinstance(before, Word) and before.value == "from" and leads and named


def _as_lane(first: NounPhrase, last: NounPhrase, mods: list[Term]) -> Place:
    head = Term("place", "lane", last.j - 1, last.j)
    return Place(first.i, last.j, list(mods), head, kind="lane")


def _sided(noun: NounPhrase) -> bool:
    return any(m.cat == "dir" and m.value in _SIDES for m in noun.mods)


def _whole(k: int, chunks: list[Chunk]) -> Place | None:
    """``of two lanes``: the lanes of which it is one."""
    after = chunks[k + 1 : k + 3]
    of = len(after) > 1 and isinstance(after[0], Word) and after[0].value == "of"
    lanes = after[1] if of else None
    return lanes if isinstance(lanes, Place) and lanes.kind == "lane" else None
