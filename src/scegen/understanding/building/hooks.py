"""Turns across somebody alongside: "the ego turns right, a cyclist on its right goes straight"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, ParticipantKind
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Entity

_RIDERS = frozenset({ParticipantKind.BICYCLE, ParticipantKind.MOTORCYCLE})
_TURNS = {Approach.RIGHT: Maneuver.RIGHT, Approach.LEFT: Maneuver.LEFT}


def alongside(draft: Draft, ego: Entity) -> None:
    """A rider on the side to which the ego turns, and who goes on, is beside it.

    One who comes *from* that side comes out of the road there.
    """
    crossing = draft.causing(HazardKind.CROSSING_CYCLIST)
    for entity in draft.entities:
        basis = entity.approach_basis
        if entity is ego or entity.kind not in _RIDERS or basis is None or basis.i is None:
            continue
        seen = entity.approaches - {Approach.BEHIND}  # "from behind on its right"
        side = next(iter(seen)) if len(seen) == 1 else None
        turned_to = side is not None and side in _TURNS and ego.maneuvers == {_TURNS[side]}
        goes_on = entity.maneuvers <= {Maneuver.STRAIGHT} and entity not in crossing
        if turned_to and goes_on and not off_the_road(entity, draft):
            reason = f"beside the ego, on the {side}: it turns across its way"
            entity.comes_from({Approach.ADJACENT, *entity.approaches}, basis.because(reason))


def off_the_road(entity: Entity, draft: Draft) -> bool:
    """``from the right``, ``on the right front``: out of the road or off the pavement there."""
    return from_a_side(entity, draft) or "front" in _words_of_place(entity, draft)


def from_a_side(entity: Entity, draft: Draft) -> bool:
    """``from the right``; not ``1 m from the ego's right side``, ``from behind on the right``."""
    words = _words_of_place(entity, draft)
    return words[:1] == ["from"] and "'s" not in words and Approach.BEHIND not in entity.approaches


def _words_of_place(entity: Entity, draft: Draft) -> list[str]:
    basis = entity.approach_basis or entity.basis
    return [t.low for t in draft.tokens[basis.i : basis.j]] if basis.i is not None else []
