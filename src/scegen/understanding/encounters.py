"""Dangers from those who cross, hide or stand in the way."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, Maneuver, ParticipantKind
from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Prep, Thing
from scegen.understanding.context import Context, Scene
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.walking import keep_along

_HIDING = frozenset({"behind", "between"})
_CARRIAGEWAY = frozenset({"road", "crosswalk", "highway"})
_WAY = frozenset({"crosswalk", "road", "lane", "path", "highway"})
_OPAQUE_PLACES = frozenset({"bus_stop", "feature", "parking"})
_NARROWING = frozenset({"limit", "restrict", "impair", "hinder"})
_SHELTERING = frozenset({"shield", "cover"})
_SPRINGING = frozenset({"cross", "appear"})
_COMING = frozenset({"move", "enter", "pull_out"})
_OVER = frozenset({"over", "across"})
_WAITING = frozenset({"wait", "locate", "walk", "move", "stop", "park", "appear"})


def cross(scene: Scene, context: Context) -> None:
    """Somebody on foot or on a bicycle crosses the way of vehicles."""
    basis = scene.sudden or scene.words
    if scene.walkers:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, basis, scene.walkers)
    cyclists = [e for e in scene.actors if e.kind is ParticipantKind.BICYCLE]
    if cyclists:
        context.draft.hazard(HazardKind.CROSSING_CYCLIST, basis, cyclists)


def onto_the_road(scene: Scene, context: Context) -> None:
    """Whoever is on foot and gets onto the road or into somebody's way crosses, by any verb."""
    onto = any(
        (p.value == "into" or context.tokens[p.word.i].low in _OVER)
        and isinstance(p.target, Place)
        and p.target.kind in _WAY
        for p in scene.event.pps
    )
    if onto and scene.walkers:
        for entity in scene.walkers:
            context.draft.maneuver(entity, {Maneuver.CROSS}, scene.words)
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, scene.words, scene.walkers)


def answered(scene: Scene, context: Context) -> None:
    """``brakes for a child``, ``yields to pedestrians``: somebody crosses."""
    for prep in scene.event.pps:
        if prep.value not in {"for", "to"} or not isinstance(prep.target, Mention):
            continue
        walkers = [e for e in prep.target.entities if not e.is_vehicle]
        if walkers:
            basis = Basis(scene.event.i, prep.target.j)
            context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, basis, walkers)


def struck(scene: Scene, context: Context) -> None:
    """``was hit on the crosswalk``: whoever is hit there on foot was crossing."""
    there = any(p.kind == "crosswalk" for p in scene.places())
    walkers = [e for e in scene.targets if not e.is_vehicle]
    if there and walkers:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, scene.words, walkers)


def walk(scene: Scene, context: Context) -> None:
    """Walking counts as crossing unless it keeps along the road or on the sidewalk."""
    if keep_along(scene, context):
        return
    if any(p.value == "into" and isinstance(p.target, Mention) for p in scene.event.pps):
        return  # "ran into me": contact
    basis = scene.words
    for entity in scene.walkers:
        context.draft.maneuver(entity, {Maneuver.CROSS}, basis)
    if scene.walkers:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, basis, scene.walkers)


def appear(scene: Scene, context: Context) -> None:
    """Coming into sight: people step into the way, vehicles come out of a side road."""
    walk(scene, context)
    hidden = any(
        p.value in _HIDING and (p.outer == "from" or context.tokens[p.word.i].low == "from")
        for p in scene.event.pps
    )
    if hidden:
        cyclists_cross(scene, context)
        return
    ride(scene, context)
    aside = any(p.kind in {"access", "parking"} for p in scene.places())
    to = [e for p in scene.event.pps if isinstance(p.target, Mention) for e in p.target.entities]
    others = [e for e in scene.drivers if not e.ego and e.kind is not ParticipantKind.BICYCLE]
    if aside and others and (scene.sudden is not None or to):
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, scene.words, others, to)


