"""Those who were counted, one by one: "two pedestrians cross, a woman … and a man …"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Word

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
    for k, chunk in enumerate([*chunks, None]):
        if chunk is None or (isinstance(chunk, Word) and chunk.value in _ENDS):
            _in_sentence(chunks[begin:k])
            begin = k + 1
    return chunks


def _in_sentence(chunks: list[Chunk]) -> None:
    for k, counted in enumerate(chunks):
        number = counted.mod("num") if isinstance(counted, Mention) else None
        if number is None or not isinstance(counted, Mention) or counted.is_ego:
            continue
        count = int(min(number.data["number"], _MOST + 1))
        opens = [m for m in range(k + 1, len(chunks)) if getattr(chunks[m], "value", "") in _OPENS]
        for m in opens if 1 < count <= _MOST else []:
            rest = chunks[m + 1 :]
            told = [c for c in rest if isinstance(c, Mention) and c.heads and _single(c)]
            free = [c for c in rest if isinstance(c, Mention) and c.prep is None]
            done = any(isinstance(c, Event) and c.form != "ing" and not c.nominal for c in rest)
            if free == told and len(told) == count and rest[:1] == told[:1] and not done:
                for one in told if all(_alike(t, counted) for t in told) else []:
                    one.listed = True
                return


def _single(mention: Mention) -> bool:
    """``a woman``, free of any preposition."""
    indefinite = any((m.cat, m.value) == ("det", "indef") for m in mention.mods)
    return indefinite and mention.prep is None and not mention.is_ego


def _alike(one: Mention, counted: Mention) -> bool:
    """Whether somebody can be one of those who were counted."""
    kind = counted.head.value if counted.head is not None else ""
    own = one.head.value if one.head is not None else ""
    return own == kind or (kind in _ANYBODY and own != "pedestrian")
