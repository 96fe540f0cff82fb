"""Rules that are broken: red lights, signs, the right of way."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, DrivingSide, HazardKind
from scegen.understanding.draft import Draft

_FROM_THE_SIDE = frozenset({Approach.LEFT, Approach.RIGHT})


def onto_the_road(draft: Draft, side: DrivingSide) -> None:
    """Who comes from the side and turns left in front of somebody fails to give way.

    An unprotected left turn is one across oncoming traffic.

    Args:
        draft: the scenario in the making, positions settled.
        side: which side traffic keeps to.
    """
    for danger in draft.dangers:
        across = danger.kind is HazardKind.UNPROTECTED_LEFT_TURN and side is DrivingSide.RIGHT
        aside = all(e.approaches and e.approaches <= _FROM_THE_SIDE for e in danger.by)
        if across and danger.by and aside:
            danger.kind = HazardKind.FAILURE_TO_YIELD
