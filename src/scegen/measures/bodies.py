"""What the measures need to know of the participants' bodies, as arrays."""

from collections.abc import Sequence
from math import hypot
from typing import NamedTuple

import numpy as np

from scegen.motion.batch.arrays import Floats
from scegen.motion.batch.kernels import inner_kernel
from scegen.motion.friction import GRAVITY_MPS2
from scegen.scenario import bodies


class Body(NamedTuple):
    """One participant's body.

    Half sides and circumscribed radius of the box, how far its centre (``ahead_m``) and its front
    and rear bumpers lie from the reference point (m), mass (kg), and the deceleration that brakes
    and friction allow (m/s²); ``unprotected`` is 1 for riders and people on foot, else 0.
    """

    half_length_m: float
    half_width_m: float
    radius_m: float
    ahead_m: float
    front_m: float
    rear_m: float
    mass_kg: float
    available_mps2: float
    unprotected: float


def body_table(whose: Sequence[bodies.Body], *, friction: float) -> Floats:
    """These bodies for kernels, one row each: (participant, field of :class:`Body`).

    ``friction`` is the coefficient between tyre and road; 1 on dry asphalt.
    """
    grip = friction * GRAVITY_MPS2
    # An object never brakes: what it could do divides nothing but zero.
    return np.array(
        [
            Body(
                half_length_m=body.length_m / 2,
                half_width_m=body.width_m / 2,
                radius_m=hypot(body.length_m, body.width_m) / 2,
                ahead_m=body.centre_ahead_m,
                front_m=body.front_m,
                rear_m=body.rear_m,
                mass_kg=body.mass_kg,
                available_mps2=min(body.max_deceleration_mps2 or grip, grip),
                unprotected=float(body.unprotected),
            )
            for body in whose
        ]
    )


@inner_kernel
def body_of(bodies: Floats, i: int) -> Body:
    """The body of participant i from a table as :func:`body_table` makes it."""
    b = bodies[i]
    return Body(b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7], b[8])
