"""``V1, designated ego,``, ``V1 (ego, a truck)``, ``V1, a van and the ego,``: one and the same."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Mention, Word
from scegen.understanding.words.terms import Term

_ENDS = frozenset({",", ".", ";", ")"})


def in_brackets(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with every second name of somebody in brackets of its own."""
    _counted_after(chunks)
    found: list[Chunk] = []
    k = 0
    while k < len(chunks):
        names, after = _names(chunks, k)
        for name in names:
            found += [_mark("(", name.i), name, _mark(")", name.j)]
        if names:
            k = after
        else:
            found.append(chunks[k])
            k += 1
    return found


def _counted_after(chunks: list[Chunk]) -> None:
    """``oncoming traffic: three cars come``: who the traffic is."""
    for who, mark, again in zip(chunks, chunks[1:], chunks[2:], strict=False):
        colon = isinstance(mark, Word) and mark.value == ":"
        if not (colon and isinstance(who, Mention) and isinstance(again, Mention)):
            continue
        number = again.mod("num")
        mass = who.head is not None and "mass" in who.head.data and who.mod("num") is None
        if mass and number is not None and again.head is not None:
            who.mods.append(number)
            who.heads, who.head, again.same_as = again.heads, again.head, who


def _names(chunks: list[Chunk], k: int) -> tuple[list[Mention], int]:
    """The further names that begin at a mark after somebody, and where the text goes on."""
    who = chunks[k - 1] if k else None
    if not isinstance(who, Mention):
        return [], k
    if _is(chunks, k, "("):
        first, joint, second = (chunks[m] if m < len(chunks) else None for m in range(k + 1, k + 4))
        listed = _is(chunks, k + 2, ",") and _is(chunks, k + 4, ")") and joint is not None
        if listed and _says_who(first) and _says_who(second):
            return [m for m in (first, second) if isinstance(m, Mention)], k + 5
        return [], k
    if not _is(chunks, k, ","):
        return [], k
    naming, name = (chunks[m] if m < len(chunks) else None for m in (k + 1, k + 2))
    if isinstance(naming, Word) and naming.cat == "naming" and isinstance(name, Mention):
        ends = any(_is(chunks, k + 3, mark) for mark in _ENDS)
        return ([name], k + 3 + _is(chunks, k + 3, ",")) if ends else ([], k)
    kind, ego = naming, chunks[k + 3] if k + 3 < len(chunks) else None
    both = _is(chunks, k + 2, "and") and _is(chunks, k + 4, ",") and who.label is not None
    if both and isinstance(kind, Mention) and isinstance(ego, Mention):
        opened = [m.value for m in kind.mods[:1]] == ["indef"]
        if opened and any(h.data.get("ego") for h in ego.heads):
            return [kind, ego], k + 5
    return [], k


def _says_who(chunk: Chunk | None) -> bool:
    """The ego, or a kind ("a truck")."""
    if not isinstance(chunk, Mention):
        return False
    indefinite = [m.value for m in chunk.mods[:1]] == ["indef"]
    return indefinite or any(h.data.get("ego") for h in chunk.heads)


def _is(chunks: list[Chunk], k: int, value: str) -> bool:
    chunk = chunks[k] if k < len(chunks) else None
    return isinstance(chunk, Word) and chunk.value == value


def _mark(value: str, at: int) -> Word:
    return Word(Term("punct", value, at, at))
