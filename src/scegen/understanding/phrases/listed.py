"""Those who were counted, one by one: "two pedestrians cross, a woman … and a man …"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import (
    GOVERNING,
    cat_at,
    ends,
    sentence_end,
    value_at,
)
from scegen.understanding.words.tokens import Token

_MARKS = {",": ",", ":": ",", "(": ")"}
"""What opens a list, and what closes it before the end of the sentence."""
_KNOWN = frozenset({"det", "possessive"})
_COUNTS = frozenset({"det", "num", "quant"})


def list_them(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """Those named one by one, as many as were counted, take the place of who was counted.

    Behind the verb ("two people cross, a woman and a man"), and wherever a colon opens the list
    ("three vehicles meet: a bus turns, …"), they are marked as ``listed``.

    Args:
        chunks: the chunks of the text.
        tokens: its tokens.
    """
    for k, counted in enumerate(chunks):
        count = _size(counted)
        if not isinstance(counted, Mention) or count < 2 or counted.is_ego or counted.listed:
            continue
        stop = next((m for m in range(k, len(chunks)) if chunks[m].value == "."), len(chunks))
        for m in (m for m in range(k + 1, stop) if chunks[m].value in _MARKS):
            first = m + 1 + (value_at(chunks, m + 1) == "with")
            told, end = _one_by_one(chunks[:stop], first, count, _MARKS[chunks[m].value])
            told = told if all(_alike(t, counted, tokens) for t in told) else []
            if told and m == k + 1:  # "three vehicles, a van and two cars, meet"
                told[0].i = counted.i
                for one in told:
                    one.drives = counted.noun == "driver"
                    one.mods = [*one.mods, *(t for t in counted.mods if t.cat not in _COUNTS)]
                return list_them([*chunks[:k], *chunks[first:end], *chunks[end + 1 :]], tokens)
            if chunks[m].value == ":":
                told = [c for c in chunks[m:stop] if isinstance(c, Mention) and _in_list(c)]
            elif any(map(_acts, chunks[end : sentence_end(chunks, end)])):
                continue
            for one in told:
                one.listed = True
    return chunks


def _one_by_one(
    chunks: list[Chunk], first: int, count: int, closes: str
) -> tuple[list[Mention], int]:
    """Who is named from a chunk on, up to so many, and where the list is closed."""
    told: list[Mention] = []
    for k in range(first, len(chunks)):
        chunk = chunks[k]
        left = count - sum(map(_size, told))
        if _acts(chunk) or left < 0:
            break
        if not left and (chunk.value == closes or ends(chunk)):
            return told, k
        free = value_at(chunks, k - 1) != "(" and cat_at(chunks, k - 1) not in GOVERNING
        if isinstance(chunk, Mention) and chunk.heads and (free or k == first):
            if not _size(chunk):
                break
            told.append(chunk)
        elif not told:
            break
    else:
        return (told if sum(map(_size, told)) == count else []), len(chunks)
    return [], first


def _acts(chunk: Chunk) -> bool:
    """A verb of its own, or "is"."""
    verb = isinstance(chunk, Event) and chunk.form != "ing" and not chunk.nominal
    return verb or chunk.cat in {"aux", "copy"}


def _size(chunk: Chunk) -> int:
    """How many ``a woman``, ``two cars`` are; 0 for those known by name, number or article."""
    if not isinstance(chunk, Mention) or not chunk.heads:
        return 0
    number = chunk.mod("num")
    single = chunk.opened_by("indef") or chunk.is_ego
    return int(number.data["number"]) if number is not None else int(single)


def _in_list(one: Mention) -> bool:
    """Not those who are known by an article ("the van")."""
    return one.is_ego or all(m.value == "indef" for m in one.mods if m.cat in _KNOWN)


def _alike(one: Mention, counted: Mention, tokens: list[Token]) -> bool:
    """Whether somebody can be one of those who were counted."""
    vehicles = tokens[counted.j - 1].base in word_list("generic_words")
    vehicles = (vehicles or counted.noun == "adversary") and one.noun != "pedestrian"
    return vehicles or counted.noun in {one.noun, "driver"}
