"""Where ways meet on a sketch: a ring where they cross, a diamond where they merge."""

from collections.abc import Iterable
from functools import lru_cache
from math import dist

import shapely

from scegen.report.plan import Point
from scegen.scenario.logical import Conflict, ConflictKind

_Line = tuple[Point, ...]
_NEAR = 5.0
"""Marks closer than this (px) would hide each other: one is drawn."""
_MERGED = 6.0
"""Two ways have merged where they are as close as this (px)."""


def conflict_points(
    conflicts: Iterable[Conflict], lines: dict[str, list[Point]]
) -> list[tuple[ConflictKind, Point]]:
    """One point for each conflict of two drawn ways that cross or merge."""
    marks: list[tuple[ConflictKind, Point]] = []
    for conflict in conflicts:
        first, second = lines.get(conflict.first), lines.get(conflict.second)
        if first is None or second is None:
            continue
        if conflict.kind not in {ConflictKind.CROSSING, ConflictKind.MERGING}:
            continue
        point = _meeting(conflict.kind, tuple(first), tuple(second))
        if not any(dist(point, other) < _NEAR for _, other in marks):
            marks.append((conflict.kind, point))
    return marks


@lru_cache(maxsize=4096)
def _meeting(kind: ConflictKind, first: _Line, second: _Line) -> Point:
    """Where the two ways meet, first on the first; tiles of a gallery ask for the same few again.

    They cross, or ``first`` comes close to ``second``, or else is closest there.
    """
    way, other = shapely.LineString(first), shapely.LineString(second)
    met = shapely.get_coordinates(shapely.intersection(way, other))
    if kind is ConflictKind.CROSSING and len(met):
        x, y = min(met.tolist(), key=lambda point: way.project(shapely.Point(point)))
        return x, y
    gaps = shapely.distance(shapely.points(first), other)
    near = gaps < _MERGED
    return first[int(near.argmax() if near.any() else gaps.argmin())]
