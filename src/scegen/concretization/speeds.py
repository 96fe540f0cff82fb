"""Ordinary speeds, within what the logical scenario allows."""

from __future__ import annotations

from scegen.concretization.asked import endangering_mps
from scegen.concretization.limits import CYCLING_MPS, JITTER
from scegen.concretization.setup import Setup
from scegen.scenario.bodies import BODIES
from scegen.scenario.functional import Participant
from scegen.scenario.vocabulary import ParticipantKind

_SLOWEST_MPS = 1.0


def cruise_speed_mps(scene: Setup, participant: Participant, arm: int) -> float:
    """The parameter's default (or the limit, or a cyclist's pace) with a little jitter.

    Traffic that comes on one ``arm`` has one speed unless something else is said.
    """
    name = f"{participant.id}.speed_mps"
    usual = CYCLING_MPS if participant.kind is ParticipantKind.BICYCLE else scene.limit_mps
    hazards = scene.functional.hazards
    usual = endangering_mps(hazards, participant.id, participant.kind, scene.limit_mps) or usual
    low, high, reason = 0.0, 100.0, "usual speed"
    for parameter in scene.logical.parameters:
        if parameter.name == name:
            usual, low, high, reason = (
                parameter.default,
                parameter.low,
                parameter.high,
                parameter.reason,
            )
    # Drawn in any case, so that one participant's range does not shift another's draws.
    drawn = 1.0 + float(scene.rng.uniform(-JITTER, JITTER))
    factor = scene.paces.setdefault((arm, usual), drawn)
    top = BODIES[participant.kind].top_speed_mps
    speed = max(min(max(usual * factor, low), high, top), _SLOWEST_MPS)
    scene.note(name, speed, reason)
    return speed
