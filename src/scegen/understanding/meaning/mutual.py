"""Positions of others towards each other, and how statements of place go together."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach
from scegen.understanding.draft import Basis, Draft, Entity


def allow(entity: Entity, approaches: set[Approach], basis: Basis) -> None:
    """Two statements narrow each other down; where they differ, both are allowed.

    Args:
        entity: who is placed.
        approaches: where from, as one statement says.
        basis: its words.
    """
    if not approaches or (approaches == {Approach.AHEAD} and entity.approaches - approaches):
        return  # "… from the left and stops in front of the ego": where it gets to
    along = {Approach.AHEAD, Approach.BEHIND}
    if approaches == {Approach.ADJACENT} and entity.approaches and entity.approaches <= along:
        entity.approaches = set()  # "30 m ahead in the next lane": beside, so far ahead
    if approaches <= along and entity.approaches == {Approach.ADJACENT}:
        return
    common = entity.approaches & approaches
    entity.approaches = common or (entity.approaches | approaches)
    if entity.approach_basis is None or common:
        entity.approach_basis = basis


def in_file(relations: list[tuple[Entity, Entity, set[Approach], Basis]]) -> None:
    """``a motorcycle behind an oncoming van``: it comes from where the van comes from.

    Args:
        relations: positions of two, neither of them the ego.
    """
    across = {Approach.OPPOSITE, Approach.LEFT, Approach.RIGHT}
    for entity, reference, approaches, basis in relations:
        along = approaches <= {Approach.AHEAD, Approach.BEHIND}
        both = entity.moving_vehicle and reference.moving_vehicle
        if along and both and not entity.approaches and reference.approaches <= across:
            reason = "one drives behind the other"
            allow(entity, set(reference.approaches), Basis(basis.i, basis.j, reason))


def face_each_other(
    draft: Draft, ego: Entity, relations: list[tuple[Entity, Entity, set[Approach], Basis]]
) -> None:
    """``from opposite directions``: each comes towards the others.

    Args:
        draft: the scenario in the making.
        ego: its ego.
        relations: positions of two others; some are added.
    """
    for entity in draft.entities:
        if entity is ego or not entity.opposed:
            continue
        basis = entity.approach_basis or entity.basis
        if ego.index in entity.opposed:
            allow(entity, {Approach.OPPOSITE}, basis)
            continue
        first = min(entity.opposed)
        if first < entity.index:
            reference = draft.entities[first]
            relations.append((entity, reference, {Approach.OPPOSITE}, basis))
