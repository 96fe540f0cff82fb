"""A smallest set of scenarios that covers everything coverable, by answer set optimisation."""

# mypy does not follow clorm.
# mypy: allow-subclassing-any

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from clorm import Predicate, unify

from scegen.enumeration.choosing.coverage import Meeting, meetings
from scegen.enumeration.programs import Part, grounded
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario

MOST_CONFLICTS = 200_000
"""The solver's own measure of effort (seconds); it stops there, at the same place every time."""


class Covers(Predicate):
    """A meeting occurs in a scenario."""

    scenario: int
    meeting: int


class Chosen(Predicate):
    """A scenario belongs to the cover."""

    scenario: int


@dataclass(frozen=True, slots=True)
class Cover:
    """The chosen scenarios; ``proved`` says that no smaller set does."""

    scenarios: tuple[LogicalScenario, ...]
    proved: bool


def smallest_cover(scenarios: Sequence[LogicalScenario], functional: FunctionalScenario) -> Cover:
    """The fewest of these scenarios in which every meeting of theirs occurs."""
    useful = _undominated([meetings(functional, s) for s in scenarios])
    number: dict[Meeting, int] = {}
    facts = [
        Covers(index, number.setdefault(meeting, len(number)))
        for index, held in useful.items()
        for meeting in sorted(held)
    ]
    if not facts:
        return Cover((), proved=True)
    control = grounded(facts, (Part.COVER,), f"--solve-limit={MOST_CONFLICTS}")
    best: list[int] = []
    control.configuration.solve.models = 0
    with control.solve(yield_=True) as handle:
        for model in handle:
            shown = unify([Chosen], model.symbols(shown=True), ordered=True)
            best = [fact.scenario for fact in shown]
        proved = bool(handle.get().exhausted)
    return Cover(tuple(scenarios[index] for index in sorted(best)), proved)


def _undominated(held: list[frozenset[Meeting]]) -> dict[int, frozenset[Meeting]]:
    """Scenarios by index, without those that hold nothing which another does not hold too."""
    first: dict[frozenset[Meeting], int] = {}
    for index, found in enumerate(held):
        first.setdefault(found, index)
    kept: list[frozenset[Meeting]] = []
    for found in sorted(first, key=lambda f: (-len(f), first[f])):
        if found and not any(found < larger for larger in kept):
            kept.append(found)
    return {first[found]: found for found in kept}
