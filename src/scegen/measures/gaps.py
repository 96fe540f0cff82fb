"""Gap to the leader: what headway and DRAC start from.

Definition: distance along the follower's path from its front to the leader's rear.
Unit: m.
Direction: smaller is worse.
Source: clear gap as in UN R157.
Validity: undefined (nan) where neither lies ahead in the other's corridor; see
``scegen.measures.following``.
"""

from __future__ import annotations

from math import nan

import numpy as np

from scegen.measures.bodies import body_of
from scegen.measures.following import FollowTable, write_gaps
from scegen.motion.batch.arrays import Floats, Ints
from scegen.motion.batch.kernels import kernel


@kernel
def gap_series(
    tracks: Floats, bodies: Floats, pairs: Ints, following: FollowTable
) -> tuple[Floats, Ints]:
    """Gap from follower to leader, m (nan: neither follows), and who follows (0, 1; -1: none).

    Both [candidate, time, pair]; who: the first or the second of the pair.
    """
    candidates, steps = tracks.shape[0], tracks.shape[3]
    out = np.full((candidates, steps, pairs.shape[0]), nan)
    who = np.full((candidates, steps, pairs.shape[0]), -1, dtype=np.int64)
    gaps = np.empty(steps)
    for c in range(candidates):
        for p in range(pairs.shape[0]):
            for way in range(2):
                f = pairs[p, way]
                front, first = body_of(bodies, f).front_m, following.first[p, way]
                if write_gaps(
                    tracks[c, f], tracks[c, pairs[p, 1 - way]], front, following.rear_m, first, gaps
                ):
                    for t in range(steps):
                        if gaps[t] >= 0.0:
                            out[c, t, p], who[c, t, p] = gaps[t], way
    return out, who
