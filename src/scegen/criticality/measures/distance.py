"""Distance: the shortest distance between two oriented boxes.

Unit: m; 0 in contact.
Direction: smaller is worse.
Source: two disjoint convex polygons are nearest between a corner of one and the other; boxes that
overlap without holding each other's corners ("+") are found by the separating axes first.
Validity: exact for rectangles at the sampled steps.
"""

from __future__ import annotations

from math import inf, sqrt

import numpy as np

from scegen.criticality.bodies import Body, body_of
from scegen.criticality.boxes import Box, box_at
from scegen.criticality.measures.contact import boxes_touch
from scegen.motion.batch.arrays import COS, SIN, Floats, Ints, X, Y
from scegen.motion.batch.kernels import kernel


@kernel
def box_distance(a: Box, b: Box) -> float:
    """Shortest distance between two boxes, m; 0 if they touch."""
    if boxes_touch(a, b):
        return 0.0
    return sqrt(min(_corners_squared(a, b), _corners_squared(b, a)))


@kernel
def _corners_squared(a: Box, b: Box) -> float:
    """Squared distance of the nearest corner of b from a, which holds none of them, m²."""
    dx, dy = b.x - a.x, b.y - a.y
    x, y = dx * a.cos + dy * a.sin, dy * a.cos - dx * a.sin
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
def closest_approach(a: Floats, b: Floats, body_a: Body, body_b: Body) -> tuple[float, int, bool]:
    """Smallest distance (m) of two tracks, the first step that has it, whether it is a contact.

    Looks no further than the first contact.
    """
    # Where the centres are nearest, the boxes nearly are: a bound that spares most steps.
    best_step, nearest = 0, inf
    for t in range(a.shape[1]):
        away = _centres_squared(a, b, body_a.ahead_m, body_b.ahead_m, t)
        if away < nearest:
            best_step, nearest = t, away
    best = box_distance(box_at(a, body_a, best_step), box_at(b, body_b, best_step))
    radii = body_a.radius_m + body_b.radius_m
    for t in range(a.shape[1]):
        away = _centres_squared(a, b, body_a.ahead_m, body_b.ahead_m, t)
        # Further apart than the best even between the circles around the boxes.
        if away > (radii + best) * (radii + best):
            continue
        distance = box_distance(box_at(a, body_a, t), box_at(b, body_b, t))
        if distance < best or (distance == best and t < best_step):
            best, best_step = distance, t
        if distance == 0.0:
            return 0.0, t, True
    return best, best_step, False


@kernel
def _centres_squared(a: Floats, b: Floats, ahead_a: float, ahead_b: float, t: int) -> float:
    """Squared distance between the centres of two boxes at step t, m²."""
    dx = b[X, t] + ahead_b * b[COS, t] - a[X, t] - ahead_a * a[COS, t]
    dy = b[Y, t] + ahead_b * b[SIN, t] - a[Y, t] - ahead_a * a[SIN, t]
    return dx * dx + dy * dy


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
                box_a, box_b = box_at(tracks[c, a], body_a, t), box_at(tracks[c, b], body_b, t)
                out[c, t, p] = box_distance(box_a, box_b)
    return out
