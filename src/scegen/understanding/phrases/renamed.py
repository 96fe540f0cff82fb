"""Verbs that the words after them make others: "cuts the van off", "changes to the outer lane"."""

from __future__ import annotations

from itertools import pairwise

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import longest_match
from scegen.understanding.words.tokens import Token

_CHANGE_REACH = 7
_BOTH = 2


def between_lanes(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``changes from the inner to the outer lane`` is a change of lane."""
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
        whom, particle, after = (*chunks[k + 1 : k + 4], None, None, None)[:3]
        last = after is None or after.cat in {"punct", "conj"}
        split = isinstance(whom, Mention) and isinstance(particle, Word) and last
        if split and particle is not None and particle.cat != "manner":
            both = longest_match([tokens[chunk.i], tokens[particle.i]], 0)
            if both is not None and both.j == _BOTH and both.has("verb"):
                chunk.name = both.get("verb").value
                dropped.add(id(particle))
        if chunk.name == "cut":
            chunk.name = "cut_in"
    return [c for c in chunks if id(c) not in dropped] if dropped else chunks
