"""A suite of a given size: first all that can be covered, then what is critical and different."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from scegen.campaign.analysis.coverage import Coverage
from scegen.campaign.analysis.features import Features, criticality
from scegen.campaign.rows import Row
from scegen.enumeration.choosing.covering import fewest
from scegen.errors import InputError
from scegen.motion.batch.arrays import Floats

FOR_COVERAGE, FOR_DANGER = "covers", "critical and different"
_MOST_CONFLICTS = 50_000


@dataclass(frozen=True, slots=True)
class Chosen:
    """A row of the suite, what it was chosen for, and what only it brings."""

    row: int
    reason: str
    brings: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Suite:
    """Rows by number; ``needed`` is how many the cover takes, ``proved`` that no fewer do.

    ``uncovered`` are cells for which there was no room.
    """

    chosen: tuple[Chosen, ...]
    needed: int
    proved: bool
    uncovered: tuple[str, ...]


def suite_of(rows: Sequence[Row], covered: Coverage, size: int) -> Suite:
    """A suite of at most ``size`` of the rows; equal rows give equal suites.

    Raises:
        InputError: no row is good enough, or the size is none.
    """
    if size < 1:
        raise InputError(f"must be at least 1, not {size}", where="--size")
    danger = criticality(rows)
    usable = [row for row, cells in enumerate(covered.held) if cells]
    if not usable:
        raise InputError("there is no scenario in which all that is said holds")
    # Of those that cover alike, the most critical one.
    usable.sort(key=lambda row: (-danger[row], row))
    cover, proved = smallest([covered.held[row] for row in usable])
    needed = in_order([usable[place] for place in cover], covered)
    chosen = needed[:size]
    told, seen = [], set[str]()
    for row in chosen:
        fresh = tuple(sorted(covered.held[row] - seen))
        seen |= covered.held[row]
        told.append(Chosen(row, FOR_COVERAGE, fresh))
    told += [
        Chosen(row, FOR_DANGER)
        for row in extended(Features.of(rows), danger, chosen, usable, size - len(chosen))
    ]
    return Suite(tuple(told), len(needed), proved, tuple(sorted({*covered.counts} - seen)))


def smallest(sets: Sequence[frozenset[str]]) -> tuple[tuple[int, ...], bool]:
    """The fewest sets found that hold all that all hold, and whether no fewer do.

    Greedily, then without those that the others make superfluous; and by answer set optimisation,
    within a fixed effort. The smaller one is taken.
    """
    greedy = _reduced(_greedy(sets), sets)
    optimal, proved = fewest(sets, _MOST_CONFLICTS)
    better = proved or 0 < len(optimal) <= len(greedy)
    return (optimal, proved) if better else (greedy, False)


def _greedy(sets: Sequence[frozenset[str]]) -> list[int]:
    left = set[str]().union(*sets)
    chosen: list[int] = []
    while left:
        best = max(range(len(sets)), key=lambda place: (len(sets[place] & left), -place))
        chosen.append(best)
        left -= sets[best]
    return chosen


def _reduced(chosen: list[int], sets: Sequence[frozenset[str]]) -> tuple[int, ...]:
    kept = list(chosen)
    for place in sorted(chosen, key=lambda place: (len(sets[place]), place)):
        others = [other for other in kept if other != place]
        if sets[place] <= set[str]().union(*(sets[other] for other in others)):
            kept = others
    return tuple(sorted(kept))


def in_order(rows: list[int], covered: Coverage) -> list[int]:
    """Those that bring most first, so that the beginning of a suite is worth most."""
    left, ordered, seen = sorted(rows), list[int](), set[str]()
    while left:
        best = max(left, key=lambda row: (len(covered.held[row] - seen), -row))
        left.remove(best)
        ordered.append(best)
        seen |= covered.held[best]
    return ordered


def extended(
    features: Features, danger: Floats, chosen: Sequence[int], usable: Sequence[int], count: int
) -> list[int]:
    """So many more rows: each the one with most danger and distance to all chosen, together."""
    near = np.full(len(danger), np.inf)
    for row in chosen:
        near = np.minimum(near, features.distances(row))
    taken, free = list[int](), set(usable) - set(chosen)
    while free and len(taken) < count:
        rows = np.array(sorted(free))
        best = int(rows[np.argmax(danger[rows] + np.minimum(near[rows], 1.0))])
        taken.append(best)
        free.remove(best)
        near = np.minimum(near, features.distances(best))
    return taken
