"""The problem of a description with as few presumptions given up as it takes."""

from __future__ import annotations

from scegen.enumeration.explaining import clashing, contradiction
from scegen.enumeration.problem import Problem, build_problem
from scegen.enumeration.solving import has_solution
from scegen.errors import NoScenarioError
from scegen.scenario.functional import FunctionalScenario


def feasible(functional: FunctionalScenario, *, ranked: bool = True) -> Problem:
    """The problem, which has solutions; what was presumed and given up is told in its notes.

    What the text states is never given up. ``ranked``: arms are told apart by their signs.

    Raises:
        NoScenarioError: what is stated contradicts itself; names the statements that clash.
    """
    left_open: frozenset[int] = frozenset()
    refusal: NoScenarioError | None = None  # of the description as it was
    while True:
        problem = build_problem(functional, left_open, ranked=ranked)
        if has_solution(problem):
            return problem
        clash = clashing(problem)
        refusal = refusal or contradiction(problem, clash)
        presumed = [problem.presumed[number] for number in clash if number in problem.presumed]
        if not presumed:
            raise refusal
        left_open |= {presumed[0]}