def ride(scene: Scene, context: Context) -> None:
    """``a cyclist rides onto the road`` comes from beside it."""
    onto = any(
        p.value == "into" and isinstance(p.target, Place) and p.target.kind in _CARRIAGEWAY
        for p in scene.event.pps
    )
    aside = any(p.kind in {"sidewalk", "access", "parking"} for p in scene.places())
    direct = scene.event.object if scene.event.name == "enter" else None
    onto = onto or (isinstance(direct, Place) and direct.kind in _CARRIAGEWAY)
    springs = scene.event.name == "appear" or any(p.kind == "path" for p in scene.places())
    onto = onto or (aside and springs)
    onto = onto or _across_the_path(scene, context)
    away = {"off", "from"}
    onto = onto or any(
        context.tokens[p.word.i].low in away
        and isinstance(p.target, Place)
        and p.target.kind == "sidewalk"
        for p in scene.event.pps
    )
    if onto and not any(t.value in {"left", "right"} for t in scene.event.dirs):
        cyclists_cross(scene, context)


def _across_the_path(scene: Scene, context: Context) -> bool:
    """``rides straight across the ego's path``: whose path it is has to look out."""
    event = scene.event
    words = {context.tokens[m.j - 1].low for m in event.dirs} | {
        context.tokens[p.word.i].low for p in event.pps
    }
    paths = [p for p in scene.places() if p.kind == "path"]
    owned = any(p.owner is not None or any(m.cat == "possessive" for m in p.mods) for p in paths)
    return owned and "across" in words


def cyclists_cross(scene: Scene, context: Context) -> None:
    """Somebody on a bicycle gets onto the road, or over it.

    Args:
        scene: what happens.
        context: the scenario in the making.
    """
    cyclists = [e for e in scene.actors if e.kind is ParticipantKind.BICYCLE and not e.ego]
    for entity in cyclists:
        context.draft.maneuver(entity, {Maneuver.CROSS}, scene.words)
    if cyclists:
        basis = scene.sudden or scene.words
        context.draft.hazard(HazardKind.CROSSING_CYCLIST, basis, cyclists)


def block(scene: Scene, context: Context) -> None:
    """Standing in the way, or in the line of sight."""
    if isinstance(scene.event.object, Thing) and scene.event.object.kind == "view":
        occlude(scene, context)
        return
    if scene.event.nominal and not scene.targets and not scene.places():
        return  # "in the middle of the block"
    screened = [e for e in scene.targets if not e.is_vehicle or context.is_cyclist(e)]
    if scene.event.passive and screened:
        context.draft.hazard(HazardKind.OCCLUSION, scene.words, scene.actors)
        return  # "a child obstructed by a van"
    prevents = any(c.link == "ing" for c in scene.event.children)
    if prevents and not scene.places():
        return
    parked = [e for e in scene.actors if e.parked]
    if parked:
        context.draft.hazard(HazardKind.OBSTACLE, scene.words, parked)
    moving = [e for e in scene.actors if not e.parked]
    if moving:
        context.draft.hazard(HazardKind.STOPPING, scene.words, moving)


def occlude(scene: Scene, context: Context) -> None:
    """``hides the pedestrian``, ``is hidden behind a truck``, ``blocks the view``."""
    seen = scene.event.object
    narrow = context.tokens[scene.event.i].forms[-1][0] in _NARROWING
    if narrow and not (isinstance(seen, Thing) and seen.kind == "view"):
        return  # "limits the space"
    walkers = [e for e in scene.actors if not e.is_vehicle]
    by = [e for e in scene.actors if e.is_vehicle and not e.ego]
    by += [e for e in _behind(scene.event) if e not in by]
    hidden = bool(scene.targets) and not scene.actors  # "a hedge hiding two cyclists"
    hidden = hidden or _screened_by_a_thing(scene, context)
    if walkers or by or hidden or isinstance(scene.event.object, Thing):
        context.draft.hazard(HazardKind.OCCLUSION, scene.words, by)


