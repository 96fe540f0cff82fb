"""Every distinct scenario of a description: listing, streaming, counting."""

import gc
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from scegen.enumeration.building import Builder
from scegen.enumeration.choosing.where import where as where_test
from scegen.enumeration.counting import Census, census_of
from scegen.enumeration.feasibility import feasible
from scegen.enumeration.problem import Problem
from scegen.enumeration.reading import Solution
from scegen.enumeration.ruled import MAX_LISTED, RuledClasses, ruled_classes
from scegen.enumeration.selection import covering, selected
from scegen.enumeration.solving import solutions
from scegen.enumeration.symmetry import symmetry_in_words, symmetry_of
from scegen.errors import InputError
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Certificate, LogicalScenario, LogicalSet
from scegen.scenario.rule_file import RuleFile
from scegen.scenario.vocabulary import ArmsMode, Reduction

LIST_LIMIT = 2_000
"""More scenarios than this are not listed unless more are asked for."""
MOST_SELECTED = 20_000
"""Whoever wants more than this of even more gets the first ones."""


def enumerate_scenarios(
    functional: FunctionalScenario,
    *,
    reduction: Reduction = Reduction.EXACT,
    arms: ArmsMode = ArmsMode.DISTINCT,
    limit: int | None = None,
    where: str | None = None,
    rules: RuleFile | None = None,
) -> LogicalSet:
    """The logical scenarios of a functional one, each once, in a fixed order.

    Args:
        functional: the description, understood.
        reduction: which assignments count as one scenario.
        arms: whether the arms count alike or as built.
        limit: where there are more than so many, list so many, a covering and diverse selection
            (with ``where``, or of more than 20,000, the first in order); None lists all.
        where: list only those for which this expression holds (docs/how-to/where.md).
        rules: rules in ASP that every scenario keeps (docs/how-to/rules.md).

    Raises:
        NoScenarioError: the description contradicts itself; names what clashes.
        InfeasibleError: it asks for more than a junction holds.
        InputError: there are too many scenarios to count, or the expression or the rules cannot
            be used.
    """
    listing = open_listing(
        functional, reduction=reduction, arms=arms, limit=limit, where=where, rules=rules
    )
    with _collector_paused():
        return listing.finished(tuple(listing))


@dataclass
class Listing:
    """A listing under way: iterate to get the scenarios one by one, then ask for the rest."""

    census: Census
    reduction: Reduction
    arms: ArmsMode
    limit: int | None
    where: str | None
    ruled: RuledClasses | None
    seen: int = 0
    listed: int = 0
    assignments: int = 0
    exhausted: bool = False

    @property
    def selects(self) -> bool:
        """Whether a selection stands for more than are to be listed."""
        if self.where is not None or self.limit is None:
            return False
        return self.limit <= MOST_SELECTED and self.limit < self._count

    @property
    def expected(self) -> int:
        """How many scenarios will be looked at."""
        listed = self.limit if self.ruled is None and self.where is None else None
        return min(self._count, listed or self._count)

    def __iter__(self) -> Iterator[LogicalScenario]:
        keep = where_test(self.census.problem.functional, self.where) if self.where else None
        for scenario in _built(self.census.problem, self._solutions()):
            self.seen += 1
            self.assignments += scenario.class_size
            if keep is None or keep(scenario):
                self.listed += 1
                yield scenario
                if self.listed == self.limit:
                    break
        self.exhausted = self.seen == self._count
        if self.exhausted and self.assignments != self._total:
            raise AssertionError(
                f"class sizes add up to {self.assignments}, not to {self._total}: a bug"
            )

    def finished(self, scenarios: tuple[LogicalScenario, ...]) -> LogicalSet:
        """The set, once iteration has ended, with its certificate."""
        if self.limit is None and self.where is None and len(scenarios) != self._count:
            raise AssertionError(
                f"{len(scenarios)} scenarios listed, {self._count} counted: the two must agree"
            )
        return LogicalSet(
            functional=self.census.problem.functional,
            reduction=self.reduction,
            arms=self.arms,
            certificate=self.certificate(),
            notes=self.notes,
            scenarios=scenarios,
        )

    def certificate(self) -> Certificate:
        """What the listing claims, as far as iteration has come."""
        if self.ruled is None:
            whole = _certificate(self.census, self.reduction, self.arms, listed=self.seen)
        else:
            whole = self.ruled.certificate(complete=self.exhausted)
        whole = whole.but(looked_at=self.assignments)
        if self.where is None:
            return whole
        return whole.but(
            complete=self.exhausted,
            matching=self.listed if self.exhausted else None,
            method=f"{whole.method}; then those where {self.where}",
        )

    @property
    def notes(self) -> tuple[str, ...]:
        """What else there is to say about the set."""
        notes = [*self.census.problem.notes]
        if self.reduction is Reduction.PATTERN:
            notes.append(
                "The reduction pattern tells scenarios apart by how many vehicles make each move, "
                "and by nothing else; each stands for class_size assignments."
            )
        notes += self.ruled.notes if self.ruled else ()
        if self.selects:
            notes.append(
                f"Listed are {self.listed:,} of {self._count:,}: a selection with as many "
                "different ways, and pairs of ways, as so many scenarios can show."
            )
        return tuple(notes)

    @property
    def _count(self) -> int:
        if self.ruled is not None:
            return len(self.ruled.solutions)
        return self.census.count(self.reduction)

    @property
    def _total(self) -> int:
        return self.census.total if self.ruled is None else self.ruled.total

    def _solutions(self) -> Iterator[tuple[Solution, int]]:
        """What is to be built, with its class size."""
        census, reduction = self.census, self.reduction
        if self.ruled is not None and self.limit is not None and self.selects:
            sizes = dict(self.ruled.solutions)
            chosen = covering(census, list(sizes), self.limit)
            yield from ((solution, sizes[solution]) for solution in chosen)
        elif self.ruled is not None:
            yield from self.ruled.solutions[: self.limit if self.where is None else None]
        elif self.limit is not None and self.selects:
            for solution in selected(census, reduction, self.limit):
                yield solution, census.class_size(reduction, solution)
        else:
            yield from _stream(census, reduction, self.limit if self.where is None else None)


