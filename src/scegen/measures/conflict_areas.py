"""Where two paths get in each other's way: conflict areas and merge points, found once per pair.

The set of positions (s of one, s of the other) at which the two boxes touch falls apart into
regions. A region where the paths cross, or meet head on, is a conflict area: its extent along
either path is from where the front enters the ground that the other's box sweeps to where the
rear leaves it. Where the paths merge, the shared lane is no useful area (both drive on in it);
there the "area" is the merge point: entered by the front, left by the rear. Where one path
follows the other from a start on, there is none.
"""

from collections.abc import Sequence
from math import inf
from typing import NamedTuple

import numpy as np

from scegen.measures.bodies import Body, body_of
from scegen.measures.boxes import Way, way_box
from scegen.measures.merging import merge_point
from scegen.measures.nearest import longest_step_m, on_to
from scegen.measures.remembering import remembered
from scegen.motion.batch.arrays import Bools, Floats, Ints
from scegen.motion.batch.kernels import inner_kernel, kernel
from scegen.motion.batch.touching import Box, boxes_touch
from scegen.motion.model import Path

SAMPLING_M = 0.5
"""Coarsest spacing of sampled positions; half the smallest side where that is less."""
PRECISION_M = 1e-3
"""Precision of the entry and exit positions."""


class AreaTable(NamedTuple):
    """Areas ``first[p]`` to ``first[p+1] - 1`` belong to pair p.

    ``enter_m`` and ``leave_m`` (areas, 2): the positions along the path of the first and the
    second of the pair at which it enters and has left the area, m; it has never left (inf) where
    its path ends inside.
    """

    first: Ints
    enter_m: Floats
    leave_m: Floats


class _Sampled(NamedTuple):
    """Boxes along a path: positions s, centres, directions; and the half sides."""

    s: Floats
    x: Floats
    y: Floats
    cos: Floats
    sin: Floats
    half_length: float
    half_width: float


def area_table(
    paths: Sequence[Path], bodies: Floats, pairs: Sequence[tuple[int, int]]
) -> AreaTable:
    """The conflict areas of these pairs."""
    found = [_areas(paths[a], paths[b], body_of(bodies, a), body_of(bodies, b)) for a, b in pairs]
    rows = [row for areas in found for row in areas]
    table = np.array(rows, dtype=np.float64).reshape(-1, 4)
    first = np.concatenate(([0], np.cumsum([len(areas) for areas in found], dtype=np.int64)))
    return AreaTable(first.astype(np.int64), table[:, :2].copy(), table[:, 2:].copy())


@remembered
def _areas(first: Path, second: Path, a: Body, b: Body) -> list[tuple[float, float, float, float]]:
    """(enter a, enter b, leave a, leave b) of each area of a pair."""
    small = min(a.half_length_m, a.half_width_m, b.half_length_m, b.half_width_m)
    spacing = min(SAMPLING_M, small)
    one, two = _sample(first, a, spacing), _sample(second, b, spacing)
    result = []
    for rows, columns in _regions(touching(one, two)):
        merge = merge_point(first, second, one.s[rows], two.s[columns])
        if merge is None:
            own, other = _cut(one, rows), _cut(two, columns)
            enter_a, leave_a = _extent(first, a, one.s, rows, other)
            enter_b, leave_b = _extent(second, b, two.s, columns, own)
            result.append((enter_a, enter_b, leave_a, leave_b))
        elif min(merge) > SAMPLING_M and not _comes_backwards(first, second, merge):
            sa, sb = merge
            result.append((sa - a.front_m, sb - b.front_m, sa + a.rear_m, sb + b.rear_m))
    return result


def _comes_backwards(first: Path, second: Path, merge: tuple[float, float]) -> bool:
    """Whether one of two drives backwards where their ways merge: its front does not come first."""
    return any(
        begins <= place <= ends
        for path, place in zip((first, second), merge, strict=True)
        for begins, ends in path.backwards
    )


@remembered
def _sample(path: Path, body: Body, spacing: float) -> _Sampled:
    count = int(np.ceil(path.length_m / spacing)) + 1
    return _at(path, body, np.linspace(0.0, path.length_m, count))


def _at(path: Path, body: Body, s: Floats) -> _Sampled:
    x, y, heading = path.places(s)
    cos, sin = np.cos(heading), np.sin(heading)
    x, y = x + body.ahead_m * cos, y + body.ahead_m * sin
    return _Sampled(s, x, y, cos, sin, body.half_length_m, body.half_width_m)


