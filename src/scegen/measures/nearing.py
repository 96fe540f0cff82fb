"""Nearing: whether two bodies on their ways, each by its timetable, ever come near each other.

Unit: none (True, False).
Validity: at sampled times only; looked at closely where the bodies' centres are near. How near the
boxes are is the greatest free distance along a side of either (separating axes), at most the true
distance.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scegen.measures.boxes import Way, way_box
from scegen.motion.batch.arrays import Floats
from scegen.motion.batch.between import before, between
from scegen.motion.batch.kernels import inner_kernel, kernel
from scegen.motion.batch.touching import Box

_FINE_S, _COARSE_S = 0.05, 0.4
_FINE_STEPS = round(_COARSE_S / _FINE_S)
_TURNING = 2.0
"""A side that swings round nears faster than the centre, by no more than so many times."""


class Timetable(NamedTuple):
    """When a body is where, on the clock of its own drive, which begins ``late_s`` on the common.

    ``time_s`` and ``way_m`` rise; before the first time it drives ``first_mps``, and never more
    than ``fastest_mps``. The way of its reference point is given as in ``Path``, and goes straight
    on at both ends.
    """

    time_s: Floats
    way_m: Floats
    first_mps: float
    fastest_mps: float
    late_s: float
    s_m: Floats
    x_m: Floats
    y_m: Floats
    heading_rad: Floats
    ahead_m: float
    half_length_m: float
    half_width_m: float


@inner_kernel
def _box(table: Timetable, time_s: float) -> Box:
    """The box of a body at a time."""
    own = min(time_s - table.late_s, table.time_s[-1])
    way = table.way_m[0] + own * table.first_mps
    if own > table.time_s[0]:
        n = before(table.time_s, own)
        share = (own - table.time_s[n]) / (table.time_s[n + 1] - table.time_s[n])
        way = between(table.way_m, n, share)
    on = min(max(way, table.s_m[0]), table.s_m[-1])
    path = Way(table.s_m, table.x_m, table.y_m, table.heading_rad)
    ahead = table.ahead_m + way - on
    return way_box(path, on, ahead, table.half_length_m, table.half_width_m)


@inner_kernel
def _free_m(a: Box, b: Box) -> float:
    """The greatest free distance along a side of the first box; below 0 where none is free."""
    dx, dy = b.x - a.x, b.y - a.y
    c = abs(a.cos * b.cos + a.sin * b.sin)
    s = abs(a.cos * b.sin - a.sin * b.cos)
    along = abs(dx * a.cos + dy * a.sin) - a.half_length - b.half_length * c - b.half_width * s
    across = abs(dy * a.cos - dx * a.sin) - a.half_width - b.half_length * s - b.half_width * c
    return max(along, across)


@inner_kernel
def _on_to(more_m: float, step_m: float) -> int:
    """How many steps on they may be near at the soonest, who near by no more in one of them."""
    return max(1, int(more_m / step_m))


@kernel
def come_near(
    one: Timetable, two: Timetable, begins_s: float, ends_s: float, within_m: float
) -> bool:
    """Whether two come within a distance of each other between two times."""
    closing_mps = max(1.0, one.fastest_mps + two.fastest_mps)
    coarse_m, fine_m = closing_mps * _COARSE_S, _TURNING * closing_mps * _FINE_S
    reach = 2.0 * (one.half_length_m + two.half_length_m) + coarse_m / 2
    steps, n = int(np.ceil((ends_s - begins_s) / _COARSE_S)), 0
    while n < steps:
        coarse = begins_s + n * _COARSE_S
        a, b = _box(one, coarse), _box(two, coarse)
        more_m = np.hypot(b.x - a.x, b.y - a.y) - reach
        if more_m >= 0.0:
            n += _on_to(more_m, coarse_m)
            continue
        m = 0
        while m < _FINE_STEPS:
            a, b = _box(one, coarse + m * _FINE_S), _box(two, coarse + m * _FINE_S)
            more_m = max(_free_m(a, b), _free_m(b, a)) - within_m
            if more_m < 0.0:
                return True
            m += _on_to(more_m, fine_m)
        n += 1
    return False
