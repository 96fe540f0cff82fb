"""Why a search found nothing, and the claims that no numbers can make hold.

They are told as missed, and the rest is sought.
"""

from collections.abc import Collection

import numpy as np

from scegen.criticality.raising.stage import Stage
from scegen.criticality.search.optimize import Best, folded, halton
from scegen.criticality.search.problem import Problem
from scegen.criticality.search.proving import Evidence

_POINTS = 24
_MISSED = {
    "contacts": "nobody else touching",
    "finish": "everybody leaving in time",
    "lateral acceleration": "bends within the tyres' grip",
    "sameness": "being unlike the solutions known",
}
"""Demands in words that are neither a claim nor the target."""


def out_of_reach(problem: Problem, before: Evidence, rng: np.random.Generator) -> frozenset[str]:
    """Claims that do not hold now, nor differently anywhere: they lie in ways and lanes."""
    if before.holds(problem.given_up):
        return frozenset()
    space = problem.space
    points = folded(halton(_POINTS, rng.random(len(space.variables))))
    fixed = {claim.id for claim in problem.claims if claim.fixed}
    missed = {claim.id for claim in before.claims if not claim.holds}
    return problem.out_of_reach(space.at(points)) | (fixed & missed)


def give_up(stage: Stage, problem: Problem, claims: Collection[str]) -> None:
    """Ask no longer for these claims."""
    stage.given_up = problem.given_up = stage.given_up | frozenset(claims)


def blocking(problem: Problem, best: Best) -> str:
    """Which demands the best candidate misses, and whether any candidate met them at all."""
    told = {claim.id: claim.statement for claim in problem.claims} | _MISSED
    words = []
    for name, missed in sorted(best.missing.items(), key=lambda item: -item[1]):
        if missed <= 0.0 or name == "target":
            continue
        never = best.least.get(name, 0.0) > 0.0
        why = "never reached" if never else "not together with the rest"
        words.append(f"{told.get(name, name)} ({why})")
    if not problem.space.variables:
        return "what is said leaves no number open that could change it"
    tried = f"{problem.evaluations:,} candidates within what is realistic"
    return f"blocked by {', '.join(words)} in {tried}" if words else f"reached by none of {tried}"
