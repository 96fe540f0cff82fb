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

from math import sqrt

from scegen.measures.boxes import relative_velocity
from scegen.motion.batch.arrays import Floats
from scegen.motion.batch.kernels import inner_kernel


@inner_kernel
def relative_speed(a: Floats, b: Floats, t: int) -> float:
    """Magnitude of the relative velocity of two tracks at step t, m/s."""
    vx, vy = relative_velocity(a, b, t)
    return sqrt(vx * vx + vy * vy)


@inner_kernel
def delta_v(impact_mps: float, own_kg: float, other_kg: float) -> float:
    """Change of velocity of one of two bodies that stay together, m/s."""
    return impact_mps * other_kg / (own_kg + other_kg)
