"""Positions of others towards each other, and how statements of place go together."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity

_ALONG = frozenset({Approach.AHEAD, Approach.BEHIND})


def allow(entity: Entity, approaches: set[Approach], basis: Basis) -> None:
    """Two statements narrow each other down; where they differ, both are allowed."""
    if approaches and approaches <= _ALONG and entity.approaches == {Approach.ADJACENT}:
        entity.in_next_lane = entity.in_next_lane or (approaches, basis)
        return
    if not approaches or (approaches == {Approach.AHEAD} and entity.approaches - approaches):
        return  # "… from the left and stops in front of the ego": where it gets to
    if approaches == {Approach.ADJACENT} and entity.approaches and entity.approaches <= _ALONG:
        entity.in_next_lane = entity.approaches, entity.approach_basis or entity.basis
        entity.approaches = set()  # "30 m ahead in the next lane": beside, so far ahead
    common = entity.approaches & approaches
    entity.approaches = common or (entity.approaches | approaches)
    if entity.approach_basis is None or common:
        entity.approach_basis = basis


def face_each_other(draft: Draft, ego: Entity) -> None:
    """``from opposite directions``: each comes towards the others, the ego among them."""
    for entity in draft.entities:
        if entity is not ego and ego.index in entity.opposed:
            allow(entity, {Approach.OPPOSITE}, entity.approach_basis or entity.basis)
