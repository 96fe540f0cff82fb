"""Who is in the way, drives abreast, alongside at a turn, or sets off beside the road."""

from __future__ import annotations

from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.roadway import Strip
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, ParticipantKind
from scegen.understanding.building.viewpoint import unplaced_dangers
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Entity
from scegen.understanding.happenings import Happenings, Item

_IN_THE_WAY = frozenset({HazardKind.STOPPING, HazardKind.SLOW_DRIVING, HazardKind.HARD_BRAKING,
                         HazardKind.OBSTACLE})  # fmt: skip
_OVER_THERE = frozenset({Maneuver.U_TURN, Maneuver.OVERTAKE, Maneuver.LEFT, Maneuver.RIGHT})
"""Ways on which one gets into the lane of those who come the other way."""


def in_the_way(draft: Draft, ego: Entity) -> None:
    """On a straight road, who endangers the ego by going slowly or stopping is ahead of it."""
    placed = [e for p in draft.placements for e in (p.entity, p.reference)]
    for entity, basis in unplaced_dangers(draft, ego, _IN_THE_WAY):
        if entity not in placed and entity.heading is None and entity.is_vehicle:
            reason = "on a straight road, who is in the way is ahead"
            entity.comes_from({Approach.AHEAD}, basis.because(reason))


def at_the_edge(draft: Draft, happenings: Happenings) -> None:
    """Who stands or walks at the edge of the road, and concerns nobody, is beside the lanes."""
    told: list[Entity | Item | None] = [*draft.causing(), *draft.suffering()]
    told += [e for s in happenings.spacings for e in (s.entity, s.reference)]
    ending = happenings.ending
    told += ending.between if ending is not None and ending.kind is not OutcomeKind.AVOIDED else []
    for entity in draft.entities:
        stays = bool(entity.maneuvers) and entity.maneuvers <= {Maneuver.STAY, Maneuver.STRAIGHT}
        words = entity.told.get("roadside")
        if stays and words is not None and not entity.is_vehicle and entity not in told:
            entity.strip = entity.strip or (Strip.PAVEMENT, words)


def in_one_lane(draft: Draft, happenings: Happenings) -> None:
    """On a straight road, two who collide head-on: the one that comes the other way strays."""
    ending = happenings.ending
    pair = ending.between if ending is not None and ending.kind is OutcomeKind.COLLISION else []
    told = {*draft.causing(), *draft.suffering()}
    for entity in pair if told.isdisjoint(pair) else []:
        oncoming = entity.approaches == {Approach.OPPOSITE} and entity.moving_vehicle
        to = [e for e in pair if e.ego and not e.maneuvers & _OVER_THERE]
        if oncoming and to and entity.stands is None:
            basis = entity.approach_basis or entity.basis
            basis = basis.because("two who collide head-on are in one lane")
            draft.hazard(HazardKind.ONCOMING_LANE, basis, [entity], to)


def from_the_strip(draft: Draft, ego: Entity) -> None:
    """On a straight road, who was parked and sets off is parked at first and pulls out."""
    for entity in draft.entities:
        if entity is ego or entity.was_parked is None or not entity.is_vehicle:
            continue
        entity.parked, entity.parked_basis = True, entity.was_parked
        entity.maneuvers -= {Maneuver.STAY, Maneuver.CROSS}
        if not entity.maneuvers:
            entity.maneuver_basis = entity.was_parked.because("it pulls out and drives on")
            entity.maneuvers = {Maneuver.STRAIGHT}


def abreast(draft: Draft, ego: Entity) -> None:
    """On a straight road, a vehicle on the left is not one that comes out of a road there."""
    along = draft.implied.keys().isdisjoint({"access", "from_kerb"})
    for entity in draft.entities if along else []:
        seen = entity.approaches
        alongside = entity.moving_vehicle and Maneuver.CROSS not in entity.maneuvers
        sided = len(seen) == 1 and seen <= {Approach.LEFT, Approach.RIGHT}
        if entity is ego or not sided or not alongside or entity.pulls_out:
            continue
        basis = entity.approach_basis or entity.basis
        if entity.kind is ParticipantKind.BICYCLE and off_the_road(entity, draft):
            if from_a_side(entity, draft) and not (entity.maneuvers or entity.strip):
                entity.maneuvers, entity.maneuver_basis = {Maneuver.CROSS}, basis
                draft.hazard(HazardKind.CROSSING_CYCLIST, basis, [entity])
            continue
        basis = basis.because("on a straight road, who is at one's side drives in the next lane")
        entity.beside = entity.beside or (next(iter(seen)).value, basis)
        entity.comes_from({Approach.ADJACENT}, basis)


def both_change_lanes(draft: Draft, ego: Entity) -> None:
    """Who changes lanes as the ego does comes from another lane."""
    both = Maneuver.LANE_CHANGE in ego.maneuvers
    for entity in draft.entities if both else []:
        free = not entity.approaches and not draft.placements_of(entity)
        if entity is not ego and free and Maneuver.LANE_CHANGE in entity.maneuvers:
            basis = entity.maneuver_basis or entity.basis
            reason = "who changes lanes beside the ego comes from another lane"
            entity.comes_from({Approach.ADJACENT}, basis.because(reason))


_RIDERS = frozenset({ParticipantKind.BICYCLE, ParticipantKind.MOTORCYCLE})
_TURNS = {Approach.RIGHT: Maneuver.RIGHT, Approach.LEFT: Maneuver.LEFT}


def alongside(draft: Draft, ego: Entity) -> None:
    """A rider on the side to which the ego turns, and who goes on, is beside it.

    One who comes *from* that side comes out of the road there.
    """
    crossing = draft.causing(HazardKind.CROSSING_CYCLIST)
    for entity in draft.entities:
        basis = entity.approach_basis
        if entity is ego or entity.kind not in _RIDERS or basis is None or basis.i is None:
            continue
        seen = entity.approaches - {Approach.BEHIND}  # "from behind on its right"
        side = next(iter(seen)) if len(seen) == 1 else None
        turned_to = side is not None and side in _TURNS and ego.maneuvers == {_TURNS[side]}
        goes_on = entity.maneuvers <= {Maneuver.STRAIGHT} and entity not in crossing
        if turned_to and goes_on and not off_the_road(entity, draft):
            reason = f"beside the ego, on the {side}: it turns across its way"
            entity.comes_from({Approach.ADJACENT, *entity.approaches}, basis.because(reason))


def off_the_road(entity: Entity, draft: Draft) -> bool:
    """``from the right``, ``on the right front``: out of the road or off the pavement there."""
    return from_a_side(entity, draft) or "front" in _words_of_place(entity, draft)


def from_a_side(entity: Entity, draft: Draft) -> bool:
    """``from the right``; not ``1 m from the ego's right side``, ``from behind on the right``."""
    words = _words_of_place(entity, draft)
    return words[:1] == ["from"] and "'s" not in words and Approach.BEHIND not in entity.approaches


def _words_of_place(entity: Entity, draft: Draft) -> list[str]:
    basis = entity.approach_basis or entity.basis
    return [t.low for t in draft.tokens[basis.i : basis.j]] if basis.i is not None else []
