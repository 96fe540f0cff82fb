"""What participants do of whom the text names no maneuver."""

from __future__ import annotations

from scegen.scenario.functional import Junction
from scegen.scenario.vocabulary import (
    ANIMALS,
    ON_FOOT,
    Approach,
    HazardKind,
    JunctionKind,
    Maneuver,
)
from scegen.understanding.draft import Basis, Draft, Entity

_OVER_A_JUNCTION = frozenset({Maneuver.LEFT, Maneuver.RIGHT, Maneuver.STRAIGHT})
_TURNS = frozenset({Maneuver.LEFT, Maneuver.RIGHT, Maneuver.U_TURN})
_OUT_OF_THE_ACCESS = frozenset({HazardKind.FAILURE_TO_YIELD, HazardKind.REVERSING,
                                HazardKind.CROSSING_CYCLIST})  # fmt: skip


def maneuvers_of(entity: Entity, junction: Junction, draft: Draft) -> set[Maneuver]:
    """The maneuvers that the text says, or what follows from what it says besides.

    Args:
        entity: a participant; the basis of its maneuvers is set.
        junction: where it all happens.
        draft: the scenario in the making, positions settled.

    Returns:
        The maneuvers; empty where the text leaves them open.
    """
    if entity.stands is not None and not entity.ego and _stays(entity):
        entity.maneuver_basis = entity.stands
        return {Maneuver.STAY}
    if entity.maneuvers and (entity.was_parked is not None or not entity.parked):
        passes = any(d.kind is HazardKind.OVERTAKING and entity in d.by for d in draft.dangers)
        turns = entity.maneuvers & _TURNS
        return turns if passes and turns else entity.maneuvers  # "overtakes, then turns right"
    found = _followed(entity, junction, draft)
    if found is None:
        left = _ways_left(entity) if junction.kind is not JunctionKind.ROUNDABOUT else set()
        basis = entity.excluded_basis
        if left and basis is not None:
            entity.maneuver_basis = Basis(basis.i, basis.j, "the other ways are ruled out")
        return left
    maneuver, words, reason = found
    entity.maneuver_basis = Basis(words.i, words.j, reason)
    return {maneuver}


def _stays(entity: Entity) -> bool:
    """Whether one who stands at first is not said to go anywhere."""
    goes = entity.maneuvers - {Maneuver.STAY, Maneuver.STRAIGHT}
    return not goes and not entity.parked and entity.sets_off < 0


def _followed(
    entity: Entity, junction: Junction, draft: Draft
) -> tuple[Maneuver, Basis, str] | None:
    if entity.parked:
        return Maneuver.STAY, entity.basis, "a parked vehicle stays"
    runs = any(d.kind is HazardKind.CROSSING_ANIMAL and entity in d.by for d in draft.dangers)
    if entity.kind in ANIMALS and not runs:
        return Maneuver.STAY, entity.basis, "an animal of which no more is said stands there"
    if entity.kind in ON_FOOT:
        reason = "nothing else is said: somebody on foot crosses"
        return Maneuver.CROSS, entity.basis, reason
    if junction.kind is JunctionKind.STRAIGHT:
        reason = "on a straight road, or one without a junction, one drives straight on"
        return Maneuver.STRAIGHT, entity.moves or Basis(), reason
    if junction.kind is JunctionKind.ROUNDABOUT:
        return None
    crossed = _turned_across(entity, draft)
    if crossed is not None:
        return Maneuver.STRAIGHT, crossed, "its way is crossed: nothing says that it turns"
    priority = _has_the_way(entity, draft)
    if priority is not None:
        return Maneuver.STRAIGHT, priority, "it has the way: nothing says that it turns"
    underway = entity.moves or (entity.heading_basis if entity.bound else None)
    if entity.heading is not None and underway is not None:
        return Maneuver.STRAIGHT, underway, "it keeps its heading: nothing says that it turns"
    if entity.through is not None and (entity.ego or entity.claimed):
        reason = "it drives through: nothing says that it turns"
        return Maneuver.STRAIGHT, entity.through, reason
    oncoming = _oncoming(entity, draft)
    if oncoming is not None:
        return Maneuver.STRAIGHT, oncoming, "it comes on: nothing says that it turns"
    return _at_the_light(entity, draft)


def _at_the_light(entity: Entity, draft: Draft) -> tuple[Maneuver, Basis, str] | None:
    """``stands at a red light``: it stays there; who stops there goes on."""
    stays = entity.held is not None and entity.moves is None and entity.sets_off < 0
    stays = stays and not entity.pulls_out
    if stays and not any(token.low == "green" for token in draft.tokens):
        return Maneuver.STAY, entity.held or Basis(), "nothing says that it goes on"
    if entity.waits is not None:
        return Maneuver.STRAIGHT, entity.waits, "it waits for the light: nothing says that it turns"
    return None


def _has_the_way(entity: Entity, draft: Draft) -> Basis | None:
    """``pulls out of a driveway in front of a bus``: the bus keeps to its road."""
    if draft.access is None or not entity.moving_vehicle:
        return None
    for danger in draft.dangers:
        met = [e for e in draft.entities if e.moving_vehicle and e not in danger.by]
        alone = entity.ego or met == [entity]
        suffers = entity in danger.to or (not danger.to and alone)
        along = suffers and entity not in danger.by
        if danger.kind in _OUT_OF_THE_ACCESS and along:
            return danger.basis
    return None


def _turned_across(entity: Entity, draft: Draft) -> Basis | None:
    """``turns left across the path of the van``: the van goes straight on."""
    return next(
        (
            d.basis
            for d in draft.dangers
            if d.kind is HazardKind.UNPROTECTED_LEFT_TURN
            and (entity in d.to or (not d.to and entity.ego and "ego" in entity.named_by))
            and entity not in d.by
        ),
        None,
    )


def _oncoming(entity: Entity, draft: Draft) -> Basis | None:
    """``yields to oncoming traffic``: who is called oncoming keeps coming."""
    called = not entity.ego and "opposite" in entity.dirs
    return next(
        (
            p.basis
            for p in draft.placements
            if called and p.entity is entity and p.approaches == {Approach.OPPOSITE}
        ),
        None,
    )


def _ways_left(entity: Entity) -> set[Maneuver]:
    """The ways over a junction that are not ruled out; empty where nothing is said."""
    if not entity.excluded & _OVER_A_JUNCTION or not entity.is_vehicle:
        return set()
    return set(_OVER_A_JUNCTION - entity.excluded)
