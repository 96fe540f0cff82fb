"""Participants' oriented boxes at one moment, and how they lie and move to one another."""

from math import sqrt
from typing import NamedTuple

import numpy as np

from scegen.measures.bodies import Body
from scegen.motion.batch.arrays import COS, SIN, SPEED, Floats, X, Y
from scegen.motion.batch.kernels import inner_kernel
from scegen.motion.batch.touching import Box


class Way(NamedTuple):
    """The arrays of a path (see ``motion.model.Path``)."""

    s_m: Floats
    x_m: Floats
    y_m: Floats
    heading_rad: Floats


@inner_kernel
def between_centres(
    a: Floats, b: Floats, ahead_a_m: float, ahead_b_m: float, t: int
) -> tuple[float, float]:
    """From the centre of a to that of b at step t of their tracks (row, step), m, world."""
    dx = b[X, t] + ahead_b_m * b[COS, t] - (a[X, t] + ahead_a_m * a[COS, t])
    return dx, b[Y, t] + ahead_b_m * b[SIN, t] - (a[Y, t] + ahead_a_m * a[SIN, t])


@inner_kernel
def relative_velocity(a: Floats, b: Floats, t: int) -> tuple[float, float]:
    """Velocity of b relative to a at step t, m/s, world: those of the reference points."""
    vx = b[SPEED, t] * b[COS, t] - a[SPEED, t] * a[COS, t]
    return vx, b[SPEED, t] * b[SIN, t] - a[SPEED, t] * a[SIN, t]


@inner_kernel
def way_box(way: Way, s_m: float, ahead_m: float, half_length_m: float, half_width_m: float) -> Box:
    """The box of a body whose reference point is at ``s_m`` of a way, its centre ahead of that."""
    n = before(way.s_m, s_m)
    share = (s_m - way.s_m[n]) / (way.s_m[n + 1] - way.s_m[n])
    heading = between(way.heading_rad, n, share)
    c, s = np.cos(heading), np.sin(heading)
    x = between(way.x_m, n, share) + ahead_m * c
    y = between(way.y_m, n, share) + ahead_m * s
    return Box(x, y, c, s, half_length_m, half_width_m)


@inner_kernel
def track_box(track: Floats, body: Body, t: int) -> Box:
    """The box of a body at step t of its track (row, step)."""
    cos, sin = track[COS, t], track[SIN, t]
    x, y = track[X, t] + body.ahead_m * cos, track[Y, t] + body.ahead_m * sin
    return Box(x, y, cos, sin, body.half_length_m, body.half_width_m)


@inner_kernel
def box_between(track: Floats, body: Body, t: int, share: float) -> Box:
    """The box part of the way from the step before t (share 0) to step t (1)."""
    one, two = track_box(track, body, max(t - 1, 0)), track_box(track, body, t)
    cos, sin = one.cos + share * (two.cos - one.cos), one.sin + share * (two.sin - one.sin)
    length = sqrt(cos * cos + sin * sin)
    x, y = one.x + share * (two.x - one.x), one.y + share * (two.y - one.y)
    return Box(x, y, cos / length, sin / length, body.half_length_m, body.half_width_m)


@inner_kernel
def before(values: Floats, value: float) -> int:
    """The last place, but for the end, at which rising values are not above one; 0 if none is."""
    place = np.searchsorted(values, value, side="right") - 1
    return int(min(max(place, 0), values.shape[0] - 2))


@inner_kernel
def between(values: Floats, place: int, share: float) -> float:
    """The value so far from one place to the next."""
    return float(values[place] + share * (values[place + 1] - values[place]))
