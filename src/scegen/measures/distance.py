"""Distance: the shortest distance between two oriented boxes.

Unit: m; 0 in contact.
Direction: smaller is worse.
Source: two disjoint convex polygons are nearest between a corner of one and the other; boxes that
overlap without holding each other's corners ("+") are found by the separating axes first.
Validity: exact for rectangles at the sampled steps.
"""

from math import inf, sqrt

import numpy as np

from scegen.measures.bodies import Body, body_of
from scegen.measures.boxes import between_centres, track_box
from scegen.motion.batch.arrays import Floats, Ints
from scegen.motion.batch.kernels import inner_kernel, kernel
from scegen.motion.batch.touching import Box, boxes_touch, place_in


@inner_kernel
def box_distance(a: Box, b: Box) -> float:
    """Shortest distance between two boxes, m; 0 if they touch."""
    if boxes_touch(a, b):
        return 0.0
    return sqrt(min(_corners_squared(a, b), _corners_squared(b, a)))


@inner_kernel
def _corners_squared(a: Box, b: Box) -> float:
    """Squared distance of the nearest corner of b from a, which holds none of them, m²."""
    x, y = place_in(a, b)
    c = a.cos * b.cos + a.sin * b.sin
    s = a.cos * b.sin - a.sin * b.cos
    lx, ly = b.half_length * c, b.half_length * s
    wx, wy = -b.half_width * s, b.half_width * c
    nearest = inf
    for sign in (-1.0, 1.0):
        for side in (-1.0, 1.0):
            gx = max(abs(x + sign * lx + side * wx) - a.half_length, 0.0)
            gy = max(abs(y + sign * ly + side * wy) - a.half_width, 0.0)
            nearest = min(nearest, gx * gx + gy * gy)
    return nearest


@kernel
def closest_approach(
    a: Floats, b: Floats, body_a: Body, body_b: Body, squared_m2: Floats
) -> tuple[float, int, bool]:
    """Smallest distance (m) of two tracks, the first step that has it, whether it is a contact.

    Looks no further than the first contact. ``squared_m2`` (steps,) is room to work in.
    """
    # Where the centres are nearest, the boxes nearly are: a bound that spares most steps.
    best_step = 0
    for t in range(squared_m2.shape[0]):
        dx, dy = between_centres(a, b, body_a.ahead_m, body_b.ahead_m, t)
        squared_m2[t] = dx * dx + dy * dy
        if squared_m2[t] < squared_m2[best_step]:
            best_step = t
    best = _distance_at(a, b, body_a, body_b, best_step)
    radii = body_a.radius_m + body_b.radius_m
    for t in range(squared_m2.shape[0]):
        # Further apart than the best even between the circles around the boxes.
        if squared_m2[t] > (radii + best) * (radii + best):
            continue
        distance = _distance_at(a, b, body_a, body_b, t)
        if distance < best or (distance == best and t < best_step):
            best, best_step = distance, t
        if distance == 0.0:
            return 0.0, t, True
    return best, best_step, False


@inner_kernel
def _distance_at(a: Floats, b: Floats, body_a: Body, body_b: Body, t: int) -> float:
    """Distance of two tracks at step t, m."""
    return box_distance(track_box(a, body_a, t), track_box(b, body_b, t))


@kernel
def distance_series(tracks: Floats, bodies: Floats, pairs: Ints) -> Floats:
    """Distance at every step, m: [candidate, time, pair]."""
    candidates, steps = tracks.shape[0], tracks.shape[3]
    out = np.empty((candidates, steps, pairs.shape[0]))
    for c in range(candidates):
        for p in range(pairs.shape[0]):
            a, b = pairs[p, 0], pairs[p, 1]
            body_a, body_b = body_of(bodies, a), body_of(bodies, b)
            for t in range(steps):
                out[c, t, p] = _distance_at(tracks[c, a], tracks[c, b], body_a, body_b, t)
    return out


@kernel
def distances_at(tracks: Floats, bodies: Floats, pair: Ints, steps: Ints) -> Floats:
    """Distance of a pair (2,) at some steps of each candidate, m: [candidate, n], as the steps."""
    out = np.empty(steps.shape)
    one, two = pair[0], pair[1]
    body_a, body_b = body_of(bodies, one), body_of(bodies, two)
    for c in range(steps.shape[0]):
        for n in range(steps.shape[1]):
            t = min(max(steps[c, n], 0), tracks.shape[3] - 1)
            out[c, n] = _distance_at(tracks[c, one], tracks[c, two], body_a, body_b, t)
    return out