def _screened_by_a_thing(scene: Scene, context: Context) -> bool:
    """``whose left side is screened by a wall``: whatever it is, it is out of sight."""
    sheltered = context.tokens[scene.event.i].forms[-1][0] in _SHELTERING
    by = [p.target for p in scene.event.pps if p.value in {"by", "behind"}]
    things = any(isinstance(t, Thing) and t.kind == "object" for t in by)
    return scene.event.passive and things and not sheltered


def _behind(event: Event) -> list[Entity]:
    """Who is named after "behind", "from behind", "by"."""
    targets = [
        p.target
        for p in event.pps
        if (p.word.cat == "locus" and p.value in {"behind", "between"}) or p.value in {"by", "due"}
    ]
    return [e for t in targets if isinstance(t, Mention) for e in t.entities]


def from_behind(scene: Scene, context: Context) -> None:
    """``emerges from behind a parked van``: until then it was out of sight."""
    for prep in scene.event.pps:
        unknown = prep.target is None and prep.outer == "from" and scene.event.name in _SPRINGING
        people = any(not e.is_vehicle or context.is_cyclist(e) for e in scene.actors)
        if not _hides(prep) and not (unknown and people):
            continue
        out = prep.outer == "from" or context.tokens[prep.word.i].low == "from"
        sprung = out or scene.event.name == "appear"
        sprung = sprung or (prep.value == "between" and bool(scene.walkers))
        sprung = sprung or (isinstance(prep.target, Thing) and scene.event.name == "cross")
        if sprung:
            basis, by = _screen(prep, scene.actors)
            context.draft.hazard(HazardKind.OCCLUSION, basis, by)
            if scene.event.name in _COMING:
                cyclists_cross(scene, context)
        elif scene.event.name in _WAITING:
            wait_behind(prep, scene.actors, context)


def wait_behind(prep: Prep, entities: list[Entity], context: Context) -> None:
    """``waits behind a kiosk``: out of sight if they come out later.

    Args:
        prep: the phrase that says behind what.
        entities: who is there.
        context: the scenario in the making.
    """
    if not _hides(prep):
        return
    basis, by = _screen(prep, entities)
    for entity in entities:
        if not entity.is_vehicle or (context.is_cyclist(entity) and not entity.ego):
            context.draft.screened.append((entity, basis, by))


def come_out(context: Context) -> None:
    """Who waited out of sight and crosses after all was hidden."""
    backing = [e for d in context.draft.dangers if d.kind is HazardKind.REVERSING for e in d.by]
    for entity, basis, by in context.draft.screened:
        seen = bool(by) and all(e in backing for e in by)  # "walks behind a reversing van"
        if Maneuver.CROSS in entity.maneuvers and not seen:
            context.draft.hazard(HazardKind.OCCLUSION, basis, by)


def _hides(prep: Prep) -> bool:
    """Behind something that one cannot see through."""
    if prep.word.cat != "locus" or prep.value not in _HIDING:
        return False
    target: NounPhrase | Event | None = prep.target
    if isinstance(target, Place):
        return target.kind in _OPAQUE_PLACES
    if isinstance(target, Mention):
        return not any(e.ego or not e.is_vehicle for e in target.entities)
    return isinstance(target, Thing)


def _screen(prep: Prep, actors: list[Entity]) -> tuple[Basis, list[Entity]]:
    target = prep.target
    by = list(target.entities) if isinstance(target, Mention) else []
    end = target.j if target is not None else prep.word.j
    return Basis(prep.word.i, end), [e for e in by if e not in actors]


def cause(scene: Scene, context: Context) -> None:
    """A parked vehicle that makes others react stands in their way."""
    parked = [e for e in scene.actors if e.parked]
    if parked:
        context.draft.hazard(HazardKind.OBSTACLE, scene.words, parked)


def door(scene: Scene, context: Context) -> None:
    """An opened door stands in the way."""
    basis = scene.words
    for entity in scene.drivers:
        if not entity.ego and entity.moves is None and not entity.maneuvers:
            entity.parked, entity.parked_basis = True, basis
    context.draft.hazard(HazardKind.OBSTACLE, basis, scene.actors)
    context.draft.note(scene.event.i, scene.event.j, "doors are not modelled; an obstacle is")
