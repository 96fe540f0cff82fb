"""Two-dimensional time to collision: when two boxes would touch if both kept their velocity.

Unit: s; 0 in contact, inf if they would never touch.
Direction: smaller is worse; 1.5 s is the usual threshold.
Source: Hayward, Near-miss determination through use of a scale of danger, 1972; swept boxes by
separating axes with speeds (Eberly, Dynamic collision detection using oriented bounding boxes).
Validity: headings and velocities are held, so in curves it foresees contacts off the lane and
misses contacts on it. Weak at crossings: of runs below 1.5 s, 18 % never came within 5 m; use it
together with PET or distance.
"""

from __future__ import annotations

from math import inf

import numpy as np

from scegen.criticality.bodies import Body, body_of
from scegen.criticality.boxes import Box, box_at
from scegen.motion.batch.arrays import COS, SIN, SPEED, Floats, Ints, X, Y
from scegen.motion.batch.kernels import kernel


@kernel
def box_time_to_collision(a: Box, b: Box, vx: float, vy: float) -> float:
    """When b, moving by (vx, vy) m/s relative to a, first touches a, s; inf for never."""
    dx, dy = b.x - a.x, b.y - a.y
    c = abs(a.cos * b.cos + a.sin * b.sin)
    s = abs(a.cos * b.sin - a.sin * b.cos)
    begin, end = 0.0, inf
    begin, end = _overlap(
        begin,
        end,
        dx * a.cos + dy * a.sin,
        vx * a.cos + vy * a.sin,
        a.half_length + b.half_length * c + b.half_width * s,
    )
    begin, end = _overlap(
        begin,
        end,
        dy * a.cos - dx * a.sin,
        vy * a.cos - vx * a.sin,
        a.half_width + b.half_length * s + b.half_width * c,
    )
    begin, end = _overlap(
        begin,
        end,
        dx * b.cos + dy * b.sin,
        vx * b.cos + vy * b.sin,
        b.half_length + a.half_length * c + a.half_width * s,
    )
    begin, end = _overlap(
        begin,
        end,
        dy * b.cos - dx * b.sin,
        vy * b.cos - vx * b.sin,
        b.half_width + a.half_length * s + a.half_width * c,
    )
    return begin if begin <= end else inf


@kernel
def _overlap(
    begin: float, end: float, offset: float, speed: float, reach: float
) -> tuple[float, float]:
    """The part of a span of time in which the shadows on one axis overlap; empty: (inf, -inf)."""
    if begin > end:
        return begin, end
    if speed == 0.0:
        return (begin, end) if abs(offset) <= reach else (inf, -inf)
    one, two = (-reach - offset) / speed, (reach - offset) / speed
    return max(begin, min(one, two)), min(end, max(one, two))


@kernel
def least_time_to_collision(a: Floats, b: Floats, body_a: Body, body_b: Body, last: int) -> float:
    """Smallest time to collision of two tracks over the steps 0 to ``last``, s."""
    best = inf
    radii = body_a.radius_m + body_b.radius_m
    for t in range(last, -1, -1):  # the smallest is mostly late, and small ones spare the rest
        dx = b[X, t] + body_b.ahead_m * b[COS, t] - a[X, t] - body_a.ahead_m * a[COS, t]
        dy = b[Y, t] + body_b.ahead_m * b[SIN, t] - a[Y, t] - body_a.ahead_m * a[SIN, t]
        vx = b[SPEED, t] * b[COS, t] - a[SPEED, t] * a[COS, t]
        vy = b[SPEED, t] * b[SIN, t] - a[SPEED, t] * a[SIN, t]
        away = dx * dx + dy * dy
        if away > radii * radii:
            # Outside each other's circles: most pairs move apart, pass by, or come too late.
            if dx * vx + dy * vy >= 0.0:
                continue
            cross = dx * vy - dy * vx
            if cross * cross > radii * radii * (vx * vx + vy * vy):
                continue
            reach = radii + best * (a[SPEED, t] + b[SPEED, t])
            if away > reach * reach:
                continue
        time = box_time_to_collision(box_at(a, body_a, t), box_at(b, body_b, t), vx, vy)
        best = min(best, time)
    return best


@kernel
def time_to_collision_series(tracks: Floats, bodies: Floats, pairs: Ints) -> Floats:
    """Time to collision at every step, s: [candidate, time, pair]."""
    candidates, steps = tracks.shape[0], tracks.shape[3]
    out = np.empty((candidates, steps, pairs.shape[0]))
    for c in range(candidates):
        for p in range(pairs.shape[0]):
            a, b = tracks[c, pairs[p, 0]], tracks[c, pairs[p, 1]]
            body_a, body_b = body_of(bodies, pairs[p, 0]), body_of(bodies, pairs[p, 1])
            for t in range(steps):
                vx = b[SPEED, t] * b[COS, t] - a[SPEED, t] * a[COS, t]
                vy = b[SPEED, t] * b[SIN, t] - a[SPEED, t] * a[SIN, t]
                out[c, t, p] = box_time_to_collision(
                    box_at(a, body_a, t), box_at(b, body_b, t), vx, vy
                )
    return out
