"""Ordinary speeds, within what the logical scenario allows."""

from __future__ import annotations

from scegen.concretization.asked import pace_of
from scegen.concretization.limits import JITTER
from scegen.concretization.setup import Setup
from scegen.scenario.bodies import BODIES
from scegen.scenario.functional import Participant

_SLOWEST_MPS = 1.0


def cruise_speed_mps(scene: Setup, participant: Participant, arm: int) -> float:
    """The parameter's default with a little jitter.

    Traffic that comes on one ``arm`` has one speed unless something else is said.
    """
    pace = pace_of(scene.functional, scene.logical, participant.id)
    # Drawn in any case, so that one participant's range does not shift another's draws.
    drawn = 1.0 + float(scene.rng.uniform(-JITTER, JITTER))
    factor = scene.paces.setdefault((arm, pace.default), drawn)
    top = BODIES[participant.kind].top_speed_mps
    speed = max(min(max(pace.default * factor, pace.low), pace.high, top), _SLOWEST_MPS)
    scene.note(pace.name, speed, pace.reason)
    return speed
