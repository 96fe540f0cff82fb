"""What lies beside the lanes: strips, and the lane of a ramp, as said or as somebody is there."""

from __future__ import annotations

from typing import TypeAlias

from scegen.scenario.roadway import (
    BESIDE_AN_AUXILIARY_LANE,
    NOT_BESIDE_A_SHOULDER,
    PLAIN_ROAD_STRIPS,
    AuxiliaryLane,
    Carriageway,
    Strip,
)
from scegen.scenario.vocabulary import Approach, JunctionKind, Maneuver
from scegen.understanding.building.in_lane import JOINING
from scegen.understanding.building.leftovers import ONE_RAMP
from scegen.understanding.building.writing import Proofs
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.road.lengthwise import Lengthwise
from scegen.understanding.semantics.lanes import INVERSE

AT_JUNCTIONS = "built only along a road without a junction; here the plain road is"
_INNER_SHOULDER = "no shoulder is built along the median; here it is on the outer one"
_NOBODY_DRIVES = "there is one, but only who stands from the start is put on it"
_BESIDE_A_SHOULDER = "built only where there is no hard shoulder; here it is left out"
_BESIDE_A_RAMP = "built only where no ramp joins or leaves; here it is left out"


def strips_beside(
    draft: Draft,
    along: Lengthwise,
    proofs: Proofs,
    kind: JunctionKind,
    carriageway: Carriageway,
    auxiliary: AuxiliaryLane | None,
) -> frozenset[Strip]:
    """The strips of the road; a motorway's hard shoulder only where it is one.

    Only a hard shoulder lies beside an auxiliary lane. Who is on a strip that is not built is taken
    off it.
    """
    found: set[Strip] = set()
    for strip, basis in along.strips.items():
        of_road = basis == along.carriageway_basis
        if strip in along.without:
            proofs.add("junction.strips", along.without[strip])
        elif kind is not JunctionKind.STRAIGHT:
            draft.note_at(None if of_road else basis, AT_JUNCTIONS)
        elif auxiliary is not None and strip not in BESIDE_AN_AUXILIARY_LANE:
            draft.note_at(None if of_road else basis, _BESIDE_A_RAMP)
        elif not of_road or carriageway is Carriageway.DIVIDED:
            told = (e.parked or e.was_parked or e.strip for e in draft.entities)
            if strip is Strip.HARD_SHOULDER and not of_road and not any(told):
                draft.note_at(basis, _NOBODY_DRIVES)
            proofs.add("junction.strips", basis)
            found.add(strip)
    if auxiliary is None:
        found |= _stops(draft, proofs, kind)
    _where_somebody_is(draft, proofs, kind, found, ramp=auxiliary is not None)
    return frozenset(found)


def _stops(draft: Draft, proofs: Proofs, kind: JunctionKind) -> set[Strip]:
    """Who waits at a bus stop on foot does so behind it, on the pavement."""
    found: set[Strip] = set()
    for entity in draft.entities:
        strip, basis = entity.strip or (None, None)
        if strip is Strip.BUS_STOP and basis is not None and not entity.is_vehicle:
            entity.strip = Strip.PAVEMENT, basis
            if kind is JunctionKind.STRAIGHT:
                proofs.add("junction.strips", basis)
                found.add(strip)
    return found


def _where_somebody_is(
    draft: Draft, proofs: Proofs, kind: JunctionKind, found: set[Strip], *, ramp: bool
) -> None:
    """Adds the strips on which somebody is at first; who crosses starts behind them all."""
    kerb, sides = Approach(draft.kerb), {Approach.LEFT, Approach.RIGHT}
    for entity in draft.entities:
        strip, basis = entity.strip or (None, None)
        if strip is None or basis is None or Maneuver.CROSS in entity.maneuvers:
            entity.strip = None
            continue
        plain = kind is JunctionKind.STRAIGHT
        built = plain or (entity.parked and strip not in PLAIN_ROAD_STRIPS)
        beside = Strip.HARD_SHOULDER in found and strip in NOT_BESIDE_A_SHOULDER
        if strip is Strip.HARD_SHOULDER and entity.approaches & sides == sides - {kerb}:
            draft.note_at(basis, _INNER_SHOULDER)
            entity.approaches = {kerb}
        if ramp and strip not in BESIDE_AN_AUXILIARY_LANE:
            entity.strip = None
            draft.note_at(basis, _BESIDE_A_RAMP)
        elif built and not beside:
            proofs.add("junction.strips", basis)
            found.add(strip)
        elif strip not in found:
            entity.strip = None
            draft.note_at(basis, _BESIDE_A_SHOULDER if beside else AT_JUNCTIONS)


Used: TypeAlias = tuple[AuxiliaryLane, Basis] | None
"""The auxiliary lane that somebody uses, with the words for that."""


def auxiliary_lane(draft: Draft, *, drops: bool) -> Used:
    """The auxiliary lane that somebody uses, with the words for it; of two, who joins counts.

    It ``drops`` where the text names a lane that ends, and no ramp.
    """
    driven = [e for e in draft.entities if e.moving_vehicle]
    for words in (e.by_ramp for e in driven if e.by_ramp is not None):
        return AuxiliaryLane.LANE_DROP if drops else AuxiliaryLane.ON_RAMP, words
    exits = (basis for e in driven if (basis := e.told.get("exits")) is not None)
    return next(((AuxiliaryLane.OFF_RAMP, basis) for basis in exits), None)


def settle_ramp(
    draft: Draft, ego: Entity, auxiliary: AuxiliaryLane, along: Lengthwise, *, beside_ego: bool
) -> None:
    """Who uses the auxiliary lane merges or exits, from or to the side of the kerb."""
    kerb = Approach(draft.kerb)
    leaves = auxiliary is AuxiliaryLane.OFF_RAMP
    for entity in draft.entities:
        exits = entity.told.get("exits")
        basis = exits if leaves else entity.by_ramp
        draft.note_at(None if leaves else exits, ONE_RAMP)
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
