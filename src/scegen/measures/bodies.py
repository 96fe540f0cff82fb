"""What the measures need to know of the participants' bodies, as arrays."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot
from typing import NamedTuple

import numpy as np

from scegen.motion.batch.arrays import Floats
from scegen.motion.batch.kernels import inner_kernel
from scegen.motion.friction import GRAVITY_MPS2
from scegen.scenario.bodies import BODIES
from scegen.scenario.objects import StaticObject
from scegen.scenario.vocabulary import ON_FOOT, ParticipantKind

Kind = ParticipantKind | StaticObject
"""Whose body it is: of a kind of participant, or that of an object."""

MASS_KG: dict[ParticipantKind, float] = {
    ParticipantKind.CAR: 1850.0,
    ParticipantKind.VAN: 2600.0,
    ParticipantKind.TRUCK: 12000.0,
    ParticipantKind.BUS: 11000.0,
    ParticipantKind.MOTORCYCLE: 290.0,
    ParticipantKind.BICYCLE: 95.0,
    ParticipantKind.PEDESTRIAN: 75.0,
    ParticipantKind.EMERGENCY_VEHICLE: 3500.0,
    ParticipantKind.ANIMAL: 25.0,
    ParticipantKind.LARGE_ANIMAL: 70.0,
    ParticipantKind.DOOR: 30.0,
}
"""Mass with driver or rider: typical values for bodies of the sizes in ``scenario.bodies``.

They only weigh how two crashing bodies share the change of velocity.
"""


class Body(NamedTuple):
    """One participant's body.

    Half sides and circumscribed radius of the box, how far its centre (``ahead_m``) and its front
    and rear bumpers lie from the reference point (m), mass (kg), and the deceleration that brakes
    and friction allow (m/s²). ``injury_intercept`` and ``injury_slope_spm`` (s/m) are the logistic
    curve of ``measures.injury``; ``unprotected`` is 1 where that is over the impact speed, else 0.
    """

    half_length_m: float
    half_width_m: float
    radius_m: float
    ahead_m: float
    front_m: float
    rear_m: float
    mass_kg: float
    available_mps2: float
    injury_intercept: float
    injury_slope_spm: float
    unprotected: float


_UNPROTECTED = ON_FOOT | {
    ParticipantKind.BICYCLE,
    ParticipantKind.MOTORCYCLE,
}


def body_table(
    kinds: Sequence[Kind],
    *,
    friction: float,
    protected_curve: tuple[float, float],
    unprotected_curve: tuple[float, float],
) -> Floats:
    """The bodies of these kinds: (participant, field of :class:`Body`).

    Args:
        kinds: one per participant; an object is its own kind.
        friction: coefficient between tyre and road; 1 on dry asphalt.
        protected_curve: intercept and slope (s/m) of the injury curve over delta-v, for occupants.
        unprotected_curve: the same over impact speed, for riders and pedestrians.
    """
    return np.array([_body(k, friction, protected_curve, unprotected_curve) for k in kinds])


def _body(
    kind: Kind,
    friction: float,
    protected_curve: tuple[float, float],
    unprotected_curve: tuple[float, float],
) -> Body:
    grip = friction * GRAVITY_MPS2
    if isinstance(kind, StaticObject):
        # It never brakes: what it could do divides nothing but zero.
        body, mass, available, unprotected = kind.body, kind.mass_kg, grip, False
    else:
        body, mass = BODIES[kind], MASS_KG[kind]
        available, unprotected = min(body.max_deceleration_mps2, grip), kind in _UNPROTECTED
    intercept, slope = unprotected_curve if unprotected else protected_curve
    return Body(
        half_length_m=body.length_m / 2,
        half_width_m=body.width_m / 2,
        radius_m=hypot(body.length_m, body.width_m) / 2,
        ahead_m=body.centre_ahead_m,
        front_m=body.front_m,
        rear_m=body.rear_m,
        mass_kg=mass,
        available_mps2=available,
        injury_intercept=intercept,
        injury_slope_spm=slope,
        unprotected=float(unprotected),
    )


@inner_kernel
def body_of(bodies: Floats, i: int) -> Body:
    """The body of participant i from a table as :func:`body_table` makes it."""
    b = bodies[i]
    return Body(b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7], b[8], b[9], b[10])
