"""Who comes from the front, by what they have to do with others that do."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind
from scegen.understanding.draft import Basis, Entity
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


def _from_the_front(entity: Entity, context: Context) -> bool:
    return context.oncoming(entity) or any(
        p.entity is entity
        and p.approaches == {Approach.OPPOSITE}
        and p.reference is not None
        and p.reference.ego
        for p in context.draft.placements
    )


def unseen(context: Context) -> None:
    """``an oncoming truck hides the lane beside it, from which a van comes``: from the front."""
    draft = context.draft
    for danger in draft.dangers:
        hidden = [e for e in danger.by if e.moving_vehicle and not e.ego]
        if danger.kind is not HazardKind.OCCLUSION or not hidden:
            continue
        others = [e for e in draft.entities if e.moving_vehicle and e not in hidden and not e.ego]
        if not others or not all(_from_the_front(e, context) for e in others):
            continue
        for entity in hidden:
            if not any(p.entity is entity for p in draft.placements):
                basis = Basis(danger.basis.i, danger.basis.j, "what hides it comes from the front")
                draft.place(entity, None, {Approach.OPPOSITE}, basis)
