"""Places named again: "the left lane … in that lane", "… travelling there"."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_SIDED = frozenset({"side", "direction"})
_SIDES = frozenset({"left", "right", "opposite"})
_CROSSED = frozenset({"crosswalk", "road", "junction"})
_COME_FROM = frozenset({"lane", "leg", "road", "access", "side"})


def repeat(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """Gives "that lane", "from that side" and "there" the directions of what was named last.

    Returns:
        The chunks, "there" replaced by "in" and the lane that it stands for.
    """
    if not any(token.low in word_list("back_again") for token in tokens):
        return chunks
    last: dict[str, Place] = {}
    found: list[Chunk] = []
    for chunk in chunks:
        lane = last.get("lane")
        if isinstance(chunk, Word) and _there(chunk, found, tokens):
            came = isinstance(found[-1], Word) and found[-1].value == "from"
            place = last.get("anywhere") if came else lane
            if place is not None:
                found += [] if came else [Word(Term("prep", "in", chunk.i, chunk.j))]
                found.append(replace(place, i=chunk.i, j=chunk.j, mods=list(place.mods), prep=None))
                continue
        if isinstance(chunk, Mention) and "exit" in last and _taken(chunk, found):
            label = [m for m in chunk.mods if m.cat == "label"]
            chunk = replace(last["exit"], i=chunk.i, j=chunk.j, mods=label)  # noqa: PLW2901
        if "crossed" in last and _across_it(chunk, found):
            chunk = replace(last["crossed"], i=chunk.i, j=chunk.j, prep=None)  # noqa: PLW2901
        found.append(chunk)
        if isinstance(chunk, Place):
            _remember(chunk, last, tokens)
    return found


def _remember(chunk: Place, last: dict[str, Place], tokens: list[Token]) -> None:
    """Keeps a place by what may mean it again; one that is pointed at gets the sides of that."""
    kind = "side" if chunk.kind in _SIDED else chunk.kind
    if kind in _COME_FROM and _SIDES & set(chunk.dirs):
        last["anywhere"] = chunk
    if kind in _CROSSED:
        last["crossed"] = chunk
    if kind == "exit":
        last[kind] = chunk
    lane = last.get("lane")
    points = chunk.mods and tokens[chunk.mods[0].i].low in word_list("pointing")
    if kind == "lane" and points and lane is not None and not chunk.dirs:
        chunk.mods = [*chunk.mods, *(m for m in lane.mods if m.cat == "dir")]
    elif kind == "side" and points and "side" in last and not chunk.dirs:
        chunk.mods = [*chunk.mods, *last["side"].mods]
    elif (kind == "lane" and chunk.dirs) or (kind == "side" and _SIDES & set(chunk.dirs)):
        kept = [m for m in chunk.mods if kind == "lane" or m.cat == "dir"]
        last[kind] = replace(chunk, mods=kept)


def _taken(mention: Mention, before: list[Chunk]) -> bool:
    """``takes the first exit, the bus takes the second``: an exit, too."""
    word = before[-1] if before else None
    goal = isinstance(word, Word) and word.cat == "prep"
    taken = isinstance(word, Event) and word.name in {"leave", "use"}
    return mention.pronoun == "ordinal" and (goal or taken)


def _across_it(chunk: Chunk, before: list[Chunk]) -> bool:
    """``approaches a zebra crossing; a cyclist rides across it``: the crossing, nobody."""
    verb = before[-1] if before else None
    it = isinstance(chunk, Mention) and chunk.pronoun == "it" and not chunk.possessor
    return it and isinstance(verb, Event) and verb.name == "cross" and not verb.nominal


def _there(word: Word, before: list[Chunk], tokens: list[Token]) -> bool:
    """``the car travelling there``, ``but there a van brakes``: not "there" at the start."""
    last = before[-1] if before else None
    opens = isinstance(last, Word) and (last.cat == "conj" or last.value == "from")
    return (
        (opens or isinstance(last, Event | Mention))
        and tokens[word.i].low == "there"
        and word.j - word.i == 1
    )
