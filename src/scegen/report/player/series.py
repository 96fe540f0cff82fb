"""Numbers of a scene, rounded and cut off where they no longer change."""

from collections.abc import Iterable
from math import isfinite
from typing import Any

Data = dict[str, Any]
"""What JSON holds."""


def compact(series: Iterable[float], digits: int) -> list[float | None]:
    """Rounded values, None for those that are undefined; the last is not repeated."""
    values = [round(value, digits) + 0.0 if isfinite(value) else None for value in series]
    while len(values) > 1 and values[-1] == values[-2]:
        values.pop()
    return values


def points(flat: Iterable[float]) -> list[float]:
    """Coordinates in centimetres' precision."""
    return [round(value, 2) + 0.0 for value in flat]
