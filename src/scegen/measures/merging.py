"""Where two ways become one, if they do not only cross."""

import numpy as np

from scegen.measures.boxes import Way
from scegen.measures.nearest import longest_step_m, nearest_point
from scegen.motion.batch.arrays import Floats
from scegen.motion.batch.kernels import kernel
from scegen.motion.model import Path

MERGED_ASIDE_M = 0.3
MERGED_TURN_RAD = np.deg2rad(10.0)
MERGED_FOR_M = 5.0
"""Paths have merged where they lie within these for so long; crossings are shorter or steeper."""


def merge_point(
    first: Path, second: Path, s_first: Floats, s_second: Floats
) -> tuple[float, float] | None:
    """Positions along both paths at which they have become one; None if they only cross.

    A position near 0 says that the path begins on the other: following, no merge.
    """
    second_s = np.linspace(s_second[0], s_second[-1], 4 * len(s_second))
    one, two = Way(s_first, *first.places(s_first)), Way(second_s, *second.places(second_s))
    begins, nearest = _merge(one, two)
    return (float(s_first[begins]), float(second_s[nearest])) if begins >= 0 else None


@kernel
def _merge(one: Way, two: Way) -> tuple[int, int]:
    """The first place of one from which on it runs along two, and the nearest of two; -1: none."""
    step_m, best, begins, at = longest_step_m(two.x_m, two.y_m), 0, -1, 0
    for n in range(one.s_m.shape[0]):
        best, gap = nearest_point(
            one.x_m[n], one.y_m[n], two.x_m, two.y_m, best, MERGED_ASIDE_M, step_m
        )
        turn = one.heading_rad[n] - two.heading_rad[best]
        if not (
            gap < MERGED_ASIDE_M and abs(np.arctan2(np.sin(turn), np.cos(turn))) < MERGED_TURN_RAD
        ):
            begins = -1
            continue
        if begins < 0:
            begins, at = n, best
        if one.s_m[n] - one.s_m[begins] >= MERGED_FOR_M:
            return begins, at
    return -1, -1
