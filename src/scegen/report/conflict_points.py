"""Where ways meet on a sketch: a ring where they cross, a diamond where they merge."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from itertools import pairwise
from math import hypot

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
        if not any(_apart(point, other) < _NEAR for _, other in marks):
            marks.append((conflict.kind, point))
    return marks


@lru_cache(maxsize=4096)
def _meeting(kind: ConflictKind, first: _Line, second: _Line) -> Point:
    """Where the two ways meet; the tiles of a gallery ask for the same few again and again."""
    crossing = _crossing(first, second) if kind is ConflictKind.CROSSING else None
    return crossing or _merging(first, second)


def _crossing(first: _Line, second: _Line) -> Point | None:
    """The first point on ``first`` at which the two cross."""
    for a, b in pairwise(first):
        for c, d in pairwise(second):
            found = _intersection(a, b, c, d)
            if found is not None:
                return found
    return None


def _intersection(a: Point, b: Point, c: Point, d: Point) -> Point | None:
    ux, uy, vx, vy = b[0] - a[0], b[1] - a[1], d[0] - c[0], d[1] - c[1]
    turn = ux * vy - uy * vx
    if abs(turn) < 1e-9:
        return None
    wx, wy = c[0] - a[0], c[1] - a[1]
    s, t = (wx * vy - wy * vx) / turn, (wx * uy - wy * ux) / turn
    return (a[0] + s * ux, a[1] + s * uy) if 0 <= s <= 1 and 0 <= t <= 1 else None


def _merging(first: _Line, second: _Line) -> Point:
    """Where ``first`` comes close to ``second``, or else closest."""
    gaps = [(min(_apart(p, q) for q in second), p) for p in first]
    joined = next((p for gap, p in gaps if gap < _MERGED), None)
    return joined if joined is not None else min(gaps)[1]


def _apart(p: Point, q: Point) -> float:
    return hypot(p[0] - q[0], p[1] - q[1])