def _cut(boxes: _Sampled, part: slice) -> _Sampled:
    """The boxes of a part and one more at either end."""
    return _part(boxes, slice(max(part.start - 1, 0), part.stop + 1))


def _part(boxes: _Sampled, part: slice) -> _Sampled:
    s, x, y, cos, sin = (array[part] for array in boxes[:5])
    return _Sampled(s, x, y, cos, sin, boxes.half_length, boxes.half_width)


@inner_kernel
def _reach_m2(one: _Sampled, two: _Sampled) -> float:
    """The squared distance within which boxes may touch."""
    reach = np.hypot(one.half_length, one.half_width) + np.hypot(two.half_length, two.half_width)
    return float(reach * reach)


@inner_kernel
def _touches_any(box: Box, other: _Sampled) -> bool:
    """Whether a box touches one of the other's."""
    for n in range(other.x.shape[0]):
        b = Box(
            other.x[n], other.y[n], other.cos[n], other.sin[n], other.half_length, other.half_width
        )
        if boxes_touch(box, b):
            return True
    return False


@kernel
def touching(one: _Sampled, two: _Sampled) -> Bools:
    """Whether box m of one and box n of the other touch: (m, n)."""
    result = np.zeros((one.x.shape[0], two.x.shape[0]), dtype=np.bool_)
    reach, step_m = _reach_m2(one, two), longest_step_m(two.x, two.y)
    for m in range(one.x.shape[0]):
        a = Box(one.x[m], one.y[m], one.cos[m], one.sin[m], one.half_length, one.half_width)
        n = 0
        while n < two.x.shape[0]:
            dx, dy = two.x[n] - a.x, two.y[n] - a.y
            squared = dx * dx + dy * dy
            if squared <= reach:
                b = Box(two.x[n], two.y[n], two.cos[n], two.sin[n], two.half_length, two.half_width)
                result[m, n] = boxes_touch(a, b)
            n += on_to(squared, reach, step_m)
    return result


def _regions(touch: Bools) -> list[tuple[slice, slice]]:
    """Row and column ranges of the parts into which the touching positions fall."""
    waiting = [(slice(0, touch.shape[0]), slice(0, touch.shape[1]))]
    done: list[tuple[slice, slice]] = []
    while waiting:
        rows, columns = waiting.pop()
        parts = [
            (r, c)
            for r in _runs(np.logical_or.reduce(touch[rows, columns], axis=1), rows.start)
            for c in _runs(np.logical_or.reduce(touch[r, columns], axis=0), columns.start)
        ]
        if len(parts) == 1:
            done += parts
        else:
            waiting += parts
    return sorted(done, key=lambda part: (part[0].start, part[1].start))


def _runs(flags: Bools, offset: int) -> list[slice]:
    """Runs of True as slices, counted from ``offset``."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], flags, [False])).astype(np.int8)))
    return [
        slice(int(a) + offset, int(b) + offset)
        for a, b in zip(edges[::2], edges[1::2], strict=True)
    ]


def _extent(path: Path, body: Body, s: Floats, run: slice, other: _Sampled) -> tuple[float, float]:
    """Where one enters and leaves the ground that the other's boxes cover.

    One whose path ends there stops there: it never leaves (inf).
    """
    enter, leave = float(s[run.start]), inf
    if run.start > 0:
        enter = _edge(path, body, float(s[run.start - 1]), enter, other)
    if run.stop < len(s):
        leave = _edge(path, body, float(s[run.stop]), float(s[run.stop - 1]), other)
    return enter, leave


def _edge(path: Path, body: Body, free: float, touches: float, other: _Sampled) -> float:
    """The position between a free and a touching one at which touching begins."""
    way = Way(path.s_m, path.x_m, path.y_m, path.heading_rad)
    return float(_touches_from(way, body, free, touches, other))


@kernel
def _touches_from(way: Way, body: Body, free: float, touches: float, other: _Sampled) -> float:
    """By bisection."""
    while abs(touches - free) > PRECISION_M:
        middle = (free + touches) / 2
        box = way_box(way, middle, body.ahead_m, body.half_length_m, body.half_width_m)
        if _touches_any(box, other):
            touches = middle
        else:
            free = middle
    return touches
