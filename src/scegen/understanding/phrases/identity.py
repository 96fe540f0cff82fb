"""``V1 (ego, a truck)``: one and the same."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Mention, Word
from scegen.understanding.words.terms import Term

_WHOLE = 6
"""Somebody, a bracket, two names with a comma between, a bracket."""


def in_brackets(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with each of two further names of somebody in brackets of its own."""
    found: list[Chunk] = []
    for k, chunk in enumerate(chunks):
        who, opening, first, _, second, closing = (*chunks[k - 3 : k + 3], *[None] * _WHOLE)[
            :_WHOLE
        ]
        marks = [c.value if isinstance(c, Word) else "" for c in (opening, chunk, closing)]
        named = k > 2 and marks == ["(", ",", ")"] and isinstance(who, Mention)
        if named and _says_who(first) and _says_who(second):
            found += [Word(Term("punct", mark, chunk.i, chunk.i)) for mark in ")("]
        else:
            found.append(chunk)
    return found


def _says_who(chunk: Chunk | None) -> bool:
    """The ego, or a kind ("a truck", "passenger car")."""
    if not isinstance(chunk, Mention):
        return False
    kind = not chunk.label and all(m.value == "indef" for m in chunk.mods if m.cat == "det")
    return kind or chunk.is_ego
