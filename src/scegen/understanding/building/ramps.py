"""Who comes by a ramp, leaves by one, or is in a lane that ends: the lane beside the others."""

from __future__ import annotations

from scegen.scenario.roadway import AuxiliaryLane
from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.building.leftovers import ONE_RAMP
from scegen.understanding.draft import Basis, Draft, Entity

_SIDES = {"left": Approach.LEFT, "right": Approach.RIGHT}


def auxiliary_lane(draft: Draft, said: AuxiliaryLane | None) -> tuple[AuxiliaryLane, Basis] | None:
    """The auxiliary lane that somebody uses, with the words for it; of two, who joins counts.

    Args:
        draft: the scenario in the making.
        said: the one that the text names, which tells a ramp from a lane that ends.
    """
    drops = said is AuxiliaryLane.LANE_DROP
    for entity in draft.entities:
        if entity.by_ramp is not None and entity.moving_vehicle:
            return AuxiliaryLane.LANE_DROP if drops else AuxiliaryLane.ON_RAMP, entity.by_ramp
    for entity in draft.entities:
        if entity.exits is not None and entity.moving_vehicle:
            return AuxiliaryLane.OFF_RAMP, entity.exits
    return None


def settle_ramp(draft: Draft, ego: Entity, auxiliary: AuxiliaryLane, *, beside_ego: bool) -> None:
    """Who uses the auxiliary lane merges or exits, from or to the side of the kerb.

    Args:
        draft: the scenario in the making; positions are settled.
        ego: the vehicle under test.
        auxiliary: the lane that the road has.
        beside_ego: it lies beside the ego's lane, as far as that is said.
    """
    kerb = _SIDES[draft.kerb]
    centre = Approach.LEFT if kerb is Approach.RIGHT else Approach.RIGHT
    leaves = auxiliary is AuxiliaryLane.OFF_RAMP
    for entity in draft.entities:
        basis = entity.exits if leaves else entity.by_ramp
        left_out = None if leaves else entity.exits
        draft.note_at(left_out, ONE_RAMP)
        if basis is None or not entity.moving_vehicle:
            continue
        entity.maneuvers = {Maneuver.EXIT if leaves else Maneuver.MERGE}
        entity.maneuver_basis = basis
        if leaves:
            continue
        entity.start_lane = None
        if not entity.ego and ego.by_ramp is None:
            entity.approaches = {Approach.ADJACENT, kerb} if beside_ego else set()
            entity.approach_basis = entity.approach_basis or basis
    if ego.by_ramp is None or leaves:
        return
    for entity in draft.entities:
        # All others are on the road that the ego joins, which lies to the other side.
        beside = entity.beside is not None and entity.beside[0] == kerb.value
        # "In front of a truck" is where it gets to: until then the truck drives beside the ramp.
        beside = beside or entity.approaches in ({Approach.AHEAD}, {Approach.BEHIND})
        if entity.by_ramp is None and beside:
            entity.approaches, entity.beside = {Approach.ADJACENT, centre}, None
