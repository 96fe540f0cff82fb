"""Contact: whether two oriented boxes touch.

Unit: none (True, False); as a time: the first step with contact, s.
Direction: contact is worst.
Source: separating axis theorem for convex polygons (Gottschalk, Lin, Manocha: OBBTree, 1996).
Validity: exact for rectangles at the sampled steps. Between steps a contact can be missed: about
1 % at 0.05 s, so proofs use 0.01 s or less. Contact counts as such from the first shared point.
"""

import numpy as np

from scegen.measures.bodies import body_of
from scegen.measures.boxes import box_between, track_box
from scegen.motion.batch.arrays import Floats, Ints, X, Y
from scegen.motion.batch.kernels import kernel
from scegen.motion.batch.touching import boxes_touch


@kernel
def contact_steps(tracks: Floats, candidate: int, steps: int, bodies: Floats, pairs: Ints) -> Ints:
    """The first of so many steps in which each pair of a candidate touches; -1: none (p,)."""
    found = np.full(pairs.shape[0], -1)
    for p in range(pairs.shape[0]):
        one, two = pairs[p, 0], pairs[p, 1]
        a, b = tracks[candidate, one], tracks[candidate, two]
        body_a, body_b = body_of(bodies, one), body_of(bodies, two)
        # The reference points of two who touch are no farther apart.
        reach = body_a.radius_m + body_b.radius_m + abs(body_a.ahead_m) + abs(body_b.ahead_m)
        for t in range(steps):
            dx, dy = b[X, t] - a[X, t], b[Y, t] - a[Y, t]
            if dx * dx + dy * dy > reach * reach:
                continue
            if boxes_touch(track_box(a, body_a, t), track_box(b, body_b, t)):
                found[p] = t
                break
    return found


@kernel
def first_touches(tracks: Floats, bodies: Floats, pair: Ints, steps: Ints, halvings: int) -> Floats:
    """Where the first contact of a pair lies within the step in which it is seen (c, 9).

    The share of the step, then centre and direction (x, y, cos, sin) of either box at the touch.
    ``pair`` (2,); ``steps`` (c,) are the first with contact of each candidate, halved so often.
    """
    out = np.empty((steps.shape[0], 9))
    body_a, body_b = body_of(bodies, pair[0]), body_of(bodies, pair[1])
    for c in range(steps.shape[0]):
        a, b, t = tracks[c, pair[0]], tracks[c, pair[1]], steps[c]
        low, high = (0.0, 1.0) if t > 0 else (1.0, 1.0)
        for _ in range(halvings if t > 0 else 0):
            share = (low + high) / 2.0
            if boxes_touch(box_between(a, body_a, t, share), box_between(b, body_b, t, share)):
                high = share
            else:
                low = share
        out[c, 0] = high
        one, two = box_between(a, body_a, t, high), box_between(b, body_b, t, high)
        out[c, 1], out[c, 2], out[c, 3], out[c, 4] = one.x, one.y, one.cos, one.sin
        out[c, 5], out[c, 6], out[c, 7], out[c, 8] = two.x, two.y, two.cos, two.sin
    return out
