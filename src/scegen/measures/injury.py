"""Injury probability: the chance of at least one serious injury (MAIS 3 or more) in an impact.

Definition: 1 / (1 + exp(-(intercept + slope * v))), v in m/s: delta-v for occupants of cars, vans,
trucks, buses and emergency vehicles, impact speed for riders and pedestrians.
Unit: none, 0 to 1.
Direction: larger is worse.
Source, occupants: Wang, MAIS(05/08) injury probability curves as functions of delta V, NHTSA
DOT HS 813 219, 2022 (crashes of 2010-2015), all crash modes: -6.9540 + 0.1637 * delta-v in mph.
Source, unprotected: pedestrian MAIS 3+ on GIDAS data after Rosén, 2010, as quoted in secondary
literature: -4.6 + 0.078 * impact speed in km/h. It puts 10 % at 31 km/h, where the newer GIDAS
models in Kusano et al., TARGET setting for high severity collisions, put it at 34 km/h for
pedestrians and 49 km/h for riders. That the reports are about this, and the figures of Kusano et
al., were checked; the coefficients themselves could not be read in the originals.
Validity: averages over ages, belts and directions of impact, for light vehicles of their time; for
riders an upper estimate, for occupants of heavy vehicles a stand-in. Fit to rank scenarios, not
to predict outcomes. Undefined (nan) without contact.
"""

from math import exp

from scegen.measures.bodies import Body
from scegen.motion.batch.kernels import inner_kernel

_MPS_PER_MPH = 0.44704
_MPS_PER_KMH = 1 / 3.6
PROTECTED = (-6.9540, 0.1637 / _MPS_PER_MPH)
"""Intercept and slope (s/m) over delta-v, for occupants."""
UNPROTECTED = (-4.6, 0.078 / _MPS_PER_KMH)
"""Intercept and slope (s/m) over impact speed, for riders and pedestrians."""


@inner_kernel
def injury_probability(body: Body, impact_mps: float, delta_v_mps: float) -> float:
    """Probability of MAIS 3+ for one with this body."""
    if body.unprotected > 0.0:
        return 1.0 / (1.0 + exp(-(UNPROTECTED[0] + UNPROTECTED[1] * impact_mps)))
    return 1.0 / (1.0 + exp(-(PROTECTED[0] + PROTECTED[1] * delta_v_mps)))
