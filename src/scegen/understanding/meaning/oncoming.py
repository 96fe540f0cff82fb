"""Who comes from the front, by what they have to do with others that do."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind
from scegen.understanding.draft import Basis
from scegen.understanding.semantics.context import Context


def turned_across(context: Context) -> None:
    """``the ego turns left across the path of a motorcyclist``: who comes towards it."""
    for danger in context.draft.dangers:
        if danger.kind is not HazardKind.UNPROTECTED_LEFT_TURN or not any(e.ego for e in danger.by):
            continue
        others = [e for e in context.draft.entities if e.moving_vehicle and not e.ego]
        for entity in danger.to or (others if len(others) == 1 else []):
            told = any(p.entity is entity for p in context.draft.placements)
            if entity.moving_vehicle and not told and entity.heading is None:
                basis = Basis(danger.basis.i, danger.basis.j, "the turn leads across its way")
                context.draft.place(entity, None, {Approach.OPPOSITE}, basis)
