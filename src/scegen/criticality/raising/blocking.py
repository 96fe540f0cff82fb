"""Why a search found nothing, in words."""

from __future__ import annotations

from scegen.criticality.search.optimize import Best
from scegen.criticality.search.problem import Problem

_MISSED = {
    "contacts": "nobody else touching",
    "finish": "everybody leaving in time",
    "lateral acceleration": "bends within the tyres' grip",
    "sameness": "being unlike the solutions known",
}
"""Demands in words that are neither a claim nor the target."""


def blocking(problem: Problem, best: Best) -> str:
    """Which demands the best candidate misses, and whether any candidate met them at all."""
    told = {claim.id: claim.statement for claim in problem.claims} | _MISSED
    told["target"] = problem.target.text
    words = []
    for name, missed in sorted(best.missing.items(), key=lambda item: -item[1]):
        if missed <= 0.0:
            continue
        never = best.least.get(name, 0.0) > 0.0
        why = "never reached" if never else "not together with the rest"
        words.append(f"{told.get(name, name)} ({why})")
    tried = f"{problem.evaluations:,} candidates within what is realistic"
    return f"blocked by {', '.join(words)} in {tried}"
