"""From proposals to where the search begins: asked for, validated, accounted for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from scegen.claims.ways import Way
from scegen.criticality.proposals.driving import hindrances
from scegen.criticality.proposals.proposal import Proposer
from scegen.criticality.proposals.situation import situation_of
from scegen.criticality.proposals.validating import Validator, Verdict
from scegen.criticality.search.optimize import Lead
from scegen.criticality.search.problem import Problem
from scegen.criticality.search.rebuild import rebuilt
from scegen.scenario.concrete import Change, ConcreteScenario
from scegen.scenario.proof import Advice, HazardProof

_DRAWS, _LOOKS = 1, 2
"""Streams of random numbers beside the search's own, which is not to change."""


@dataclass(frozen=True, slots=True)
class Advised:
    """The scenario with the proposals in it, the lead that they give, and the account of them."""

    concrete: ConcreteScenario
    lead: Lead | None
    advice: Advice


def advised(
    proposer: Proposer,
    problem: Problem,
    concrete: ConcreteScenario,
    ways: Mapping[str, Way],
    hazards: tuple[HazardProof, ...],
    *,
    seed: int,
) -> Advised:
    """Ask for proposals and validate them.

    ``ways`` lead from the outer ends of the arms; ``hazards`` tell which dangers happen already,
    ``seed`` is that of values which replace invalid ones.
    """
    situation = situation_of(problem, hazards)
    origin = problem.space.origin
    validator = Validator(situation.parameters, origin, lambda x: hindrances(problem, x))
    proposed = proposer.propose(situation, validator.judge)
    verdicts = validator.validate(proposed.proposals, proposed.speaker, _stream(seed, _DRAWS))
    advice = Advice(
        speaker=proposed.speaker,
        changes=tuple(
            Change(
                parameter=v.parameter,
                by=v.by,
                before=None if v.before is None else round(v.before, 3),
                after=None if v.after is None else round(v.after, 3),
                reason=v.reason,
                rejected=v.rejected,
            )
            for v in verdicts
        ),
        notes=proposed.notes,
    )
    if not verdicts or (verdicts[-1].x == origin).all():
        return Advised(concrete, None, advice)
    changed = _accounted(problem, concrete, ways, verdicts)
    return Advised(changed, Lead(verdicts[-1].x, _stream(seed, _LOOKS)), advice)


def _stream(seed: int, number: int) -> np.random.Generator:
    return np.random.Generator(np.random.PCG64([seed, number]))


def _accounted(
    problem: Problem,
    concrete: ConcreteScenario,
    ways: Mapping[str, Way],
    verdicts: tuple[Verdict, ...],
) -> ConcreteScenario:
    """The scenario with one proposal after the other in it, every change under its name."""
    outcome = problem.evaluate(np.array([v.x for v in verdicts]))
    for row, verdict in enumerate(verdicts):
        known = len(concrete.provenance)
        concrete = rebuilt(
            concrete,
            ways,
            outcome.made,
            row,
            float(outcome.duration_s[row]),
            verdict.reason,
            by=verdict.by,
        )
        if verdict.rejected is None:
            continue
        first, *rest = concrete.provenance[known:] or (
            Change(parameter=verdict.parameter, by=verdict.by, reason=verdict.reason),
        )
        told = first.model_copy(update={"rejected": verdict.rejected})
        provenance = (*concrete.provenance[:known], told, *rest)
        concrete = concrete.model_copy(update={"provenance": provenance})
    return concrete
