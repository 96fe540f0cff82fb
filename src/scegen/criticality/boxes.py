"""A participant's oriented box at one moment."""

from __future__ import annotations

from typing import NamedTuple

from scegen.criticality.bodies import Body
from scegen.motion.batch.arrays import COS, SIN, Floats, X, Y
from scegen.motion.batch.kernels import kernel


class Box(NamedTuple):
    """Centre (m, world), cosine and sine of the heading, half sides (m)."""

    x: float
    y: float
    cos: float
    sin: float
    half_length: float
    half_width: float


@kernel
def box_at(track: Floats, body: Body, t: int) -> Box:
    """The box of a participant at step t of its track (row, step)."""
    c, s = track[COS, t], track[SIN, t]
    return Box(
        track[X, t] + body.ahead_m * c,
        track[Y, t] + body.ahead_m * s,
        c,
        s,
        body.half_length_m,
        body.half_width_m,
    )
