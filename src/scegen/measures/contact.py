"""Contact: whether two oriented boxes touch.

Unit: none (True, False); as a time: the first step with contact, s.
Direction: contact is worst.
Source: separating axis theorem for convex polygons (Gottschalk, Lin, Manocha: OBBTree, 1996).
Validity: exact for rectangles at the sampled steps. Between steps a contact can be missed: about
1 % at 0.05 s, so proofs use 0.01 s or less. Contact counts as such from the first shared point.
"""

from __future__ import annotations

import numpy as np

from scegen.measures.bodies import body_of
from scegen.measures.boxes import Box, box_at, frames_of
from scegen.motion.batch.arrays import Bools, Floats, Ints
from scegen.motion.batch.kernels import inner_kernel, kernel


@inner_kernel
def boxes_touch(a: Box, b: Box) -> bool:
    """Whether two boxes share a point: no side of either separates them."""
    dx, dy = b.x - a.x, b.y - a.y
    c = abs(a.cos * b.cos + a.sin * b.sin)
    s = abs(a.cos * b.sin - a.sin * b.cos)
    if abs(dx * a.cos + dy * a.sin) > a.half_length + b.half_length * c + b.half_width * s:
        return False
    if abs(dy * a.cos - dx * a.sin) > a.half_width + b.half_length * s + b.half_width * c:
        return False
    if abs(dx * b.cos + dy * b.sin) > b.half_length + a.half_length * c + a.half_width * s:
        return False
    return bool(abs(dy * b.cos - dx * b.sin) <= b.half_width + a.half_length * s + a.half_width * c)


@kernel
def contact_series(tracks: Floats, bodies: Floats, pairs: Ints) -> Bools:
    """Contact at every step: [candidate, time, pair]."""
    candidates, steps = tracks.shape[0], tracks.shape[3]
    out = np.empty((candidates, steps, pairs.shape[0]), dtype=np.bool_)
    for c in range(candidates):
        frames = frames_of(tracks[c], bodies)
        for p in range(pairs.shape[0]):
            a, b = pairs[p, 0], pairs[p, 1]
            body_a, body_b = body_of(bodies, a), body_of(bodies, b)
            for t in range(steps):
                box_a = box_at(frames[a], body_a.half_length_m, body_a.half_width_m, t)
                box_b = box_at(frames[b], body_b.half_length_m, body_b.half_width_m, t)
                out[c, t, p] = boxes_touch(box_a, box_b)
    return out
