"""Which lane of several words name by its number."""

from __future__ import annotations

from scegen.understanding.chunks import Place
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.ordinals import POSITIONS
from scegen.understanding.words.tokens import Token

EITHER = "either"
"""The side from which lanes are counted where that is not said."""
FROM_SIDE = 3
"""Words of "from the left"."""
_MOST = 6


def lane_number(place: object, tokens: list[Token]) -> int | None:
    """``lane 2``, ``the third lane``; None for what has no number."""
    if not isinstance(place, Place) or place.kind != "lane" or place.head is None:
        return None
    if "number" in place.head.data:
        return int(place.head.data["number"])
    last = number_at(tokens, place.j - 1)
    if last is not None and place.j > place.head.j and 0 < last.value <= _MOST:
        return int(last.value)
    first = POSITIONS.get(tokens[place.head.i].low, -1)
    return first + 1 if first >= 0 else None


def counted_from(j: int, tokens: list[Token]) -> str:
    """``the third lane from the right``."""
    after = [t.low for t in tokens[j : j + FROM_SIDE]]
    return after[-1] if after[:2] == ["from", "the"] and after[-1] in {"left", "right"} else EITHER
