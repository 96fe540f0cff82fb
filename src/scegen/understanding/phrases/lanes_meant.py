"""Words that stand for a lane: "the left one of two lanes", "the truck in it", "two lanes over"."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import cat_at, chunk_at, value_at
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_LANES = frozenset({"lane", "ramp"})  # "the right lane ends"
_SIDES = frozenset({"left", "right", "adjacent"})
_JOINTS = frozenset({("from", "to"), ("from", "into"), ("in", "and")})
_OF_A_LANE = 3
"""Phrases: the side, "of", the lane."""
MOVING = frozenset({"move", "swerve", "try", "dash", "enter", "cross", "sharp_turn", "pull_out"})


def lanes_meant(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks with a lane in place of each "one" and "it" that means one."""
    found: list[Chunk] = []
    named: Place | None = None
    short: Place | None = None
    chunks = _within_a_lane(chunks, tokens)
    for k, chunk in enumerate(chunks):
        lane = _lane(chunk, k, chunks, named, tokens)
        if lane is not None and found[-1:] and found[-1].i == lane.i:
            found.pop()  # "the left" of "the left one"
        elif isinstance(chunk, Place) and chunk.kind == "lane" and found[-2:-1] == [short]:
            found.append(Word(Term("prep", "in", chunk.i, chunk.i)))
        found.append(lane or chunk)
        if lane is not None and value_at(chunks, k + 1) == "and":
            short = lane  # "in the left and the right lane": in both
        part = found[-3:-2] == [named] and found[-2].value == "of"
        if isinstance(found[-1], Place) and found[-1].kind in _LANES and not part:
            named = found[-1]
        elif isinstance(chunk, Event) and tokens[chunk.j - 1].base == "lane":
            named = Place(chunk.j - 1, chunk.j, [], None, kind="lane")  # "leaves its lane"
    return found


def _within_a_lane(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``on the right-hand side of the lane``, ``to the left of its lane``: in that lane."""
    found: list[Chunk] = []
    after = 0
    for k, chunk in enumerate(chunks):
        lane = _whole(k, chunks) if isinstance(chunk, Place) else None
        if isinstance(chunk, Place) and lane is not None and _is_within(chunk, lane, k, chunks):
            where = tokens[chunk.i - 1].low
            keeps = isinstance(chunk_at(chunks, k - 2), Event) and lane.has("possessive", "its")
            if where in word_list("inside") or (where == "to" and keeps):  # not "1 m to the right"
                found.append(Place(chunk.i, lane.j, chunk.ways, None, kind="within_lane"))
                after = k + _OF_A_LANE
        if k >= after:
            found.append(chunk)
    return found


def _is_within(side: Place, lane: Place, k: int, chunks: list[Chunk]) -> bool:
    """One side of one lane, of which no more is said."""
    several = lane.has("num") or lane.plural
    sided = side.kind == "side" and bool({"left", "right"} & set(side.dirs))
    more = isinstance(chunk_at(chunks, k + _OF_A_LANE), Place)
    return sided and not several and not more and side.i > 0


def _lane(
    chunk: Chunk, k: int, chunks: list[Chunk], named: Place | None, tokens: list[Token]
) -> Place | None:
    before, word, whole = chunk_at(chunks, k - 1), value_at(chunks, k - 1), _whole(k, chunks)
    if isinstance(chunk, Word) and chunk.cat == "det" and cat_at(chunks, k + 1) == "prep":
        head = Term("place", "lane", chunk.i, chunk.j)  # "into that of the ego"
        return Place(chunk.i, chunk.j, [], head, kind="lane") if named is not None else None
    if isinstance(chunk, Place) and chunk.kind in {"side", "middle"}:
        bare = chunk.head is None and _sided(chunk)
        named_side = chunk.has("det") and (bare or (chunk.kind == "middle" and whole is None))
        part = whole is not None or _to_another(k, chunks)
        return _as_lane(chunk, chunk) if named_side and part and word not in {"to", "on"} else None
    if not isinstance(chunk, Mention):
        return None
    used = isinstance(before, Event) and before.name == "use"
    over = isinstance(before, Event) and tokens[before.j - 1].low == "into"
    over = over and tokens[chunk.i - 2].base in word_list("shifting")  # "a van moves into it, too"
    if chunk.pronoun == "one":
        side = before if isinstance(before, Place) and before.kind in {"side", "middle"} else chunk
        middle = isinstance(side, Place) and side.kind == "middle"  # "of three, in the middle one"
        meant = (whole or named) is not None and (middle or _sided(side))
        if used and chunk.has("dir", "opposite"):
            return _as_lane(chunk, chunk)  # "leaves its lane and uses the oncoming one"
        alone = middle or side.head in (None, chunk.head)
        return _as_lane(side, chunk) if meant and alone else None
    if chunk.pronoun == "it" and named is not None and (used or over or word == "in"):
        return replace(_as_lane(chunk, chunk), mods=named.mods)
    return None


def _to_another(k: int, chunks: list[Chunk]) -> bool:
    """``from the left to the right lane``, ``in the middle and in the right lane``."""
    joint = (value_at(chunks, k - 1), value_at(chunks, k + 1))
    again = joint == ("in", "and") and value_at(chunks, k + 2) == "in"
    lane = chunk_at(chunks, k + 3 if again else k + 2)
    return joint in _JOINTS and isinstance(lane, Place) and lane.kind == "lane"


def _as_lane(first: NounPhrase, last: NounPhrase) -> Place:
    middle = isinstance(first, Place) and first.kind == "middle"
    data = {"ranked": True, "rank": "middle"} if middle else {}
    head = Term("place", "lane", last.j - 1, last.j, data=data)
    return Place(first.i, last.j, list(first.mods), head, kind="lane")


def _sided(noun: NounPhrase) -> bool:
    return noun.has("dir", *_SIDES)


def _whole(k: int, chunks: list[Chunk]) -> Place | None:
    """``of two lanes``: the lanes of which it is one."""
    lanes = chunk_at(chunks, k + 2) if value_at(chunks, k + 1) == "of" else None
    return lanes if isinstance(lanes, Place) and lanes.kind == "lane" else None