def open_listing(
    functional: FunctionalScenario,
    *,
    reduction: Reduction = Reduction.EXACT,
    arms: ArmsMode = ArmsMode.DISTINCT,
    limit: int | None = None,
    where: str | None = None,
    rules: RuleFile | None = None,
) -> Listing:
    """Everything up to the first scenario: as :func:`enumerate_scenarios`, to be streamed."""
    if limit is not None and limit < 1:
        raise InputError(f"a limit of {limit} lists nothing", hint="Use a limit of at least 1.")
    if where is not None:
        where_test(functional, where)  # before anything is enumerated
    census = _prepare(functional, arms)
    ruled = None if rules is None else ruled_classes(census, reduction, rules)
    return Listing(census, reduction, arms, limit, where, ruled)


@contextmanager
def _collector_paused() -> Iterator[None]:
    """Frozen models form no cycles: to look for some among 200,000 takes a fifth of the time."""
    running = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if running:
            gc.enable()


def iterate_scenarios(
    functional: FunctionalScenario,
    *,
    reduction: Reduction = Reduction.EXACT,
    arms: ArmsMode = ArmsMode.DISTINCT,
    limit: int | None = None,
) -> Iterator[LogicalScenario]:
    """All scenarios in order as a stream, for sets too large to hold; the first with a limit."""
    census = _prepare(functional, arms)
    yield from _built(census.problem, _stream(census, reduction, limit))


def _built(problem: Problem, listed: Iterable[tuple[Solution, int]]) -> Iterator[LogicalScenario]:
    """The scenarios of solutions with their class sizes, numbered in this order."""
    builder = Builder(problem)
    for index, (solution, size) in enumerate(listed):
        yield builder.scenario(solution, index=index, class_size=size)


def count_scenarios(
    functional: FunctionalScenario,
    *,
    reduction: Reduction = Reduction.EXACT,
    arms: ArmsMode = ArmsMode.DISTINCT,
) -> Certificate:
    """How many there are, without listing them."""
    return _certificate(_prepare(functional, arms), reduction, arms, listed=None)


def _prepare(functional: FunctionalScenario, arms: ArmsMode) -> Census:
    problem = feasible(functional, ranked=arms is ArmsMode.DISTINCT)
    return census_of(problem, symmetry_of(problem, arms))


def _stream(
    census: Census, reduction: Reduction, limit: int | None
) -> Iterator[tuple[Solution, int]]:
    """The scenarios in order, the first ones with a limit, with their class sizes."""
    count = census.count(reduction)
    if reduction is Reduction.PATTERN and count <= MAX_LISTED:
        # Projection finds patterns out of order; they are few, so they are sorted here.
        every = solutions(census.problem, census.symmetry, reduction)
        found = iter(sorted(every, key=lambda solution: solution.pattern)[:limit])
    else:
        found = solutions(census.problem, census.symmetry, reduction, limit=limit or 0)
    for solution in found:
        yield solution, census.class_size(reduction, solution)


_METHODS = {
    Reduction.NONE: "counted as products over the independent moves of each choice of entries",
    Reduction.PATTERN: "counted as the monomials of a product over the vehicles",
    Reduction.EXACT: "counted by Burnside's lemma",
}


def _certificate(
    census: Census, reduction: Reduction, arms: ArmsMode, *, listed: int | None
) -> Certificate:
    count = census.count(reduction)
    method = _METHODS[reduction]
    if listed is not None:
        method = f"answer sets listed by clingo; {method}"
    order, words = None, None
    if reduction is Reduction.NONE:
        order, words = 1, "every assignment is a scenario of its own"
    elif reduction is Reduction.EXACT:
        order = census.symmetry.order
        words = symmetry_in_words(census.problem, census.symmetry, arms)
    return Certificate(
        total=census.total,
        count=count,
        complete=listed is None or listed == count,
        method=method,
        group_order=order,
        symmetry=words,
    )
