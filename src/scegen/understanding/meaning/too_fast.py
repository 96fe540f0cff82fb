"""Speeds that are given as numbers and are more than the limit allows."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind
from scegen.understanding.draft import Draft

_MARGIN = 1.1
_ANYWHERE_MPS = 44.0
"""About 100 mph: too fast wherever there is a limit."""


def too_fast(draft: Draft, limit_mps: float | None) -> None:
    """``at 60 mph in a 35 mph zone``: speeding, though nobody says the word.

    Args:
        draft: the scenario in the making.
        limit_mps: the speed limit, if one is given.
    """
    allowed = limit_mps * _MARGIN if limit_mps is not None else _ANYWHERE_MPS
    for entity in draft.entities:
        speed, basis = entity.speed, entity.speed_basis
        if not entity.moving_vehicle or speed is None or basis is None:
            continue
        if speed.low >= allowed:
            draft.hazard(HazardKind.SPEEDING, basis, [entity])
