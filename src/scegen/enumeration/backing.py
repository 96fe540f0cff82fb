"""Who stands square to the road and backs straight out of a bay, a driveway or a yard beside it."""

from __future__ import annotations

from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.in_line import words_between
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.vocabulary import Approach, HazardKind, JunctionKind, Maneuver

_ASIDE = frozenset({Approach.LEFT, Approach.RIGHT})


def backs_square(functional: FunctionalScenario, vehicle: Participant) -> bool:
    """Whether one that backs out goes straight back, as far as the words go.

    It stands beside the lanes, or others come past from a side of it, or at a junction it is said
    to go straight or to be hit; who is said to turn does that.
    """
    name, outcome = vehicle.id, functional.outcome
    if vehicle.maneuvers - {Maneuver.STRAIGHT}:
        return False
    if vehicle.strip is not None or any(
        passes_behind(functional, other.id, name) for other in functional.vehicles
    ):
        return True
    hit = outcome is not None and outcome.kind is OutcomeKind.COLLISION and name in outcome.between
    if functional.junction.kind is JunctionKind.STRAIGHT:
        return hit and bool(vehicle.approaches) and vehicle.approaches <= _ASIDE
    return hit or bool(vehicle.maneuvers)


def passes_behind(functional: FunctionalScenario, name: str, reference: str) -> bool:
    """Whether somebody comes from one side of another, who reverses towards it."""
    said = words_between(functional, name, reference)
    return frozenset() < said <= _ASIDE and any(
        hazard.kind is HazardKind.REVERSING
        and reference in hazard.by
        and (not hazard.to or name in hazard.to)
        for hazard in functional.hazards
    )
