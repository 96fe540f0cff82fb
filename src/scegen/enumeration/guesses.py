"""Whom a danger threatens may be a guess of the reader; a guess gives way where nothing fits it."""

from __future__ import annotations

from scegen.enumeration import predicates as p
from scegen.enumeration.explaining import clashing, contradiction
from scegen.enumeration.problem import Problem, build_problem
from scegen.enumeration.solving import Space, space_of
from scegen.errors import NoScenarioError
from scegen.scenario.functional import Evidence, FunctionalScenario
from scegen.scenario.vocabulary import EvidenceSource


def feasible(functional: FunctionalScenario) -> tuple[Problem, Space]:
    """The problem and its solutions, with as few guesses given up as it takes.

    What the text states is never given up. The functional scenario of the problem says which
    guesses were, in its evidence, and so do the problem's notes.

    Raises:
        NoScenarioError: what is stated contradicts itself; names the statements that clash.
    """
    given_up: list[str] = []
    refusal: NoScenarioError | None = None  # of the description as it was
    while True:
        problem = build_problem(functional, notes=tuple(given_up))
        space = space_of(problem)
        if space is not None:
            return problem, space
        clash = clashing(problem)
        refusal = refusal or contradiction(problem, clash)
        guess = _guessed(problem, clash)
        if guess is None:
            raise refusal
        functional, note = _left_open(functional, guess)
        given_up.append(note)


def _guessed(problem: Problem, clash: list[int]) -> int | None:
    """The first hazard in a clash whose sufferer the text does not name."""
    functional = problem.functional
    inferred = {e.field for e in functional.evidence if e.source is EvidenceSource.INFERRED}
    statements = [f.statement for f in problem.facts if isinstance(f, p.Hazard)]
    for index, (statement, hazard) in enumerate(zip(statements, functional.hazards, strict=True)):
        if statement in clash and hazard.to and f"hazards.{hazard.kind}.to" in inferred:
            return index
    return None


def _left_open(functional: FunctionalScenario, index: int) -> tuple[FunctionalScenario, str]:
    """The same with nobody named as the one who suffers this hazard, and what to say of it."""
    hazards = list(functional.hazards)
    hazard = hazards[index]
    hazards[index] = hazard.model_copy(update={"to": ()})
    by, to = " and ".join(hazard.by) or "somebody", " and ".join(hazard.to)
    reason = f"that {by} threatens {to} was a guess, and no scenario has it so: left open"
    field = f"hazards.{hazard.kind}.to"
    evidence = [e for e in functional.evidence if e.field != field]
    evidence.append(Evidence(field=field, source=EvidenceSource.INFERRED, reason=reason))
    relaxed = functional.model_copy(update={"hazards": tuple(hazards), "evidence": tuple(evidence)})
    return relaxed, f"{hazard.kind}: {reason}."
