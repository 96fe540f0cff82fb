"""Ways that are ruled out: "none of them may turn left"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Maneuver
from scegen.understanding.draft import Entity

_WAYS = frozenset({Maneuver.LEFT, Maneuver.RIGHT, Maneuver.STRAIGHT})


def ways_left(entity: Entity) -> set[Maneuver]:
    """The ways over a junction that are not ruled out; empty where nothing is said."""
    if not entity.excluded & _WAYS or not entity.is_vehicle:
        return set()
    return set(_WAYS - entity.excluded)
