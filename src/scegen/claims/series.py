"""Series (c, t) over time of many candidates: when something is first so, and for how long."""

from collections.abc import Callable, Sequence
from typing import TypeVar

import numpy as np

from scegen.motion.batch.arrays import Bools, Floats, Ints
from scegen.motion.batch.kernels import kernel

Numbers = TypeVar("Numbers", Floats, Ints)


def filled(values: Floats, undefined: float) -> Floats:
    """The values, with this one where they are nan (numpy.nan_to_num takes six times as long)."""
    return np.where(np.isnan(values), undefined, values)


def clipped(values: Numbers, low: float, high: float) -> Numbers:
    """The values, none less or greater than these (numpy.clip takes three times as long)."""
    return np.minimum(np.maximum(values, low), high)


def first(flags: Bools) -> Ints:
    """The first step that is so; the number of steps where none is (c,)."""
    step = flags.argmax(axis=1)
    return np.asarray(np.where(flags[np.arange(len(flags)), step], step, flags.shape[1]))


def at(series: Floats, step: Ints) -> Floats:
    """A series at a step of each candidate, clipped to its ends (c,)."""
    return series[np.arange(len(series)), clipped(step, 0, series.shape[1] - 1)]


def greatest(
    series: Floats, since: Ints | None = None, until: Ints | None = None
) -> tuple[Floats, Ints]:
    """The greatest value, and the first step that has it (c,) each.

    If steps are given, of those alone, both included; -inf in step 0 where there are none.
    """
    if since is None and until is None:
        step = np.asarray(series.argmax(axis=1), dtype=np.int64)
        return at(series, step), step
    begin = np.zeros(len(series), dtype=np.int64) if since is None else since
    end = np.full(len(series), series.shape[1] - 1) if until is None else until
    return _greatest(series, begin, end)


def least(
    series: Floats, since: Ints | None = None, until: Ints | None = None
) -> tuple[Floats, Ints]:
    """The least value, likewise; inf where there are none."""
    value, step = greatest(-series, since, until)
    return -value, step


@kernel
def _greatest(series: Floats, since: Ints, until: Ints) -> tuple[Floats, Ints]:
    """The greatest value in some steps, and the first of these that has it (c,)."""
    most, step = np.full(series.shape[0], -np.inf), np.zeros(series.shape[0], dtype=np.int64)
    for c in range(series.shape[0]):
        for t in range(max(since[c], 0), min(until[c] + 1, series.shape[1])):
            if series[c, t] > most[c]:
                most[c], step[c] = series[c, t], t
    return most, step


def chosen(rows: Sequence[Sequence[Floats]], choose: Callable[..., Ints]) -> tuple[Floats, ...]:
    """The first row of each candidate whose first value is the greatest, or the least (c,) each."""
    if len(rows) == 1:
        return (*rows[0],)
    columns = [np.array(values) for values in zip(*rows, strict=True)]
    pick = choose(columns[0], axis=0)
    return tuple(values[pick, np.arange(len(pick))] for values in columns)


@kernel
def least_lasting(series: Floats, steps: int) -> tuple[Floats, Ints]:
    """Of all windows of so many steps, the least of their greatest values, and where it begins."""
    least, begin = np.full(series.shape[0], np.inf), np.zeros(series.shape[0], dtype=np.int64)
    steps = min(steps, series.shape[1])
    for c in range(series.shape[0]):
        t = 0
        while t + steps <= series.shape[1]:
            greatest, last = -np.inf, t + steps - 1
            while last >= t and series[c, last] < least[c]:
                greatest, last = max(greatest, series[c, last]), last - 1
            if last < t:
                least[c], begin[c] = greatest, t
            # No window that holds a value as great as the least so far is one with less.
            t = max(t, last) + 1
    return least, begin


@kernel
def longest_run(flags: Bools) -> tuple[Ints, Ints]:
    """Length of the longest run of True in steps, and the step where it begins (c,) each."""
    longest, begin = np.zeros((2, flags.shape[0]), dtype=np.int64)
    for c in range(flags.shape[0]):
        since = 0
        for t in range(flags.shape[1]):
            if not flags[c, t]:
                since = t + 1
            elif t + 1 - since > longest[c]:
                longest[c], begin[c] = t + 1 - since, since
    return longest, begin
