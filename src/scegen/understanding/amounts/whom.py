"""Between whom a distance or a time lies, where the words leave one of them out."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach
from scegen.understanding.draft import Entity
from scegen.understanding.meaning.context import Context


def ego_of(context: Context) -> Entity | None:
    """The ego, if the text names one."""
    return next((e for e in context.draft.entities if e.ego), None)


def counterpart(entity: Entity, context: Context, near: list[Entity]) -> Entity | None:
    """The other of two: for everybody the ego; for the ego who is ahead, or the only other.

    Args:
        entity: one of them.
        context: the scenario in the making.
        near: who is spoken of around, the nearest last.
    """
    ego = ego_of(context)
    if entity is not ego and ego is not None:
        return ego
    others = [e for e in context.draft.entities if e is not entity]
    named = [e for e in reversed(near) if e in others]
    ahead = [e for e in others if context.placed(e, Approach.AHEAD) or "ahead" in e.dirs | e.loci]
    moving = [e for e in ahead if e.stands is None and not e.parked]
    for choice in (
        [e for e in named if e in moving],
        [e for e in named if e in ahead],
        named,
        moving,
        ahead,
        [e for e in others if not e.parked],
    ):
        if choice:
            return choice[0]
    return others[0] if len(others) == 1 else None


def in_file(one: Entity, other: Entity, context: Context) -> tuple[Entity, Entity]:
    """Two as follower and leader: a headway is that of the one behind."""
    for placement in context.draft.placements:
        reference = placement.reference or ego_of(context)
        if {placement.entity, reference} != {one, other} or reference is None:
            continue
        if placement.approaches == {Approach.AHEAD}:
            return reference, placement.entity
        if placement.approaches == {Approach.BEHIND}:
            return placement.entity, reference
    return (one, other) if one.ego or not other.ego else (other, one)
