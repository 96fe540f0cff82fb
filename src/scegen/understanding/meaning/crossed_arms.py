"""Which road of a junction somebody on foot crosses, by where another comes from or goes to."""

from __future__ import annotations

from collections.abc import Mapping

from scegen.scenario.vocabulary import Approach, CrossedArm, HazardKind, Maneuver
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Prep
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.phrases.which_road import AGAINST, ALONG
from scegen.understanding.semantics.context import Clause, Context

_TURNS = frozenset({"turn", "sharp_turn", "enter", "move", "merge"})
_OVER_THE_ROAD = frozenset({HazardKind.CROSSING_PEDESTRIAN, HazardKind.CROSSING_CYCLIST})
_OVER = frozenset({"across", "over"})
_INTO = {"into": CrossedArm.EXIT, "from": CrossedArm.ENTRY}
_SIDES = {Maneuver.LEFT: Approach.LEFT, Maneuver.RIGHT: Approach.RIGHT}
_OTHER = {Approach.LEFT: Approach.RIGHT, Approach.RIGHT: Approach.LEFT}


def note_arms(chunks: list[Chunk], clauses: list[Clause], context: Context) -> None:
    """``crosses the road that the ego turns into``, ``walks over the exit``."""
    used = _used_by_drivers(clauses)
    for clause in clauses:
        whom = clause.walkers + [e for e in clause.actors if context.is_cyclist(e) and not e.ego]
        for prep, place in _crossed(clause.event):
            if clause.walkers or _goes_over(clause.event, prep, context):
                _note(whom, prep, place, used, context)
        term = clause.event.how(ALONG, AGAINST)
        if term is None:
            continue
        for entity in whom:
            entity.course = entity.course or (term.value == ALONG, Basis(term.i, term.j))
    for mention in chunks:
        if not isinstance(mention, Mention):
            continue
        walkers = [e for e in mention.entities if not e.is_vehicle]
        for prep in mention.pps:
            if isinstance(prep.target, Place) and prep.target.arm is not None:
                _note(walkers, prep, prep.target, {}, context)


def _goes_over(event: Event, prep: Prep | None, context: Context) -> bool:
    """Unlike ``a cyclist takes the first exit``."""
    if prep is None:
        return event.name == "cross"
    return context.tokens[prep.word.i].low in _OVER


def _note(
    whom: list[Entity],
    prep: Prep | None,
    place: Place,
    used: Mapping[str, CrossedArm],
    context: Context,
) -> None:
    arm = place.arm or used.get(place.kind)
    arm = CrossedArm.EXIT if arm is None and place.kind == "exit" else arm
    if arm is None:
        return
    basis = Basis(prep.word.i if prep is not None else place.i, place.j)
    for entity in whom:
        entity.crosses = entity.crosses or (arm, basis)
        _meets(entity, place, context)
        if context.is_cyclist(entity):
            context.draft.maneuver(entity, {Maneuver.CROSS}, basis)


def _meets(entity: Entity, road: Place, context: Context) -> None:
    """``the road that the truck turns into``: who crosses it meets the truck."""
    kinds = [h.value for h in road.user.heads] if road.user is not None else []
    ego = road.user is not None and road.user.is_ego
    users = [e for e in context.draft.entities if e.kind.value in kinds and e.moving_vehicle]
    for danger in context.draft.dangers if len(users) == 1 and not ego else []:
        if danger.kind in _OVER_THE_ROAD and danger.by == [entity] and not danger.to:
            danger.to = users


def _crossed(event: Event) -> list[tuple[Prep | None, Place]]:
    """The places that somebody goes over."""
    found: list[tuple[Prep | None, Place]] = []
    if isinstance(event.object, Place):
        found.append((None, event.object))
    found += [(p, p.target) for p in event.pps if p.value == "in" and isinstance(p.target, Place)]
    return found


def _used_by_drivers(clauses: list[Clause]) -> dict[str, CrossedArm]:
    """``turns into a side road``: for who comes by "the side road" later on."""
    found: dict[str, CrossedArm] = {}
    for clause in clauses:
        if clause.event.name not in _TURNS or not clause.drivers:
            continue
        for prep in clause.event.pps:
            place = prep.target
            if isinstance(place, Place) and place.kind == "access" and prep.value in _INTO:
                found.setdefault(place.kind, _INTO[prep.value])
    return found


def settle_arms(draft: Draft, ego: Entity) -> None:
    """From which side they come who walk as the ego drove before it turned, or against it.

    That leads over the road into which it turns. What is said of the side itself comes first.
    """
    for entity in draft.entities:
        if entity.course is None or len(ego.maneuvers & set(_SIDES)) != 1:
            continue
        along, basis = entity.course
        if entity.crosses is None:
            reason = "across the ego's turn only this road is walked that way"
            entity.crosses = (CrossedArm.EXIT, Basis(basis.i, basis.j, reason))
        side = _SIDES[next(iter(ego.maneuvers & set(_SIDES)))]
        side = side if along else _OTHER[side]
        said = [p.approaches & set(_OTHER) for p in draft.placements if p.entity is entity]
        if entity.crosses[0] is CrossedArm.EXIT and all(side in sides for sides in said if sides):
            draft.place(entity, ego, {side}, basis)
