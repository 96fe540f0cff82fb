"""Series (c, t) over time of many candidates: when something is first so, and for how long."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from scegen.motion.batch.arrays import Bools, Floats, Ints


def filled(values: Floats, undefined: float) -> Floats:
    """The values, with this one where they are nan (numpy.nan_to_num takes six times as long)."""
    return np.where(np.isnan(values), undefined, values)


def first(flags: Bools) -> Ints:
    """The first step that is so; the number of steps where none is (c,)."""
    found = np.where(flags.any(axis=1), flags.argmax(axis=1), flags.shape[1])
    return np.asarray(found, dtype=np.int64)


def at(series: Floats, step: Ints) -> Floats:
    """A series at a step of each candidate, clipped to its ends (c,)."""
    return series[np.arange(len(series)), np.clip(step, 0, series.shape[1] - 1)]


def greatest(series: Floats) -> tuple[Floats, Ints]:
    """The greatest value, and the first step that has it (c,) each."""
    step = np.asarray(series.argmax(axis=1), dtype=np.int64)
    return at(series, step), step


def least(series: Floats) -> tuple[Floats, Ints]:
    """The least value, and the first step that has it (c,) each."""
    step = np.asarray(series.argmin(axis=1), dtype=np.int64)
    return at(series, step), step


def chosen(rows: Sequence[Sequence[Floats]], choose: Callable[..., Ints]) -> tuple[Floats, ...]:
    """The first row of each candidate whose first value is the greatest, or the least (c,) each."""
    if len(rows) == 1:
        return (*rows[0],)
    columns = [np.array(values) for values in zip(*rows, strict=True)]
    pick = choose(columns[0], axis=0)
    return tuple(values[pick, np.arange(len(pick))] for values in columns)


def lasting(series: Floats, steps: int) -> Floats:
    """The greatest value over every window of so many steps."""
    kept, covered = series, 1
    while covered < min(steps, series.shape[1]):
        more = min(covered, min(steps, series.shape[1]) - covered)
        kept, covered = np.maximum(kept[:, :-more], kept[:, more:]), covered + more
    return kept


def longest_run(flags: Bools) -> tuple[Floats, Floats]:
    """Length of the longest run of True in steps, and the step where it begins (c,) each."""
    position = np.arange(1, flags.shape[1] + 1)
    broken = np.maximum.accumulate(np.where(flags, 0, position), axis=1)
    longest, end = greatest(np.where(flags, position - broken, 0.0))
    return longest, end + 1 - longest
