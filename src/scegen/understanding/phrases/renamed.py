"""Verbs that the words after them make others: "cuts the van off", "changes to the outer lane"."""

from __future__ import annotations

from itertools import pairwise

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.tokens import Token

_CHANGE_REACH = 7


def between_lanes(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``changes from the inner to the outer lane`` is a change of lane.

    Args:
        chunks: the chunks of the text; verbs of such changes are renamed.
        tokens: its tokens.
    """
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, Event) or tokens[chunk.i].base not in word_list("changing"):
            continue
        for before, place in pairwise(chunks[k : k + 1 + _CHANGE_REACH]):
            direct = before is chunk  # "has to change two lanes to the right"
            if not direct and (isinstance(before, Mention | Event) or before.cat == "punct"):
                break
            goal = direct or before.value in {"to", "into"}
            if goal and isinstance(place, Place) and place.kind == "lane":
                chunk.name = "lane_change"
    return chunks


def with_particles(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``cuts the van off``, ``runs him over``: "cut off" and "run over" with the object inside."""
    dropped: set[int] = set()
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, Event):
            continue
        if tokens[chunk.i].base == "run":
            whom, over, after = (*chunks[k + 1 : k + 4], None, None, None)[:3]
            last = after is None or after.cat in {"punct", "conj"}
            if isinstance(whom, Mention) and _is(over, "over", tokens) and last:
                chunk.name = "collide"
                dropped.add(id(over))
        if chunk.name != "cut":
            continue
        chunk.name = "cut_in"
        for following in chunks[k + 1 : k + 4]:
            if _is(following, "off", tokens):
                chunk.name = "cut_off"
                dropped.add(id(following))
    return [c for c in chunks if id(c) not in dropped] if dropped else chunks


def _is(chunk: Chunk | None, particle: str, tokens: list[Token]) -> bool:
    return isinstance(chunk, Word) and tokens[chunk.i].low == particle
