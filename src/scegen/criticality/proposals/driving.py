"""Whether values can be driven: nobody stands in somebody, bends hold, everybody gets through."""

from __future__ import annotations

from itertools import combinations

from scegen.concretization.boxes import overlap
from scegen.criticality.search.problem import Problem
from scegen.motion.batch.arrays import Floats
from scegen.scenario.bodies import BODIES

_TYRES = "somebody takes a bend faster than the tyres hold"


def hindrances(problem: Problem, x: Floats) -> frozenset[str]:
    """Why values of all variables (n,) cannot be driven; nothing: they can."""
    outcome = problem.evaluate(x[None, :])
    found = set(_overlaps(problem, outcome.made.start_m[0]))
    if outcome.missing["lateral acceleration"][0] > 0.0:
        found.add(_TYRES)
    if outcome.missing["finish"][0] > 0.0:
        found.add(
            f"somebody is still under way after {problem.duration_s:.0f} s, or waits at the end of "
            "its road"
        )
    return frozenset(found)


def _overlaps(problem: Problem, start_m: Floats) -> list[str]:
    """Pairs whose bodies overlap where they start; ``start_m`` (participants,)."""
    people = problem.concrete.participants  # things, which come after them, stay
    poses = [problem.ways[p.id].path.pose(float(s)) for p, s in zip(people, start_m, strict=False)]
    return [
        f"{first.id} and {second.id} overlap at the start"
        for (first, one), (second, other) in combinations(zip(people, poses, strict=True), 2)
        if overlap(one, BODIES[first.kind], other, BODIES[second.kind])
    ]
