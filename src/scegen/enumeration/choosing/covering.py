"""A smallest set of scenarios that covers everything coverable, by answer set optimisation."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol, TypeVar

from clorm import unify

from scegen.enumeration.choosing.coverage import meetings
from scegen.enumeration.facts import fact
from scegen.enumeration.programs import Part, grounded
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario

MOST_CONFLICTS = 200_000
"""The solver's own measure of effort (seconds); it stops there, at the same place every time."""


class _Sortable(Protocol):
    def __lt__(self, other: Any, /) -> bool: ...  # noqa: ANN401 - its own kind
    def __hash__(self) -> int: ...


T = TypeVar("T", bound=_Sortable)


Covers = fact("covers(scenario: int, meeting: int)", "A meeting occurs in a scenario.")
Chosen = fact("chosen(scenario: int)", "A scenario belongs to the cover.")


@dataclass(frozen=True, slots=True)
class Cover:
    """The chosen scenarios; ``proved`` says that no smaller set does."""

    scenarios: tuple[LogicalScenario, ...]
    proved: bool


def smallest_cover(scenarios: Sequence[LogicalScenario], functional: FunctionalScenario) -> Cover:
    """The fewest of these scenarios in which every meeting of theirs occurs."""
    chosen, proved = fewest([meetings(functional, s) for s in scenarios], MOST_CONFLICTS)
    return Cover(tuple(scenarios[index] for index in chosen), proved)


def fewest(held: Sequence[frozenset[T]], most_conflicts: int) -> tuple[tuple[int, ...], bool]:
    """The indices of the fewest sets that hold together what all hold; whether that is proved.

    ``most_conflicts`` is the solver's own measure of effort; it then gives the best so far.
    """
    useful = _undominated(held)
    number: dict[T, int] = {}
    facts = [
        Covers(index, number.setdefault(meeting, len(number)))
        for index, held_here in useful.items()
        for meeting in sorted(held_here)
    ]
    if not facts:
        return (), True
    control = grounded(facts, (Part.COVER,), f"--solve-limit={most_conflicts}")
    best: list[int] = []
    control.configuration.solve.models = 0
    with control.solve(yield_=True) as handle:
        for model in handle:
            shown = unify([Chosen], model.symbols(shown=True), ordered=True)
            best = [fact.scenario for fact in shown]
        proved = bool(handle.get().exhausted)
    return tuple(sorted(best)), proved


def _undominated(held: Sequence[frozenset[T]]) -> dict[int, frozenset[T]]:
    """Scenarios by index, without those that hold nothing which another does not hold too."""
    first: dict[frozenset[T], int] = {}
    for index, found in enumerate(held):
        first.setdefault(found, index)
    kept: list[frozenset[T]] = []
    for found in sorted(first, key=lambda f: (-len(f), first[f])):
        if found and not any(found < larger for larger in kept):
            kept.append(found)
    return {first[found]: found for found in kept}
