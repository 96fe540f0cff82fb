"""Who arrives first at an arm, and who travels beside whom."""

from __future__ import annotations

from dataclasses import dataclass, field

from scegen.enumeration.problem import Problem
from scegen.enumeration.solving import Solution
from scegen.scenario.vocabulary import Approach, HazardKind


@dataclass
class Queue:
    """The vehicles of one entry arm, with what is known of their order."""

    names: list[str]
    after: dict[str, set[str]] = field(default_factory=dict)
    beside: dict[str, str] = field(default_factory=dict)

    def ranks(self) -> dict[str, int]:
        """Rank by name: as said, otherwise in listing order; those side by side share one."""
        rows: list[list[str]] = []
        for name in self.names:
            together = {name, self.beside.get(name, name)}
            row = next((row for row in rows if together & set(row)), None)
            if row is None:
                rows.append([name])
            else:
                row.append(name)
        ranks: dict[str, int] = {}
        while rows:
            row = next(row for row in rows if self._may_go(row, ranks))
            rows.remove(row)
            ranks |= dict.fromkeys(row, len(set(ranks.values())))
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
            queue.beside.setdefault(name, reference)
    return list(found.values())


def _sayings(problem: Problem, solution: Solution) -> list[tuple[str, str, str]]:
    """(vehicle, reference, word): places chosen, and what hazards imply."""
    said = list(solution.places)
    implied = {"behind": Approach.BEHIND, "ahead": Approach.AHEAD}
    said += [(d.by, d.to, implied[d.what]) for d in problem.demands if d.what in implied]
    ordered = {frozenset(pair[:2]) for pair in said}
    lanes = problem.functional.junction.lanes
    if not lanes or min(lanes) > 1:
        # Who cuts in comes from the next lane, if nothing else is said.
        said += [
            (d.by, d.to, Approach.ADJACENT)
            for d in problem.demands
            if d.what == "together"
            and d.kind is HazardKind.CUT_IN
            and frozenset((d.by, d.to)) not in ordered
        ]
    return said
