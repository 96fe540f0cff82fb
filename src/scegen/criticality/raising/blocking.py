"""Why a search found nothing, in words."""

from __future__ import annotations

from scegen.claims.hazards.roles import culprits
from scegen.criticality.search.optimize import Best
from scegen.criticality.search.problem import Problem, judged

_MISSED = {
    "contacts": "nobody else touching",
    "finish": "everybody leaving in time",
    "lateral acceleration": "bends within the tyres' grip",
    "sameness": "being unlike the solutions known",
}
"""Demands in words that are not a danger or the target."""


def blocking(problem: Problem, best: Best) -> str:
    """Which demands the best candidate misses, and whether any candidate met them at all."""
    hazards = judged(problem.concrete)
    words = []
    for name, missed in sorted(best.missing.items(), key=lambda item: -item[1]):
        if missed <= 0.0:
            continue
        shown = problem.target.text if name == "target" else _MISSED.get(name, name)
        if name.startswith("hazard "):
            hazard = hazards[int(name.split()[1])]
            by = ", ".join(culprits(problem.concrete, hazard)) or "nobody"
            shown = f"{hazard.kind} by {by}"
        never = best.least.get(name, 0.0) > 0.0
        words.append(f"{shown} ({'never reached' if never else 'not together with the rest'})")
    tried = f"{problem.evaluations:,} candidates within what is realistic"
    return f"blocked by {', '.join(words)} in {tried}"
