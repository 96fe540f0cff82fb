"""A participant's oriented box at one moment."""

from __future__ import annotations

from typing import NamedTuple

from scegen.criticality.bodies import BodyTable
from scegen.motion.batch.arrays import BatchTraces
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
def box_at(traces: BatchTraces, bodies: BodyTable, row: int, t: int, i: int) -> Box:
    """The box of participant i at step t of candidate ``row``."""
    c, s, ahead = traces.cos[row, t, i], traces.sin[row, t, i], bodies.ahead_m[i]
    return Box(
        traces.x_m[row, t, i] + ahead * c,
        traces.y_m[row, t, i] + ahead * s,
        c,
        s,
        bodies.half_length_m[i],
        bodies.half_width_m[i],
    )
