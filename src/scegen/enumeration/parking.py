"""Where parked vehicles stand: not enumerated, but following from where the others enter."""

from __future__ import annotations

from collections.abc import Mapping

from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.logical import Standing
from scegen.scenario.vocabulary import Approach, HazardKind, Side

BLOCKING = frozenset({HazardKind.OBSTACLE, HazardKind.STOPPING})
"""Hazards by which a parked vehicle stands in the travelled lane."""
HIDING = BLOCKING | {HazardKind.OCCLUSION}


def standing(
    functional: FunctionalScenario, parked: Participant, entry_of: Mapping[str, int]
) -> Standing:
    """A parked vehicle stands on the arm where the one whom it hinders enters."""
    hindered = (*_hindered_by(functional, parked.id), functional.ego.id)
    arm = next(entry_of[name] for name in hindered if name in entry_of)
    if parked.entries and arm not in parked.entries:
        arm = min(parked.entries)
    kerb = Side(functional.junction.driving_side.value)
    said = parked.approaches & {Approach.LEFT, Approach.RIGHT}
    side = Side(next(iter(said)).value) if len(said) == 1 else kerb
    blocks = not parked.pulls_out and any(
        h.kind in BLOCKING and parked.id in h.by for h in functional.hazards
    )
    return Standing(participant=parked.id, arm=arm, side=side, in_lane=blocks)


def _hindered_by(functional: FunctionalScenario, name: str) -> list[str]:
    hindered = [
        sufferer
        for hazard in functional.hazards
        if hazard.kind in HIDING and name in hazard.by
        for sufferer in hazard.to
    ]
    return hindered + [r.reference for r in functional.relations if r.participant == name]
