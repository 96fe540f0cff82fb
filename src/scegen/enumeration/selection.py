"""A covering and diverse selection where there are too many scenarios to list.

Assignments are drawn by the solver in random directions (the seed is fixed), one for each
scenario. Ways that no draw has shown are asked for one by one. Of all drawn, those come first
that show a way, or two ways of two participants together, for the first time; then those that
show what is rarest so far.
"""

from collections import defaultdict
from collections.abc import Hashable, Iterator
from heapq import heappop, heapreplace
from itertools import combinations, islice

import numpy as np
from clorm import Predicate

from scegen.enumeration import answers as a
from scegen.enumeration.counting import Census
from scegen.enumeration.problem import Problem
from scegen.enumeration.reading import Solution, Way, read_solutions
from scegen.enumeration.solving import listing_program, solutions
from scegen.enumeration.symmetry import Symmetry
from scegen.scenario.vocabulary import Reduction

DRAWN = 2
"""So many are drawn for each that is wanted; where there are no more, all are looked at."""

Feature = tuple[object, ...]
"""What somebody does, or what two do together; those who are alike are not told apart."""


def selected(census: Census, reduction: Reduction, number: int) -> list[Solution]:
    """So many different scenarios, sorted as a whole listing would be."""
    if census.count(reduction) <= DRAWN * number:
        pool = list(solutions(census.problem, census.symmetry, reduction))
    else:
        pool = _drawn(census, reduction, DRAWN * number)
    return covering(census, pool, number)


def _drawn(census: Census, reduction: Reduction, number: int) -> list[Solution]:
    """About so many scenarios by chance, and those that show what chance did not."""
    problem = census.problem
    control = listing_program(problem, census.symmetry, Reduction.NONE, at_random=True)
    found: dict[Hashable, Solution] = {}
    seen = set[Feature]()
    for solution in islice(read_solutions(problem, control), number):
        found.setdefault(census.class_key(reduction, solution), solution)
        seen.update(zip(problem.names, solution.drives, strict=False))
    for solution in _asked_for(problem, census.symmetry, seen):
        found.setdefault(census.class_key(reduction, solution), solution)
    return list(found.values())


def _asked_for(problem: Problem, symmetry: Symmetry, seen: set[Feature]) -> Iterator[Solution]:
    """An assignment for each way that was never drawn, where there is one."""
    control = listing_program(problem, symmetry, Reduction.NONE, at_random=True)
    for (name, entry), choices in problem.wanted.items():
        for move, manner in choices:
            if (name, (entry, move, manner)) not in seen:
                asked: list[Predicate] = [a.Drive(name, entry, move, manner)]
                yield from read_solutions(problem, control, limit=1, assumed=asked)


def covering(census: Census, pool: list[Solution], number: int) -> list[Solution]:
    """Of all in the pool those that show something new, then those that show what is rarest."""
    kinds = {name: i for i, group in enumerate(census.symmetry.groups) for name in group.members}
    numbered: defaultdict[Feature, int] = defaultdict(lambda: len(numbered))
    features = [
        np.array([numbered[f] for f in _features(census.problem, kinds, solution)], dtype=np.intp)
        for solution in pool
    ]
    shown = np.zeros(len(numbered), dtype=np.int64)
    chosen: list[Solution] = []
    # How often the rarest feature was shown only grows, so an old value is a lower bound.
    waiting = [(0, place) for place in range(len(pool))]
    while waiting and len(chosen) < number:
        before, place = waiting[0]
        rarest = int(shown[features[place]].min())
        if rarest > before:
            heapreplace(waiting, (rarest, place))
            continue
        heappop(waiting)
        chosen.append(pool[place])
        np.add.at(shown, features[place], 1)
    return sorted(chosen, key=_order)


def _features(problem: Problem, kinds: dict[str, int], solution: Solution) -> Iterator[Feature]:
    ways: tuple[Way | tuple[int, str], ...] = (*solution.drives, *solution.on_foot)
    told = sorted((kinds[name], way) for name, way in zip(problem.names, ways, strict=True))
    yield from told
    yield from combinations(told, 2)


def _order(solution: Solution) -> tuple[object, ...]:
    entries = [entry for entry, _, _ in solution.drives]
    return entries, [way[1:] for way in solution.drives], solution.on_foot, solution.places
