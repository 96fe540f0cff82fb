"""Participants' oriented boxes: their frames over time, and the box at one moment."""

from math import sqrt
from typing import NamedTuple

import numpy as np

from scegen.measures.bodies import Body, body_of
from scegen.motion.batch.arrays import COS, SIN, SPEED, Floats, X, Y
from scegen.motion.batch.kernels import inner_kernel, kernel
from scegen.motion.batch.touching import Box

CX, CY, DX, DY, VX, VY = range(6)
"""Rows of a frame: centre (m, world), direction (cosine and sine of heading), velocity (m/s)."""
FRAME_ROWS = 6


class Way(NamedTuple):
    """The arrays of a path (see ``motion.model.Path``)."""

    s_m: Floats
    x_m: Floats
    y_m: Floats
    heading_rad: Floats


@kernel
def frames_of(tracks: Floats, bodies: Floats) -> Floats:
    """The frames of one candidate's participants: (participant, row, step).

    The velocity is that of the reference point, along the heading.
    """
    frames = np.empty((tracks.shape[0], FRAME_ROWS, tracks.shape[2]))
    write_frames(tracks, bodies, frames)
    return frames


@kernel
def write_frames(tracks: Floats, bodies: Floats, frames: Floats) -> None:
    """Write the frames of one candidate's participants into existing room."""
    for i in range(tracks.shape[0]):
        ahead = body_of(bodies, i).ahead_m
        track, frame = tracks[i], frames[i]
        for t in range(tracks.shape[2]):
            c, s, speed = track[COS, t], track[SIN, t], track[SPEED, t]
            frame[CX, t] = track[X, t] + ahead * c
            frame[CY, t] = track[Y, t] + ahead * s
            frame[DX, t], frame[DY, t] = c, s
            frame[VX, t], frame[VY, t] = speed * c, speed * s


@kernel
def write_separations(a: Floats, b: Floats, squared_m2: Floats) -> None:
    """Write the squared distance between the centres of two frames for every step, m²."""
    for t in range(squared_m2.shape[0]):
        dx, dy = b[CX, t] - a[CX, t], b[CY, t] - a[CY, t]
        squared_m2[t] = dx * dx + dy * dy


@inner_kernel
def box_at(frame: Floats, half_length_m: float, half_width_m: float, t: int) -> Box:
    """The box of a frame (row, step) at step t."""
    return Box(frame[CX, t], frame[CY, t], frame[DX, t], frame[DY, t], half_length_m, half_width_m)


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
