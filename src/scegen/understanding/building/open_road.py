"""What holds on a straight road only: who is in the way, drives abreast, or sets off beside it."""

from __future__ import annotations

from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.roadway import Strip
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, ParticipantKind
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.happenings import Happenings, Item

_IN_THE_WAY = frozenset({HazardKind.STOPPING, HazardKind.SLOW_DRIVING, HazardKind.HARD_BRAKING,
                         HazardKind.OBSTACLE})  # fmt: skip


def in_the_way(draft: Draft, ego: Entity) -> None:
    """On a straight road, who endangers the ego by going slowly or stopping is ahead of it."""
    placed = {p.entity.index for p in draft.placements} | {
        p.reference.index for p in draft.placements if p.reference is not None
    }
    for danger in draft.dangers:
        if danger.kind not in _IN_THE_WAY or (danger.to and ego not in danger.to):
            continue
        for entity in danger.by:
            free = entity.index not in placed and not entity.approaches and entity.heading is None
            if free and entity is not ego and entity.is_vehicle:
                entity.approaches = {Approach.AHEAD}
                reason = "on a straight road, who is in the way is ahead"
                entity.approach_basis = Basis(danger.basis.i, danger.basis.j, reason)


def at_the_edge(draft: Draft, happenings: Happenings) -> None:
    """Who stands or walks at the edge of the road, and concerns nobody, is beside the lanes."""
    told: list[Entity | Item | None] = [e for d in draft.dangers for e in (*d.by, *d.to)]
    told += [e for s in happenings.spacings for e in (s.entity, s.reference)]
    told += happenings.ending.between if happenings.ending is not None else []
    for entity in draft.entities:
        stays = bool(entity.maneuvers) and entity.maneuvers <= {Maneuver.STAY, Maneuver.STRAIGHT}
        if stays and entity.roadside is not None and not entity.is_vehicle and entity not in told:
            entity.strip = entity.strip or (Strip.PAVEMENT, entity.roadside)


def in_one_lane(draft: Draft, happenings: Happenings) -> None:
    """On a straight road, two who collide head-on: the one that comes the other way strays."""
    ending = happenings.ending
    pair = ending.between if ending is not None and ending.kind is OutcomeKind.COLLISION else []
    told = [e for d in draft.dangers for e in (*d.by, *d.to)]
    for entity in pair if not any(e in told for e in pair) else []:
        oncoming = entity.approaches == {Approach.OPPOSITE} and entity.moving_vehicle
        to = [e for e in pair if e.ego]
        if oncoming and to and entity.stands is None:
            basis = entity.approach_basis or entity.basis
            reason = "two who collide head-on are in one lane"
            draft.hazard(HazardKind.ONCOMING_LANE, Basis(basis.i, basis.j, reason), [entity], to)


def from_the_strip(draft: Draft, ego: Entity) -> None:
    """On a straight road, who was parked and sets off is parked at first and pulls out."""
    for entity in draft.entities:
        if entity is ego or entity.was_parked is None or not entity.is_vehicle:
            continue
        entity.parked, entity.parked_basis = True, entity.was_parked
        entity.maneuvers -= {Maneuver.STAY, Maneuver.CROSS}
        if not entity.maneuvers:
            basis = entity.was_parked
            entity.maneuver_basis = Basis(basis.i, basis.j, "it pulls out and drives on")
            entity.maneuvers = {Maneuver.STRAIGHT}


def abreast(draft: Draft, ego: Entity) -> None:
    """On a straight road, a vehicle on the left is not one that comes out of a road there."""
    along = draft.access is None and not draft.from_kerb
    for entity in draft.entities if along else []:
        side = entity.approaches and entity.approaches <= {Approach.LEFT, Approach.RIGHT}
        alongside = entity.moving_vehicle and Maneuver.CROSS not in entity.maneuvers
        if entity is ego or not side or len(entity.approaches) > 1 or not alongside:
            continue
        if entity.pulls_out:
            continue
        basis = entity.approach_basis or entity.basis
        rides = entity.kind is ParticipantKind.BICYCLE and basis.i is not None
        words = {t.low for t in draft.tokens[basis.i or 0 : basis.j]}
        if rides and "front" in words:
            continue  # "a cyclist on the right front": beside the lane, not in the next one
        if rides and draft.tokens[basis.i or 0].low == "from":
            continue  # a cyclist comes from the right: off the pavement
        reason = "on a straight road, who is at one's side drives in the next lane"
        named = next(iter(entity.approaches)).value
        entity.beside = entity.beside or (named, Basis(basis.i, basis.j, reason))
        entity.approaches = {Approach.ADJACENT}
        entity.approach_basis = Basis(basis.i, basis.j, reason)


def both_change_lanes(draft: Draft, ego: Entity) -> None:
    """Who changes lanes as the ego does comes from another lane."""
    placed = {p.entity.index for p in draft.placements}
    both = Maneuver.LANE_CHANGE in ego.maneuvers
    for entity in draft.entities:
        if entity is ego or entity.approaches or entity.index in placed or not both:
            continue
        if Maneuver.LANE_CHANGE in entity.maneuvers:
            entity.approaches = {Approach.ADJACENT}
            basis = entity.maneuver_basis or entity.basis
            reason = "who changes lanes beside the ego comes from another lane"
            entity.approach_basis = Basis(basis.i, basis.j, reason)
