"""Impact speed and change of velocity (delta-v) at the first contact.

Definition: the impact speed is the magnitude of the relative velocity; delta-v of one is its
share of that in a perfectly plastic impact: impact speed * mass of the other / sum of the masses.
Both are vectorial: a head-on impact adds the speeds, a rear-end impact subtracts them.
Unit: m/s.
Direction: larger is worse.
Source: conservation of momentum; delta-v as crash severity: ISO 12353-1 and NHTSA practice.
Validity: undefined (nan) without contact. No rebound, no rotation, no sliding along each other:
an upper estimate for glancing impacts. Velocities are those of the reference points.
"""

from __future__ import annotations

from math import nan, sqrt

import numpy as np

from scegen.measures.bodies import body_of
from scegen.measures.boxes import VX, VY, frames_of, write_separations
from scegen.measures.distance import closest_approach
from scegen.motion.batch.arrays import Floats, Ints
from scegen.motion.batch.kernels import inner_kernel, kernel


@inner_kernel
def relative_speed(a: Floats, b: Floats, t: int) -> float:
    """Magnitude of the relative velocity of two frames at step t, m/s."""
    vx, vy = b[VX, t] - a[VX, t], b[VY, t] - a[VY, t]
    return sqrt(vx * vx + vy * vy)


@inner_kernel
def delta_v(impact_mps: float, own_kg: float, other_kg: float) -> float:
    """Change of velocity of one of two bodies that stay together, m/s."""
    return impact_mps * other_kg / (own_kg + other_kg)


@kernel
def impacts(tracks: Floats, bodies: Floats, pairs: Ints) -> Floats:
    """Impact speed, delta-v of the first and of the second, m/s: [candidate, pair, 3]."""
    out = np.full((tracks.shape[0], pairs.shape[0], 3), nan)
    squared = np.empty(tracks.shape[3])
    for c in range(tracks.shape[0]):
        frames = frames_of(tracks[c], bodies)
        for p in range(pairs.shape[0]):
            a, b = frames[pairs[p, 0]], frames[pairs[p, 1]]
            body_a, body_b = body_of(bodies, pairs[p, 0]), body_of(bodies, pairs[p, 1])
            write_separations(a, b, squared)
            _, t, contact = closest_approach(a, b, body_a, body_b, squared)
            if contact:
                speed = relative_speed(a, b, t)
                out[c, p, 0] = speed
                out[c, p, 1] = delta_v(speed, body_a.mass_kg, body_b.mass_kg)
                out[c, p, 2] = delta_v(speed, body_b.mass_kg, body_a.mass_kg)
    return out
