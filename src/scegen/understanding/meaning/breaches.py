"""Rules that are broken: speed limits, the right of way."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, DrivingSide, HazardKind
from scegen.understanding.draft import Draft

_FROM_THE_SIDE = frozenset({Approach.LEFT, Approach.RIGHT})
_MARGIN = 1.1
_ANYWHERE_MPS = 44.0
"""About 100 mph: too fast wherever there is a limit."""


def onto_the_road(draft: Draft, side: DrivingSide) -> None:
    """Who comes from the side and turns left in front of somebody fails to give way.

    An unprotected left turn is one across oncoming traffic.
    """
    for danger in draft.dangers:
        across = danger.kind is HazardKind.UNPROTECTED_LEFT_TURN and side is DrivingSide.RIGHT
        aside = all(e.approaches and e.approaches <= _FROM_THE_SIDE for e in danger.by)
        if across and danger.by and aside:
            danger.kind = HazardKind.FAILURE_TO_YIELD


def too_fast(draft: Draft, limit_mps: float | None) -> None:
    """``at 60 mph in a 35 mph zone``: speeding, though nobody says the word."""
    allowed = limit_mps * _MARGIN if limit_mps is not None else _ANYWHERE_MPS
    for entity in draft.entities:
        speed, basis = entity.speed, entity.speed_basis
        if not entity.moving_vehicle or speed is None or basis is None:
            continue
        if speed.low >= allowed:
            draft.hazard(HazardKind.SPEEDING, basis, [entity])
