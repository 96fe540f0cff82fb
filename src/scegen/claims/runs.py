"""Times over which speed falls or grows without a break, found on many candidates at once."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scegen.motion.batch.arrays import Bools, Floats, Ints
from scegen.motion.batch.kernels import kernel


class Run(NamedTuple):
    """Where it begins and ends, in steps, and what it adds up to: 0 where there is none (c,)."""

    begin: Ints
    end: Ints
    change_mps: Floats

    @property
    def happens(self) -> Bools:
        """Where there is one."""
        return self.change_mps > 0.0

    def instead_of(self, other: Run, where: Bools) -> Run:
        """This one in some candidates, another in the rest."""
        return Run(*(np.where(where, a, b) for a, b in zip(self, other, strict=True)))


def greatest_runs(
    speed_mps: Floats, sense: int, least: float, most: float, count: int
) -> list[Run]:
    """The greatest runs in which speed falls (-1) or grows (+1), in the order of time.

    Args:
        speed_mps: (c, t).
        sense: which way.
        least: a smaller change in one step does not count.
        most: nor does a greater one, which is no driving.
        count: how many; those that there are not come last.
    """
    begin = np.full((len(speed_mps), count), speed_mps.shape[1], dtype=np.int64)
    end = begin.copy()
    change = np.zeros(begin.shape)
    _find(np.ascontiguousarray(speed_mps), float(sense), least, most, begin, end, change)
    if count == 1:
        return [Run(begin[:, 0], end[:, 0], change[:, 0])]
    order = np.argsort(np.where(change > 0.0, begin, speed_mps.shape[1] + 1), axis=1)
    begin, end = (np.take_along_axis(steps, order, axis=1) for steps in (begin, end))
    change = np.take_along_axis(change, order, axis=1)
    return [Run(begin[:, n], end[:, n], change[:, n]) for n in range(count)]


@kernel
def _find(
    speed: Floats, sense: float, least: float, most: float, begin: Ints, end: Ints, change: Floats
) -> None:
    """Keep the greatest of every candidate's runs, the least of those kept giving way."""
    for c in range(speed.shape[0]):
        since, total = -1, 0.0
        for t in range(speed.shape[1]):
            step = sense * (speed[c, t + 1] - speed[c, t]) if t + 1 < speed.shape[1] else 0.0
            if least < step < most:
                if since < 0:
                    since, total = t, 0.0
                total += step
            elif since >= 0:
                k = 0
                for n in range(1, change.shape[1]):
                    if change[c, n] < change[c, k]:
                        k = n
                if total > change[c, k]:
                    begin[c, k], end[c, k], change[c, k] = since, t, total
                since = -1
