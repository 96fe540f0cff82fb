"""Scenarios under a user's rules: every assignment is tried, then the allowed ones are reduced.

Rules may tell apart what the reduction holds to be the same (one arm from another, one car from
its like), so it would be wrong to try them on one representative of each class. The assignments
that they allow are listed without any reduction; those of one class are then one scenario, whose
class_size counts the allowed alone. So the class sizes still add up to the total.
"""

from collections.abc import Hashable
from dataclasses import dataclass
from itertools import islice

from scegen.enumeration.counting import Census
from scegen.enumeration.reading import Solution
from scegen.enumeration.user_rules import ruled_solutions
from scegen.errors import InputError, NoScenarioError
from scegen.scenario.logical import Certificate
from scegen.scenario.rule_file import RuleFile
from scegen.scenario.vocabulary import Reduction

MAX_LISTED = 200_000
"""More assignments than this are not listed to try a user's rules on each."""


@dataclass(frozen=True)
class RuledClasses:
    """The scenarios that keep the rules, each with the number of assignments it stands for."""

    total: int
    solutions: tuple[tuple[Solution, int], ...]
    notes: tuple[str, ...]

    def certificate(self, *, complete: bool) -> Certificate:
        """What is claimed under the rules."""
        return Certificate(
            total=self.total,
            count=len(self.solutions),
            complete=complete,
            method="all assignments that keep the rules listed by clingo, then reduced",
        )


def ruled_classes(census: Census, reduction: Reduction, rules: RuleFile) -> RuledClasses:
    """List what the rules allow, and reduce it.

    Raises:
        InputError: the rules cannot be used, or allow too many assignments.
        NoScenarioError: they allow none.
    """
    first: dict[Hashable, Solution] = {}
    sizes: dict[Hashable, int] = {}
    for solution in islice(ruled_solutions(census.problem, rules), MAX_LISTED + 1):
        key = census.class_key(reduction, solution)
        first.setdefault(key, solution)
        sizes[key] = sizes.get(key, 0) + 1
    total = sum(sizes.values())
    if total > MAX_LISTED:
        raise InputError(
            f"the rules allow more than {MAX_LISTED:,} assignments, too many to list",
            where=rules.name,
            hint="Forbid more, or use --where, which needs no list of assignments.",
        )
    if not total:
        raise NoScenarioError("the rules leave no scenario", where=rules.name)
    parted = sum(size < census.class_size(reduction, first[key]) for key, size in sizes.items())
    notes = [f"The rules leave {total:,} of {census.total:,} assignments."]
    if parted:
        notes.append(
            f"The rules tell apart what the reduction {reduction} holds to be one scenario: of "
            f"{parted:,} of the {len(first):,} scenarios they allow only some assignments."
        )
    solutions = tuple((first[key], sizes[key]) for key in first)
    return RuledClasses(total, solutions, tuple(notes))
