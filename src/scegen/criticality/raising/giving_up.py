"""Claims that no numbers can make hold: they are told as missed, and the rest is sought."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from scegen.criticality.raising.stage import Stage
from scegen.criticality.search.optimize import folded, halton
from scegen.criticality.search.problem import Problem
from scegen.criticality.search.proving import Evidence

_POINTS = 24


def out_of_reach(problem: Problem, before: Evidence, rng: np.random.Generator) -> frozenset[str]:
    """Claims that do not hold now, nor differently anywhere: they lie in ways and lanes."""
    if before.holds(problem.given_up):
        return frozenset()
    space = problem.space
    points = folded(halton(_POINTS, len(space.low), rng.random(len(space.low))))
    fixed = {claim.id for claim in problem.claims if claim.fixed}
    missed = {claim.id for claim in before.claims if not claim.holds}
    return problem.out_of_reach(space.low + points * (space.high - space.low)) | (fixed & missed)


def give_up(stage: Stage, problem: Problem, claims: Collection[str]) -> None:
    """Ask no longer for these claims."""
    stage.given_up = problem.given_up = stage.given_up | frozenset(claims)
