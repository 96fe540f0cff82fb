"""A diverse sample: each next scenario is as far as possible from all chosen before.

The distance of two scenarios is the share of participants who drive differently (another entry,
exit or maneuver) plus the share of pairs who meet differently (another kind of conflict, or
another one yields): from 0, alike, to 2. It is documented in docs/how-to/choosing.md.
"""

from collections.abc import Hashable, Iterable, Sequence
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from scegen.enumeration.choosing.ranking import richest_first
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Drive, LogicalScenario

Codes = NDArray[np.int32]


def diverse_sample(
    scenarios: Sequence[LogicalScenario], functional: FunctionalScenario, size: int
) -> tuple[LogicalScenario, ...]:
    """Greedy max-min, from the richest scenario on; ties go to the first in the list."""
    if size >= len(scenarios):
        return tuple(scenarios)
    ways = codes_of([_ways(s) for s in scenarios])
    meetings = codes_of([_meetings(s, functional) for s in scenarios])
    chosen = [min(range(len(scenarios)), key=lambda i: richest_first(scenarios[i], functional))]
    nearest = _distances(ways, meetings, chosen[0])
    while len(chosen) < size:
        chosen.append(int(nearest.argmax()))
        nearest = np.minimum(nearest, _distances(ways, meetings, chosen[-1]))
    return tuple(scenarios[i] for i in chosen)


def distance(
    first: LogicalScenario, second: LogicalScenario, functional: FunctionalScenario
) -> float:
    """The distance of two scenarios of one functional scenario."""
    pair = (first, second)
    ways = codes_of([_ways(s) for s in pair])
    return float(_distances(ways, codes_of([_meetings(s, functional) for s in pair]), 0)[1])


def _distances(ways: Codes, meetings: Codes, to: int) -> NDArray[np.float64]:
    """Distances of all scenarios to one; a chosen one is nearer than any other (-1)."""
    far = (ways != ways[to]).mean(axis=1)
    if meetings.shape[1]:
        far = far + (meetings != meetings[to]).mean(axis=1)
    out = np.asarray(far, dtype=np.float64)
    out[to] = -1.0
    return out


def _ways(scenario: LogicalScenario) -> list[Hashable]:
    return [
        (a.entry, a.exit, a.maneuver) if isinstance(a, Drive) else a for a in scenario.assignments
    ]


def _meetings(scenario: LogicalScenario, functional: FunctionalScenario) -> list[Hashable]:
    met = {(c.first, c.second): (c.kind, c.yields) for c in scenario.conflicts}
    names = [p.id for p in functional.participants]
    return [met.get(pair) for pair in combinations(names, 2)]


def codes_of(rows: Iterable[Iterable[Hashable]]) -> Codes:
    """Equal values become equal numbers, by row."""
    numbers: dict[Hashable, int] = {}
    table = [[numbers.setdefault(value, len(numbers)) for value in row] for row in rows]
    return np.array(table, dtype=np.int32)
