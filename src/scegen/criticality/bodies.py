"""What the measures need to know of the participants' bodies, as arrays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from scegen.motion.batch.arrays import Floats
from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ParticipantKind

GRAVITY_MPS2 = 9.81
"""Standard gravity, rounded as in UN R157."""

MASS_KG: dict[ParticipantKind, float] = {
    ParticipantKind.CAR: 1850.0,
    ParticipantKind.VAN: 2600.0,
    ParticipantKind.TRUCK: 12000.0,
    ParticipantKind.BUS: 11000.0,
    ParticipantKind.MOTORCYCLE: 290.0,
    ParticipantKind.BICYCLE: 95.0,
    ParticipantKind.PEDESTRIAN: 75.0,
    ParticipantKind.EMERGENCY_VEHICLE: 3500.0,
}
"""Mass with driver or rider: typical values for bodies of the sizes in ``scenario.bodies``.

They only weigh how two crashing bodies share the change of velocity.
"""


class BodyTable(NamedTuple):
    """Bodies by participant; arrays of shape (participants,).

    Half sides and circumscribed radius of the box, how far its centre (``ahead_m``) and its front
    and rear bumpers lie from the reference point (m), mass (kg), and the deceleration that brakes
    and friction allow (m/s²). ``injury_intercept`` and ``injury_slope_spm`` (s/m) are the logistic
    curve of ``measures.injury``; ``unprotected`` is True where it is over the impact speed.
    """

    half_length_m: Floats
    half_width_m: Floats
    radius_m: Floats
    ahead_m: Floats
    front_m: Floats
    rear_m: Floats
    mass_kg: Floats
    available_mps2: Floats
    injury_intercept: Floats
    injury_slope_spm: Floats
    unprotected: Floats


_UNPROTECTED = {
    ParticipantKind.PEDESTRIAN,
    ParticipantKind.BICYCLE,
    ParticipantKind.MOTORCYCLE,
}


def body_table(
    kinds: Sequence[ParticipantKind],
    *,
    friction: float,
    protected_curve: tuple[float, float],
    unprotected_curve: tuple[float, float],
) -> BodyTable:
    """The bodies of these kinds.

    Args:
        kinds: one per participant.
        friction: coefficient between tyre and road; 1 on dry asphalt.
        protected_curve: intercept and slope (s/m) of the injury curve over delta-v, for occupants.
        unprotected_curve: the same over impact speed, for riders and pedestrians.
    """
    bodies = [BODIES[kind] for kind in kinds]
    half_length = np.array([b.length_m / 2 for b in bodies])
    half_width = np.array([b.width_m / 2 for b in bodies])
    unprotected = np.array([kind in _UNPROTECTED for kind in kinds])
    return BodyTable(
        half_length_m=half_length,
        half_width_m=half_width,
        radius_m=np.hypot(half_length, half_width),
        ahead_m=np.array([b.centre_ahead_m for b in bodies]),
        front_m=np.array([b.front_m for b in bodies]),
        rear_m=np.array([b.rear_m for b in bodies]),
        mass_kg=np.array([MASS_KG[kind] for kind in kinds]),
        available_mps2=np.array(
            [min(b.max_deceleration_mps2, friction * GRAVITY_MPS2) for b in bodies]
        ),
        injury_intercept=np.where(unprotected, unprotected_curve[0], protected_curve[0]),
        injury_slope_spm=np.where(unprotected, unprotected_curve[1], protected_curve[1]),
        unprotected=unprotected.astype(np.float64),
    )
