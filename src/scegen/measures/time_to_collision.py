"""Two-dimensional time to collision: when two boxes would touch if both kept their velocity.

Unit: s; 0 in contact, inf if they would never touch.
Direction: smaller is worse; 1.5 s is the usual threshold (FHWA-HRT-08-051).
Source: Hayward, Near-miss determination through use of a scale of danger, 1972; swept boxes by
separating axes with speeds (Eberly, Dynamic collision detection using oriented bounding boxes).
Validity: headings and velocities are held, so in curves it foresees contacts off the lane and
misses contacts on it. Weak at crossings: of runs below 1.5 s, 18 % never came within 5 m; use it
together with PET or distance.
"""

from math import inf

import numpy as np

from scegen.measures.bodies import Body, body_of
from scegen.measures.boxes import between_centres, relative_velocity, track_box
from scegen.motion.batch.arrays import Floats, Ints
from scegen.motion.batch.kernels import inner_kernel, kernel
from scegen.motion.batch.touching import Box


@inner_kernel
def box_time_to_collision(a: Box, b: Box, vx: float, vy: float) -> float:
    """When b, moving by (vx, vy) m/s relative to a, first touches a, s; inf for never."""
    dx, dy = b.x - a.x, b.y - a.y
    begin, end = _over_axes_of(a, b, dx, dy, vx, vy, 0.0, inf)
    begin, end = _over_axes_of(b, a, dx, dy, vx, vy, begin, end)
    return begin if begin <= end else inf


@inner_kernel
def _over_axes_of(
    a: Box, b: Box, dx: float, dy: float, vx: float, vy: float, begin: float, end: float
) -> tuple[float, float]:
    """The part of a span of time in which the shadows on both axes of a box overlap."""
    c = abs(a.cos * b.cos + a.sin * b.sin)
    s = abs(a.cos * b.sin - a.sin * b.cos)
    reach = a.half_length + b.half_length * c + b.half_width * s
    place, speed = dx * a.cos + dy * a.sin, vx * a.cos + vy * a.sin
    begin, end = _overlap(begin, end, place, speed, reach)
    reach = a.half_width + b.half_length * s + b.half_width * c
    place, speed = dy * a.cos - dx * a.sin, vy * a.cos - vx * a.sin
    return _overlap(begin, end, place, speed, reach)


@inner_kernel
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
def least_time_to_collision(
    a: Floats, b: Floats, body_a: Body, body_b: Body, last: int, worth_m2: Floats
) -> float:
    """Smallest time to collision of two tracks over the steps 0 to ``last``, s.

    ``worth_m2`` (steps,) is room to work in.
    """
    best = inf
    radii = body_a.radius_m + body_b.radius_m
    _write_worth(a, b, body_a, body_b, worth_m2[: last + 1])
    for t in range(last, -1, -1):  # the smallest is mostly late, and small ones spare the rest
        if worth_m2[t] == inf:
            continue
        vx, vy = relative_velocity(a, b, t)
        # Too far to touch earlier than the best, even between the circles around the boxes.
        reach = radii + best * (abs(vx) + abs(vy))
        if worth_m2[t] <= reach * reach:
            best = min(best, _time_at(a, b, body_a, body_b, t))
    return best


@kernel
def _write_worth(a: Floats, b: Floats, body_a: Body, body_b: Body, worth_m2: Floats) -> None:
    """Squared distance of the centres where the circles around the boxes will touch, else inf.

    No branches, so that the processor takes several steps at once.
    """
    radii = body_a.radius_m + body_b.radius_m
    for t in range(worth_m2.shape[0]):
        dx, dy = between_centres(a, b, body_a.ahead_m, body_b.ahead_m, t)
        vx, vy = relative_velocity(a, b, t)
        away = dx * dx + dy * dy
        cross = dx * vy - dy * vx
        meets = cross * cross <= radii * radii * (vx * vx + vy * vy)
        worth = (away <= radii * radii) | (meets & (dx * vx + dy * vy < 0.0))
        worth_m2[t] = away if worth else inf


@inner_kernel
def _time_at(a: Floats, b: Floats, body_a: Body, body_b: Body, t: int) -> float:
    """Time to collision of two tracks at step t, s."""
    vx, vy = relative_velocity(a, b, t)
    return box_time_to_collision(track_box(a, body_a, t), track_box(b, body_b, t), vx, vy)


@kernel
def time_to_collision_series(tracks: Floats, bodies: Floats, pairs: Ints) -> Floats:
    """Time to collision at every step, s: [candidate, time, pair]."""
    candidates, steps = tracks.shape[0], tracks.shape[3]
    out = np.empty((candidates, steps, pairs.shape[0]))
    for c in range(candidates):
        for p in range(pairs.shape[0]):
            a, b = pairs[p, 0], pairs[p, 1]
            body_a, body_b = body_of(bodies, a), body_of(bodies, b)
            for t in range(steps):
                out[c, t, p] = _time_at(tracks[c, a], tracks[c, b], body_a, body_b, t)
    return out
