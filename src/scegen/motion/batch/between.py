"""Between the vertices of a line: what a table says where it has no row."""

from __future__ import annotations

import numpy as np

from scegen.motion.batch.arrays import Floats
from scegen.motion.batch.kernels import inner_kernel


@inner_kernel
def before(values: Floats, value: float) -> int:
    """The last place, but for the end, at which rising values are not above one; 0 if none is."""
    place = np.searchsorted(values, value, side="right") - 1
    return int(min(max(place, 0), values.shape[0] - 2))


@inner_kernel
def between(values: Floats, place: int, share: float) -> float:
    """The value so far from one place to the next."""
    return float(values[place] + share * (values[place + 1] - values[place]))
