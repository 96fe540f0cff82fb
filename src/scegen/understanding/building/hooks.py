"""Turns across somebody alongside: "the ego turns right, a cyclist on its right goes straight"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, ParticipantKind
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.words.tokens import Token

_RIDERS = frozenset({ParticipantKind.BICYCLE, ParticipantKind.MOTORCYCLE})
_TURNS = {Approach.RIGHT: Maneuver.RIGHT, Approach.LEFT: Maneuver.LEFT}


def alongside(draft: Draft, ego: Entity, tokens: list[Token]) -> None:
    """A rider on the side to which the ego turns, and who goes on, is beside it.

    One who comes *from* that side comes out of the road there.
    """
    for entity in draft.entities:
        basis = entity.approach_basis
        if entity is ego or entity.kind not in _RIDERS or basis is None or basis.i is None:
            continue
        seen = entity.approaches - {Approach.BEHIND}  # "from behind on its right"
        side = next(iter(seen)) if len(seen) == 1 else None
        turn = _TURNS.get(side) if side is not None else None
        crosses = any(
            d.kind is HazardKind.CROSSING_CYCLIST and entity in d.by for d in draft.dangers
        )
        goes_on = entity.maneuvers <= {Maneuver.STRAIGHT} and not crosses
        words = [t.low for t in tokens[basis.i : basis.j]]
        from_behind = Approach.BEHIND in entity.approaches
        comes_from = (words[:1] == ["from"] and not from_behind) or "front" in words
        if turn is None or ego.maneuvers != {turn} or not goes_on or comes_from:
            continue
        reason = f"beside the ego, on the {side}: it turns across its way"
        entity.approaches = {Approach.ADJACENT, *seen}
        entity.approach_basis = Basis(basis.i, basis.j, reason)
