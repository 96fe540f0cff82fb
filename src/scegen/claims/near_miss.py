"""What a near miss is: as close as in a serious conflict, by one of several measures.

PET below 1 s is serious (Allen, Shin, Cooper 1978); the least values keep it from being a contact
by chance; the distances are this program's own choice. A small TTC alone says little at crossings,
so it counts only together with a distance below 2 m; so does a small headway of one who follows.
"""

from dataclasses import dataclass

import numpy as np

from scegen.claims.series import clipped, filled
from scegen.claims.view import View
from scegen.measures.registry import measure_named
from scegen.motion.batch.arrays import Floats


@dataclass(frozen=True, slots=True)
class Band:
    """A range of a measure, in the measure's unit."""

    measure: str
    low: float
    high: float


NEAR_MISS = (
    (Band("pet", 0.2, 1.0),),
    (Band("distance", 0.2, 0.8),),
    (Band("ttc", 0.3, 1.5), Band("distance", 0.2, 2.0)),
)
HEADWAY = (Band("headway", 0.2, 0.8), Band("distance", 0.2, 8.0))
"""One more way to a near miss, where one follows another."""
_NEVER = -3.0


def near_miss(view: View, pair: tuple[str, str]) -> Floats:
    """How far inside the best of its bands a pair is, in widths of the band; touching is none."""
    choices = [
        np.min([_inside(view, pair, band) for band in choice], axis=0)
        for choice in (*NEAR_MISS, HEADWAY)
    ]
    touches = ~np.isnan(view.of_pair("contact_s", *pair))
    margin: Floats = np.where(touches, _NEVER, np.max(choices, axis=0))
    return margin


def _inside(view: View, pair: tuple[str, str], band: Band) -> Floats:
    value = view.of_pair(measure_named(band.measure).field, *pair)
    margin = np.minimum(value - band.low, band.high - value) / (band.high - band.low)
    return clipped(filled(margin, _NEVER), _NEVER, 1.0)
