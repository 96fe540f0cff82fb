"""Verbs whose words stand apart: "cuts the van off"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Word
from scegen.understanding.words.tokens import Token


def with_particles(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``cuts the van off`` is "cut off" with its object inside."""
    dropped: set[int] = set()
    for k, chunk in enumerate(chunks):
        if not (isinstance(chunk, Event) and chunk.name == "cut"):
            continue
        chunk.name = "cut_in"
        for following in chunks[k + 1 : k + 4]:
            if isinstance(following, Word) and tokens[following.i].low == "off":
                chunk.name = "cut_off"
                dropped.add(id(following))
    return [c for c in chunks if id(c) not in dropped]
