"""Points of two lines that are near to each other.

Points of a line follow one another: after one that is far off, as many are passed over as it takes
to come nearer.
"""

import numpy as np

from scegen.motion.batch.arrays import Floats, Ints
from scegen.motion.batch.kernels import inner_kernel, kernel

_ROUGHLY = 8
"""Where only nearness is asked for, every so manieth is looked at first."""


@inner_kernel
def longest_step_m(x: Floats, y: Floats) -> float:
    """The greatest distance of two points of a line that follow one another."""
    longest = 0.0
    for n in range(1, x.shape[0]):
        dx, dy = x[n] - x[n - 1], y[n] - y[n - 1]
        longest = max(longest, dx * dx + dy * dy)
    return float(np.sqrt(longest))


@inner_kernel
def on_to(squared_m2: float, wanted_m2: float, step_m: float) -> int:
    """How many points of a line further on the next may lie that is nearer than wanted."""
    if step_m == 0.0 or squared_m2 <= wanted_m2:
        return 1
    return max(1, int((np.sqrt(squared_m2) - np.sqrt(wanted_m2)) / step_m))


@kernel
def least_gap_m(x: Floats, y: Floats, fx: Floats, fy: Floats, enough_m: float) -> float:
    """The least distance of the points of two lines; or the first that is found below enough."""
    step_m = longest_step_m(fx, fy)
    least, gap = np.inf, np.inf
    for every in (_ROUGHLY, 1):  # the nearer the first are, the more of the others are passed over
        for n in range(0, x.shape[0], every):
            m = 0
            while m < fx.shape[0]:
                dx, dy = x[n] - fx[m], y[n] - fy[m]
                squared = dx * dx + dy * dy
                if squared < least:
                    least, gap = squared, np.hypot(dx, dy)
                    if gap < enough_m:
                        return float(gap)
                m += max(every, on_to(squared, least, step_m))
    return float(gap)


@kernel
def nearest_points(
    x: Floats, y: Floats, fx: Floats, fy: Floats, within_m: float
) -> tuple[Ints, Floats]:
    """For each point the nearest one of a line, the first of several, and its distance.

    Where none is ``within_m`` the distance is inf, and which is the nearest is not looked for.
    """
    step_m = longest_step_m(fx, fy)
    index = np.zeros(x.shape[0], dtype=np.int64)
    away = np.full(x.shape[0], np.inf)
    best = 0
    for n in range(x.shape[0]):
        best, away[n] = nearest_point(x[n], y[n], fx, fy, best, within_m, step_m)
        index[n] = best
    return index, away


@inner_kernel
def nearest_point(
    x: float, y: float, fx: Floats, fy: Floats, best: int, within_m: float, step_m: float
) -> tuple[int, float]:
    """One point of those, beginning with that nearest to the one before."""
    dx, dy = x - fx[best], y - fy[best]
    least = min(dx * dx + dy * dy, within_m * within_m)
    m = 0
    while m < fx.shape[0]:
        dx, dy = x - fx[m], y - fy[m]
        squared = dx * dx + dy * dy
        if squared < least or (squared == least and m < best):
            least, best = squared, m
        m += on_to(squared, least, step_m)
    dx, dy = x - fx[best], y - fy[best]
    near = dx * dx + dy * dy <= within_m * within_m
    return best, np.hypot(dx, dy) if near else np.inf
