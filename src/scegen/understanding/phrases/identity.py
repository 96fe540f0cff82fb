"""``V1, designated ego,``, ``V1 (ego, a truck)``, ``V1, a van and the ego,``: one and the same."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Word
from scegen.understanding.phrases.lookahead import BOUNDARIES, GOVERNING
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_GENERIC = frozenset({"car", "driver", "adversary"})
_HELPS = frozenset({"aux", "manner"})
_ENDS = frozenset({",", ".", ";", ")"})


def in_brackets(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks with every second name of somebody in brackets of its own."""
    _announced(chunks)
    _told_before_named(chunks, tokens)
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


def _told_before_named(chunks: list[Chunk], tokens: list[Token]) -> None:
    """``the vehicle follows a van …; the vehicle under test stops``: the vehicle is that one.

    Whom a text begins with by a mere noun is nobody new, if the ego is called by that noun later.
    """
    named = [c for c in chunks if isinstance(c, Mention) and c.heads]
    first = named[0] if named else None
    if first is None or first.head is None or first.is_ego:
        return
    if [(m.cat, m.value) for m in first.mods] != [("det", "def")]:
        return
    noun, after = tokens[first.head.i].low, chunks[chunks.index(first) + 1 :]
    verb = next((c for c in after if not (isinstance(c, Word) and c.cat in _HELPS)), None)
    if not isinstance(verb, Event):
        return  # "the vehicle ahead"
    for again in named[1:]:
        if again.is_ego and noun in {t.low for t in tokens[again.i : again.j]}:
            first.heads = [*again.heads, *first.heads]
            return


def _announced(chunks: list[Chunk]) -> None:
    """``oncoming traffic: three cars come``, ``several targets, both …: a van and a bus …``.

    Whoever a heading names without a number are those told after its colon, and nobody besides.
    """
    begin = 0
    for k, mark in enumerate(chunks):
        if not isinstance(mark, Word) or mark.value not in BOUNDARIES:
            continue
        named = [c for c in chunks[begin:k] if isinstance(c, Mention) and c.heads and not c.is_ego]
        begin, who = k + 1, named[0] if named else None
        if mark.value != ":" or who is None or who.head is None or who.mod("num") is not None:
            continue
        again = chunks[k + 1] if k + 1 < len(chunks) else None
        number = again.mod("num") if isinstance(again, Mention) else None
        mass = "mass" in who.head.data
        told = _listed(chunks, k + 1)
        if mass and number is not None and isinstance(again, Mention) and again.head is not None:
            who.mods.append(number)
            who.heads, who.head, again.same_as = again.heads, again.head, who
        elif who.head.form == "s" and who.head.value in _GENERIC and len(told) > 1:
            count = Term("num", "count", who.i, who.i, data={"number": float(len(told))})
            who.mods = [count, *(m for m in who.mods if m.cat != "quant")]


def _listed(chunks: list[Chunk], k: int) -> list[Mention]:
    """Who is told one after the other up to the end of a sentence, the ego left out."""
    end = next((m for m, c in enumerate(chunks[k:], k) if _ends(c)), len(chunks))
    return [
        c
        for before, c in zip(chunks[k - 1 : end - 1], chunks[k:end], strict=True)
        if isinstance(c, Mention) and c.heads and not c.is_ego
        if not (isinstance(before, Word) and before.cat in GOVERNING)
    ]


def _ends(chunk: Chunk) -> bool:
    return isinstance(chunk, Word) and chunk.value in {".", ";"}


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
    kind, further = naming, chunks[k + 3] if k + 3 < len(chunks) else None
    both = _is(chunks, k + 2, "and") and _is(chunks, k + 4, ",") and who.label is not None
    if both and isinstance(kind, Mention) and isinstance(further, Mention):
        opened = [m.value for m in kind.mods[:1]] == ["indef"]
        if opened and further.is_ego:
            return [kind, further], k + 5
    return [], k


def _says_who(chunk: Chunk | None) -> bool:
    """The ego, or a kind ("a truck", "passenger car")."""
    if not isinstance(chunk, Mention):
        return False
    kind = not chunk.label and all(m.value == "indef" for m in chunk.mods if m.cat == "det")
    return kind or chunk.is_ego


def _is(chunks: list[Chunk], k: int, value: str) -> bool:
    chunk = chunks[k] if k < len(chunks) else None
    return isinstance(chunk, Word) and chunk.value == value


def _mark(value: str, at: int) -> Word:
    return Word(Term("punct", value, at, at))
