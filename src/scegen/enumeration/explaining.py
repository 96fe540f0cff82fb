"""Why a functional scenario has no scenario: statements that cannot hold together."""

from __future__ import annotations

from scegen.enumeration import answers as a
from scegen.enumeration import predicates as p
from scegen.enumeration.problem import Problem
from scegen.enumeration.programs import SCENARIO_PARTS, Part, grounded, satisfiable
from scegen.errors import NoScenarioError


def clashing(problem: Problem) -> list[int]:
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


def contradiction(problem: Problem, clash: list[int]) -> NoScenarioError:
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
