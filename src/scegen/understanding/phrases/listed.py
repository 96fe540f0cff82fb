"""Those who were counted, one by one: "two pedestrians cross, a woman … and a man …"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention
from scegen.understanding.phrases.lookahead import GOVERNING, cat_at, value_at

_ENDS = frozenset({".", ";", "!", "?"})
_MARKS = {",": ",", ":": ",", "(": ")"}
"""What opens a list, and what closes it before the end of the sentence."""
_COUNTS = frozenset({"det", "num", "quant"})
_ANYBODY = frozenset({"car", "adversary"})


def list_them(chunks: list[Chunk]) -> list[Chunk]:
    """Those named one by one, as many as were counted, take the place of who was counted.

    Behind the verb ("two people cross, a woman and a man") they are marked as ``listed``.

    Args:
        chunks: the chunks of the text.
    """
    found: list[Chunk] = []
    begin = 0
    for k in range(len(chunks) + 1):
        if k == len(chunks) or chunks[k].value in _ENDS:
            found += [*_in_sentence(chunks[begin:k]), *chunks[k : k + 1]]
            begin = k + 1
    return found


def _in_sentence(chunks: list[Chunk]) -> list[Chunk]:
    for k, counted in enumerate(chunks):
        count = _size(counted)
        if not isinstance(counted, Mention) or count < 2 or counted.is_ego:
            continue
        for m in (m for m in range(k + 1, len(chunks)) if chunks[m].value in _MARKS):
            first = m + 1 + (value_at(chunks, m + 1) == "with")
            told, end = _one_by_one(chunks, first, count, _MARKS[chunks[m].value])
            if not told or not all(_alike(t, counted) for t in told):
                continue
            if m == k + 1:  # "three vehicles, a van and two cars, meet"
                told[0].i = counted.i
                for one in told:
                    one.drives = counted.noun == "driver"
                    one.mods = [*one.mods, *(t for t in counted.mods if t.cat not in _COUNTS)]
                return [*chunks[:k], *chunks[first:end], *chunks[end + 1 :]]
            if not any(map(_acts, chunks[end:])):
                for one in told:
                    one.listed = True
                return chunks
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
        if not left and chunk.value == closes:
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


def _alike(one: Mention, counted: Mention) -> bool:
    """Whether somebody can be one of those who were counted."""
    vehicles = counted.noun in _ANYBODY and one.noun != "pedestrian"
    return vehicles or counted.noun in {one.noun, "driver"}
