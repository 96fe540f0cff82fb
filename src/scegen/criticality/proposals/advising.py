"""From proposals to where the search begins: asked for, validated, accounted for."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from scegen.claims.ways import Way
from scegen.criticality.proposals.driving import hindrances
from scegen.criticality.proposals.proposal import Proposer
from scegen.criticality.proposals.situation import situation_of
from scegen.criticality.proposals.validating import Validator
from scegen.criticality.search.optimize import Lead
from scegen.criticality.search.problem import Problem
from scegen.criticality.search.rebuild import rebuilt
from scegen.motion.batch.arrays import Floats
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
    draws = _stream(seed, _DRAWS)
    changes, rows = validator.validate(proposed.proposals, proposed.speaker, draws)
    advice = Advice(speaker=proposed.speaker, changes=changes, notes=proposed.notes)
    if not changes or (rows[-1] == origin).all():
        return Advised(concrete, None, advice)
    changed = _accounted(problem, concrete, ways, changes, rows)
    return Advised(changed, Lead(rows[-1], _stream(seed, _LOOKS)), advice)


def _stream(seed: int, number: int) -> np.random.Generator:
    return np.random.Generator(np.random.PCG64([seed, number]))


def _accounted(
    problem: Problem,
    concrete: ConcreteScenario,
    ways: Mapping[str, Way],
    changes: tuple[Change, ...],
    rows: Floats,
) -> ConcreteScenario:
    """The scenario with one proposal after the other in it, every change under its name."""
    outcome = problem.evaluate(rows)
    for row, change in enumerate(changes):
        known = len(concrete.provenance)
        concrete = rebuilt(
            concrete,
            ways,
            outcome.made,
            row,
            float(outcome.duration_s[row]),
            change.reason,
            by=change.by,
        )
        if change.rejected is None:
            continue
        first, *rest = concrete.provenance[known:] or (
            Change(parameter=change.parameter, by=change.by, reason=change.reason),
        )
        told = first.but(rejected=change.rejected)
        provenance = (*concrete.provenance[:known], told, *rest)
        concrete = concrete.but(provenance=provenance)
    return concrete
