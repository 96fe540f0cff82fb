"""Who is on a strip beside the lanes: cycle lane, pavement, hard shoulder, bay."""

from __future__ import annotations

from collections.abc import Iterator

from scegen.scenario.roadway import BAYS, Strip
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, ParticipantKind
from scegen.understanding.chunks import Chunk, Mention, NounPhrase, Place, Prep
from scegen.understanding.draft import Basis, Danger, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context

_PASSING = frozenset({"overtake", "pass", "bypass", "undertake", "collide"})
"""With these verbs the place is that of the passing, or of the contact."""

_SETTING_OFF = frozenset({"pull_out", "leave", "unpark"})
_ARRIVING = frozenset({"stop", "brake", "hard_brake", "slow", "enter", "turn", "pull_over", "park"})


def on_strips(chunks: list[Chunk], clauses: list[Clause], context: Context) -> None:
    """What mentions and verbs say of it.

    Args:
        chunks: the chunks of the text, mentions resolved.
        clauses: what happens.
        context: the scenario in the making.
    """
    for chunk in chunks:
        if isinstance(chunk, Mention) and not chunk.negated:
            _put(context, chunk.pps, chunk.entities)
    for clause in clauses:
        event = clause.event
        if event.negated or event.name in _PASSING:
            continue
        own = [p for p in event.pps if p.on_mention is None or p.on_mention in event.subject]
        if event.name in _SETTING_OFF:
            _set_off(context, own, clause.actors)
        parked = event.name == "park" and any(e.pulls_out for e in clause.actors)
        if event.name in _ARRIVING and not (parked or any(map(_stands, clause.actors))):
            continue  # "pulls up at a stop": not there at first
        _put(context, own, clause.actors)
        if isinstance(event.object, Place) and _roadside(event.object, event.pps):
            for entity in clause.walkers:  # "runs along the right edge of the road"
                entity.roadside = entity.roadside or Basis(event.i, event.object.j)
        left = event.object if event.name == "leave" else None
        for place, basis in _strip_of(left):
            _leaves(context, clause.actors, place, basis)
    _behind_on_it(context)


def _behind_on_it(context: Context) -> None:
    """``a van is parked on the cycle lane; a cyclist swerves around it``: there, too."""
    for placed in context.draft.placements:
        ahead, behind = placed.entity, placed.reference
        if ahead.strip is None or behind is None or placed.approaches != {Approach.AHEAD}:
            continue
        strip, basis = ahead.strip
        rides = strip is Strip.CYCLE_LANE and behind.kind is ParticipantKind.BICYCLE
        if rides and behind.start_lane is None:
            _is_on(context, behind, strip, Basis(basis.i, basis.j, "it gets past who is there"))


def _put(context: Context, preps: list[Prep], whom: list[Entity]) -> None:
    for prep in preps:
        word = context.tokens[prep.word.i].low
        target = prep.target if isinstance(prep.target, Place) else None
        at = word in word_list("on_strips") and prep.outer is None
        if at and target is not None and _roadside(target, preps):
            for entity in whom:  # "waits at the kerb", "walks along the edge of the road"
                entity.roadside = entity.roadside or Basis(prep.word.i, target.j)
        for strip, basis in _strip_of(target):
            there = Basis(prep.word.i, basis.j)
            if at:
                for entity in whom:
                    _is_on(context, entity, strip, there)
                    if not entity.is_vehicle and target is not None:
                        sides = {Approach(d) for d in target.dirs if d in {"left", "right"}}
                        context.draft.place(entity, None, sides, there)
            elif prep.value == "from" or prep.outer is not None or _out_of(prep, context):
                _leaves(context, whom, strip, there)


def _roadside(place: Place, preps: list[Prep]) -> bool:
    """``the kerb``, ``the edge of the road``."""
    after = (p.target for p in preps if p.word.i == place.j)
    road = any(isinstance(p, Place) and p.kind in {"road", "highway"} for p in after)
    return place.kind == "sidewalk" or (place.kind == "side" and road)


def _stands(entity: Entity) -> bool:
    return entity.still or (not entity.is_vehicle and entity.maneuvers == {Maneuver.STAY})


def _set_off(context: Context, preps: list[Prep], whom: list[Entity]) -> None:
    """``pulls out of a parking space``: who does, stood there."""
    for prep in preps if not context.junction.crossing else []:
        target = prep.target if isinstance(prep.target, Place) else None
        for strip, _ in _strip_of(target) if _out_of(prep, context) else ():
            for entity in whom if strip in BAYS else ():
                entity.pulls_out = entity.pulls_out or (entity.is_vehicle and not entity.ego)
            _leaves(
                context, whom, strip, Basis(prep.word.i, prep.target.j if prep.target else None)
            )


def _out_of(prep: Prep, context: Context) -> bool:
    """``pulls out of a bus stop``."""
    words = [t.low for t in context.tokens[max(0, prep.word.i - 1) : prep.word.j]]
    return words == ["out", "of"]


def _strip_of(place: NounPhrase | None) -> Iterator[tuple[Strip, Basis]]:
    data = place.head.data if place is not None and place.head is not None else {}
    if place is not None and "stands_on" in data:
        yield Strip(data["stands_on"]), Basis(place.i, place.j)


def _leaves(context: Context, whom: list[Entity], strip: Strip, basis: Basis) -> None:
    """One who pulls out of a bay stood there."""
    for entity in whom:
        if entity.is_vehicle and entity.pulls_out and not entity.ego:
            _is_on(context, entity, strip, basis)


def _is_on(context: Context, entity: Entity, strip: Strip, basis: Basis) -> None:
    if entity.ego or entity.strip is not None:
        return
    entity.strip = strip, basis
    if not entity.is_vehicle:
        return
    if entity.pulls_out or (strip in BAYS and entity.sets_off >= 0):
        entity.was_parked = entity.was_parked or basis
    elif entity.still or strip in BAYS:
        entity.parked, entity.parked_basis = True, entity.parked_basis or entity.stands or basis
        entity.stands = None
        context.draft.dangers[:] = [
            d for d in context.draft.dangers if not _beside_the_lanes(d, entity)
        ]


def _beside_the_lanes(danger: Danger, entity: Entity) -> bool:
    """Whether a danger is none of one who stands beside the lanes: in the way, overtaken."""
    stops = danger.kind is HazardKind.STOPPING and danger.by == [entity]
    return stops or (danger.kind is HazardKind.OVERTAKING and danger.to == [entity])
