"""How far two are apart along the way, against what a measure says."""

from __future__ import annotations

import numpy as np

from scegen.claims.boxes import Boxes, gap_m, same_way, seen
from scegen.motion.model import Array
from scegen.scenario.spacings import Measure

LENGTHWISE = frozenset({Measure.GAP_M, Measure.HEADWAY_S, Measure.TTC_S})
"""Measures along the road."""


def missing_m(
    measure: Measure, value: float, own: tuple[Boxes, Array], other: tuple[Boxes, Array]
) -> Array:
    """How much longer the free length between two is than a measure says (n,), m.

    Args:
        measure: one along the road.
        value: in its unit.
        own: boxes and speeds (m/s) of the one whose speed counts if they come towards each other.
        other: those of the other; of two in one direction the speed of the one behind counts.
    """
    (frame, speed), (box, others) = own, other
    gap = gap_m(frame, box)
    if measure is Measure.GAP_M:
        return gap - value
    along = same_way(frame, box)
    follows = (seen(frame, box).x > 0.0) | (along < 0.0)
    if measure is Measure.HEADWAY_S:
        return gap - value * np.where(follows, speed, others)
    closing = speed - others * along
    return gap - value * np.where(follows, closing, -closing)
