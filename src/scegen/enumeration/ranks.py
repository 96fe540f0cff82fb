"""Who arrives first at an arm, and who travels beside whom."""

from __future__ import annotations

from dataclasses import dataclass, field

from scegen.enumeration.problem import Problem
from scegen.enumeration.reading import Solution
from scegen.scenario.vocabulary import FROM_BESIDE, Approach, HazardKind


@dataclass
class Queue:
    """The vehicles of one entry arm, with what is known of their order."""

    names: list[str]
    after: dict[str, set[str]] = field(default_factory=dict)
    beside: dict[str, str] = field(default_factory=dict)

    def ranks(self) -> dict[str, int] | None:
        """Rank by name: as said, otherwise in listing order; those side by side share one.

        None if what is said goes round in a circle.
        """
        rows = [[name] for name in self.names]
        for name, reference in self.beside.items():
            row = next(row for row in rows if name in row)
            other = next(row for row in rows if reference in row)
            if row is not other:
                first, second = sorted((row, other), key=rows.index)
                first += second
                rows.remove(second)
        ranks: dict[str, int] = {}
        for rank in range(len(rows)):
            row = next((row for row in rows if self._may_go(row, ranks)), [])
            if not row:
                return None
            rows.remove(row)
            ranks |= dict.fromkeys(row, rank)
        return ranks

    def _may_go(self, row: list[str], ranks: dict[str, int]) -> bool:
        waiting_for = set[str]().union(*(self.after.get(name, set()) for name in row))
        return all(name in ranks for name in waiting_for & set(self.names))


def queues(problem: Problem, solution: Solution) -> list[Queue]:
    """One queue for each arm at which somebody enters."""
    entry_of = {v.id: d[0] for v, d in zip(problem.vehicles, solution.drives, strict=True)}
    found = {
        arm: Queue([name for name, entry in entry_of.items() if entry == arm])
        for arm in sorted(set(entry_of.values()))
    }
    for name, reference, word in _sayings(problem, solution):
        if entry_of[name] != entry_of[reference]:
            continue
        queue = found[entry_of[name]]
        if word == Approach.BEHIND:
            queue.after.setdefault(name, set()).add(reference)
        elif word == Approach.AHEAD:
            queue.after.setdefault(reference, set()).add(name)
        else:
            queue.beside[name] = reference
    for name, reference in _cutting_in(problem):
        queue = found[entry_of[name]]
        if entry_of[name] == entry_of[reference] and name not in queue.beside:
            queue.beside[name] = reference
            if queue.ranks() is None:
                del queue.beside[name]
    return list(found.values())


def _sayings(problem: Problem, solution: Solution) -> list[tuple[str, str, str]]:
    """(vehicle, reference, word): places chosen, and the order that hazards demand."""
    implied = {"behind": Approach.BEHIND, "ahead": Approach.AHEAD, "into": Approach.AHEAD}
    hazards = [(d.by, d.to, implied[d.what].value) for d in problem.demands if d.what in implied]
    return [*solution.places, *hazards]


def _cutting_in(problem: Problem) -> list[tuple[str, str]]:
    """Who cuts in or merges comes from the lane beside, unless the order said does not let it."""
    lanes = problem.functional.junction.lanes
    if lanes and min(lanes) == 1:
        return []
    together = [d for d in problem.demands if d.what == "together"]
    return [(d.by, d.to) for d in together if d.kind in {HazardKind.CUT_IN, *FROM_BESIDE}]
