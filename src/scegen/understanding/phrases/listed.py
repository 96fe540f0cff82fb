"""Those who were counted, one by one: "two pedestrians cross, a woman … and a man …"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention

_ENDS = frozenset({".", ";", "!", "?"})
_OPENS = frozenset({",", ":"})
_MOST = 5
_ANYBODY = frozenset({"car", "driver", "adversary"})


def list_them(chunks: list[Chunk]) -> list[Chunk]:
    """Marks as ``listed`` whom the end of a sentence names one by one, as many as were counted.

    Args:
        chunks: the chunks of the text.
    """
    begin = 0
    for k in range(len(chunks) + 1):
        if k == len(chunks) or chunks[k].value in _ENDS:
            _in_sentence(chunks[begin:k])
            begin = k + 1
    return chunks


def _in_sentence(chunks: list[Chunk]) -> None:
    for k, counted in enumerate(chunks):
        number = counted.mod("num") if isinstance(counted, Mention) else None
        if number is None or not isinstance(counted, Mention) or counted.is_ego:
            continue
        count = int(number.data["number"])
        opens = [m for m in range(k + 1, len(chunks)) if chunks[m].value in _OPENS]
        for m in opens if 1 < count <= _MOST else []:
            rest = chunks[m + 1 :]
            told = [c for c in rest if isinstance(c, Mention)]
            named = len(told) == count and all(t.heads and _single(t) for t in told)
            done = any(isinstance(c, Event) and c.form != "ing" and not c.nominal for c in rest)
            if named and rest[0] is told[0] and not done:
                for one in told if all(_alike(t, counted) for t in told) else []:
                    one.listed = True
                return


def _single(mention: Mention) -> bool:
    """``a woman``."""
    return mention.has("det", "indef") and not mention.is_ego


def _alike(one: Mention, counted: Mention) -> bool:
    """Whether somebody can be one of those who were counted."""
    return one.noun == counted.noun or (counted.noun in _ANYBODY and one.noun != "pedestrian")
