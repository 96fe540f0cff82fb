"""Every distinct scenario of a description: listing, streaming, counting."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from scegen.enumeration.building import Builder
from scegen.enumeration.counting import Census, census
from scegen.enumeration.problem import Problem, build_problem
from scegen.enumeration.solving import Space, solutions, space_of
from scegen.enumeration.symmetry import Symmetry, symmetry_of
from scegen.errors import InputError
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Certificate, LogicalScenario, LogicalSet
from scegen.scenario.vocabulary import ArmsMode, Reduction

MAX_LISTED = 200_000
"""More scenarios than this are not listed unless a limit says how many are wanted."""


@dataclass(frozen=True)
class _Prepared:
    problem: Problem
    space: Space
    symmetry: Symmetry
    census: Census


def enumerate_scenarios(
    functional: FunctionalScenario,
    *,
    reduction: Reduction = Reduction.EXACT,
    arms: ArmsMode = ArmsMode.DISTINCT,
    limit: int | None = None,
) -> LogicalSet:
    """All logical scenarios of a functional one, each once, in a fixed order.

    Args:
        functional: the description, understood.
        reduction: which assignments count as one scenario.
        arms: whether the arms count alike or as built.
        limit: list at most so many, the first in order; None lists all.

    Raises:
        NoScenarioError: the description contradicts itself; names what clashes.
        InfeasibleError: it asks for more than a junction holds.
        InputError: there are too many scenarios to list or to count.
    """
    prepared = _prepare(functional, arms)
    scenarios = tuple(_stream(prepared, reduction, limit))
    count = prepared.census.count(reduction)
    certificate = _certificate(prepared, reduction, listed=len(scenarios))
    if limit is None and len(scenarios) != count:
        msg = f"{len(scenarios)} scenarios listed, {count} counted: the two must agree"
        raise AssertionError(msg)
    return LogicalSet(
        functional=functional,
        reduction=reduction,
        arms=arms,
        certificate=certificate,
        notes=_notes(prepared, reduction),
        scenarios=scenarios,
    )


def iterate_scenarios(
    functional: FunctionalScenario,
    *,
    reduction: Reduction = Reduction.EXACT,
    arms: ArmsMode = ArmsMode.DISTINCT,
    limit: int | None = None,
) -> Iterator[LogicalScenario]:
    """The same scenarios as a stream, for sets too large to hold."""
    prepared = _prepare(functional, arms)
    yield from _stream(prepared, reduction, limit, bounded=False)


def count_scenarios(
    functional: FunctionalScenario,
    *,
    reduction: Reduction = Reduction.EXACT,
    arms: ArmsMode = ArmsMode.DISTINCT,
) -> Certificate:
    """How many there are, without listing them."""
    return _certificate(_prepare(functional, arms), reduction, listed=None)


def _prepare(functional: FunctionalScenario, arms: ArmsMode) -> _Prepared:
    problem = build_problem(functional)
    space = space_of(problem)
    symmetry = symmetry_of(problem, arms)
    return _Prepared(problem, space, symmetry, census(space, symmetry))


def _stream(
    prepared: _Prepared, reduction: Reduction, limit: int | None, *, bounded: bool = True
) -> Iterator[LogicalScenario]:
    if limit is not None and limit < 1:
        raise InputError(f"a limit of {limit} lists nothing", hint="Use a limit of at least 1.")
    count = prepared.census.count(reduction)
    if bounded and limit is None and count > MAX_LISTED:
        raise InputError(
            f"{count:,} scenarios are too many to list (more than {MAX_LISTED:,})",
            hint="Use --limit to list the first ones, or --count-only to count them.",
        )
    if reduction is Reduction.PATTERN and count <= MAX_LISTED:
        # Projection finds patterns out of order; they are few, so they are sorted here.
        every = solutions(prepared.space, prepared.symmetry, reduction)
        found = iter(sorted(every, key=lambda solution: solution.pattern)[:limit])
    else:
        found = solutions(prepared.space, prepared.symmetry, reduction, limit=limit or 0)
    builder = Builder(prepared.problem)
    for index, solution in enumerate(found):
        size = prepared.census.class_size(reduction, solution)
        yield builder.scenario(solution, index=index, class_size=size)


_METHODS = {
    Reduction.NONE: "counted as products over the independent moves of each choice of entries",
    Reduction.PATTERN: "counted as the monomials of a product over the vehicles",
    Reduction.EXACT: "counted by Burnside's lemma",
}


def _certificate(prepared: _Prepared, reduction: Reduction, *, listed: int | None) -> Certificate:
    count = prepared.census.count(reduction)
    method = _METHODS[reduction]
    if listed is not None:
        method = f"answer sets listed by clingo; {method}"
    return Certificate(
        total=prepared.census.total,
        count=count,
        complete=listed is None or listed == count,
        method=method,
    )


def _notes(prepared: _Prepared, reduction: Reduction) -> tuple[str, ...]:
    notes = list(prepared.problem.notes)
    if prepared.space.crowding:
        notes.append(
            f"The statements put {prepared.space.crowding} vehicles on arms that are "
            "already taken; all others have the room of an even spread."
        )
    if reduction is Reduction.PATTERN:
        notes.append(
            "The reduction pattern tells scenarios apart by how many vehicles make each move, "
            "and by nothing else; each stands for class_size assignments."
        )
    return tuple(notes)
