"""Who comes by a ramp, leaves by one, or is in a lane that ends: the lane beside the others."""

from __future__ import annotations

from typing import TypeAlias

from scegen.scenario.roadway import AuxiliaryLane
from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.building.in_lane import JOINING
from scegen.understanding.building.leftovers import ONE_RAMP
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.road.lengthwise import Lengthwise
from scegen.understanding.semantics.approaches import INVERSE

Used: TypeAlias = tuple[AuxiliaryLane, Basis] | None
"""The auxiliary lane that somebody uses, with the words for that."""


def auxiliary_lane(draft: Draft, *, drops: bool) -> Used:
    """The auxiliary lane that somebody uses, with the words for it; of two, who joins counts.

    It ``drops`` where the text names a lane that ends, and no ramp.
    """
    driven = [e for e in draft.entities if e.moving_vehicle]
    for words in (e.by_ramp for e in driven if e.by_ramp is not None):
        return AuxiliaryLane.LANE_DROP if drops else AuxiliaryLane.ON_RAMP, words
    return next(((AuxiliaryLane.OFF_RAMP, e.exits) for e in driven if e.exits is not None), None)


def settle_ramp(
    draft: Draft, ego: Entity, auxiliary: AuxiliaryLane, along: Lengthwise, *, beside_ego: bool
) -> None:
    """Who uses the auxiliary lane merges or exits, from or to the side of the kerb."""
    kerb = Approach(draft.kerb)
    leaves = auxiliary is AuxiliaryLane.OFF_RAMP
    for entity in draft.entities:
        basis = entity.exits if leaves else entity.by_ramp
        draft.note_at(None if leaves else entity.exits, ONE_RAMP)
        if basis is None or not entity.moving_vehicle:
            continue
        entity.maneuvers = {Maneuver.EXIT if leaves else Maneuver.MERGE}
        entity.maneuver_basis = basis
        if leaves:
            continue
        entity.start_lane = (JOINING, basis) if along.alongside else None
        if not entity.ego and ego.by_ramp is None:
            beside = {Approach.ADJACENT, kerb} if beside_ego else set[Approach]()
            entity.comes_from(beside, entity.approach_basis or basis)
    if ego.by_ramp is None or leaves:
        return
    for entity in draft.entities:
        # All others are on the road that the ego joins, which lies to the other side.
        there = entity.beside is not None and entity.beside[0] == kerb.value
        # "In front of a truck" is where it gets to: until then the truck drives beside the ramp.
        there = there or entity.approaches in ({Approach.AHEAD}, {Approach.BEHIND})
        if entity.by_ramp is None and there:
            entity.approaches = {Approach.ADJACENT}
            entity.beside = INVERSE[kerb].value, entity.approach_basis or ego.by_ramp
            if entity.in_next_lane is not None and entity.in_next_lane[0] == {Approach.BEHIND}:
                entity.in_next_lane = None
