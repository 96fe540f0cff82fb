"""Occlusion: how long one participant is hidden from another, and when it comes into sight.

Definition: the target is hidden while the occluder's box cuts all straight lines from the centre
of the observer's box to the centre and the corners of the target's box. Time of occlusion is the
longest spell of steps without sight; sight begins at the first step after it.
Unit: s.
Direction: a longer occlusion is worse, and so is a later sight.
Source: line of sight between a point and a box (slab test: Kay, Kajiya, 1986); for occlusion as a
layer of perception-related scenarios see ISO 34502.
Validity: flat world, every box as high as the sight line; one occluder at a time: what two hide
together is not seen as hidden. 0 and nan without occlusion; sight is inf if it never comes.
"""

from math import inf, nan

import numpy as np

from scegen.measures.bodies import body_of
from scegen.measures.boxes import track_box
from scegen.motion.batch.arrays import Bools, Floats, Ints
from scegen.motion.batch.kernels import inner_kernel, kernel
from scegen.motion.batch.touching import Box


@inner_kernel
def cuts(box: Box, x0: float, y0: float, x1: float, y1: float) -> bool:
    """Whether a box cuts the straight line between two points (m, world)."""
    ax, ay = x0 - box.x, y0 - box.y
    bx, by = x1 - box.x, y1 - box.y
    low, high = _slab(
        0.0, 1.0, ax * box.cos + ay * box.sin, bx * box.cos + by * box.sin, box.half_length
    )
    if low > high:
        return False
    low, high = _slab(
        low, high, ay * box.cos - ax * box.sin, by * box.cos - bx * box.sin, box.half_width
    )
    return low <= high


@inner_kernel
def _slab(low: float, high: float, start: float, end: float, half: float) -> tuple[float, float]:
    """The part of a line (0 start, 1 end) within -half..half; empty: (1, 0)."""
    step = end - start
    if step == 0.0:
        return (low, high) if abs(start) <= half else (1.0, 0.0)
    one, two = (-half - start) / step, (half - start) / step
    return max(low, min(one, two)), min(high, max(one, two))


@inner_kernel
def hidden(observer: Box, target: Box, occluder: Box) -> bool:
    """Whether the occluder hides the target's centre and corners from the observer's centre."""
    if not cuts(occluder, observer.x, observer.y, target.x, target.y):
        return False
    lx, ly = target.half_length * target.cos, target.half_length * target.sin
    wx, wy = -target.half_width * target.sin, target.half_width * target.cos
    for sign in (-1.0, 1.0):
        for side in (-1.0, 1.0):
            x = target.x + sign * lx + side * wx
            y = target.y + sign * ly + side * wy
            if not cuts(occluder, observer.x, observer.y, x, y):
                return False
    return True


@inner_kernel
def hidden_at(tracks: Floats, bodies: Floats, occlusion: Ints, t: int) -> bool:
    """Whether the target is hidden at step t; ``tracks`` of one candidate (i, row, t)."""
    i, j, k = occlusion[0], occlusion[1], occlusion[2]
    return hidden(
        track_box(tracks[i], body_of(bodies, i), t),
        track_box(tracks[j], body_of(bodies, j), t),
        track_box(tracks[k], body_of(bodies, k), t),
    )


@kernel
def hidden_behind(observer: Floats, target: Floats, things: Floats, half: Floats) -> Bools:
    """Whether each of some things that stand hides a target: [thing, time].

    All are centres and directions (x, y, cosine, sine; time or thing), m; ``half`` the length and
    width of target and things from the centre, m.
    """
    out = np.empty((things.shape[1], target.shape[1]), dtype=np.bool_)
    for n in range(out.shape[0]):
        thing = Box(things[0, n], things[1, n], things[2, n], things[3, n], half[2], half[3])
        for t in range(out.shape[1]):
            eye = Box(observer[0, t], observer[1, t], observer[2, t], observer[3, t], 0.0, 0.0)
            x, y, cos, sin = target[0, t], target[1, t], target[2, t], target[3, t]
            out[n, t] = hidden(eye, Box(x, y, cos, sin, half[0], half[1]), thing)
    return out


@kernel
def occlusion_times(
    tracks: Floats, bodies: Floats, occlusion: Ints, dt_s: float
) -> tuple[float, float]:
    """Length of the longest spell without sight, and when sight follows it, s.

    ``tracks`` of one candidate (i, row, t); ``occlusion`` (3,): observer, target, occluder.
    """
    longest, sight = 0, nan
    spell = 0
    for t in range(tracks.shape[2]):
        if hidden_at(tracks, bodies, occlusion, t):
            spell += 1
            if spell > longest:
                longest, sight = spell, inf
        else:
            if spell > 0 and spell == longest and sight == inf:
                sight = t * dt_s
            spell = 0
    return longest * dt_s, sight


@kernel
def occlusion_series(tracks: Floats, bodies: Floats, occlusions: Ints) -> Bools:
    """Whether the target is hidden at every step: [candidate, time, occlusion].

    ``occlusions`` (q, 3): observer, target, occluder.
    """
    out = np.empty((tracks.shape[0], tracks.shape[3], occlusions.shape[0]), dtype=np.bool_)
    for c in range(out.shape[0]):
        for t in range(out.shape[1]):
            for q in range(out.shape[2]):
                out[c, t, q] = hidden_at(tracks[c], bodies, occlusions[q], t)
    return out
