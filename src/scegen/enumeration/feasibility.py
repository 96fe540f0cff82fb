"""The problem of a description with as few presumptions given up as it takes."""

from scegen.enumeration import answers as a
from scegen.enumeration import predicates as p
from scegen.enumeration.problem import Problem, build_problem
from scegen.enumeration.programs import SCENARIO_PARTS, Part, grounded, satisfiable
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
        clash = _clashing(problem)
        refusal = refusal or _contradiction(problem, clash)
        presumed = [problem.presumed[number] for number in clash if number in problem.presumed]
        if not presumed:
            raise refusal
        left_open |= {presumed[0]}


def _clashing(problem: Problem) -> list[int]:
    """A smallest set of statements, by number, which cannot all hold.

    Statements are given up one by one: one without which the rest is still contradictory has
    no part in the contradiction; what remains clashes, and without any of it nothing would.
    """
    facts = (*problem.facts, *(p.Decides(v.id) for v in problem.vehicles))
    control = grounded(facts, (*SCENARIO_PARTS, Part.EXPLAIN))
    clash = list(range(len(problem.words)))
    for statement in range(len(problem.words)):
        rest = [a.Holds(other) for other in clash if other != statement]
        if not satisfiable(control, rest):
            clash.remove(statement)
    return clash


def _contradiction(problem: Problem, clash: list[int]) -> NoScenarioError:
    """The error that names the statements of a clash."""
    junction = problem.functional.junction
    told = "; ".join(problem.words[statement] for statement in clash)
    return NoScenarioError(
        f"no scenario at a {junction.kind} junction with {junction.arms} arms: {told}",
        where="functional scenario",
        hint="These cannot all hold: change or leave out one of them."
        if len(clash) > 1
        else "This cannot hold here: change it or leave it out.",
    )
