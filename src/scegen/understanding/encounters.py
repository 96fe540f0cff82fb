"""Dangers from those who cross, hide or stand in the way."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, Maneuver, ParticipantKind
from scegen.understanding.chunks import Event, Mention, NounPhrase, Thing
from scegen.understanding.context import Context, Scene
from scegen.understanding.draft import Basis, Entity


def cross(scene: Scene, context: Context) -> None:
    """Somebody on foot or on a bicycle crosses the way of vehicles."""
    basis = scene.sudden or scene.words
    if scene.walkers:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, basis, scene.walkers)
    cyclists = [e for e in scene.actors if e.kind is ParticipantKind.BICYCLE]
    if cyclists:
        context.draft.hazard(HazardKind.CROSSING_CYCLIST, basis, cyclists)


def walk(scene: Scene, context: Context) -> None:
    """Walking counts as crossing unless it stays on the sidewalk."""
    if any(p.kind == "sidewalk" for p in scene.places()):
        return
    basis = scene.words
    for entity in scene.walkers:
        context.draft.maneuver(entity, {Maneuver.CROSS}, basis)
    if scene.walkers:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, basis, scene.walkers)


def appear(scene: Scene, context: Context) -> None:
    """Coming into sight: pedestrians step into the way, others come from where they hid."""
    walk(scene, context)


def block(scene: Scene, context: Context) -> None:
    """Standing in the way, or in the line of sight."""
    if isinstance(scene.event.object, Thing) and scene.event.object.kind == "view":
        occlude(scene, context)
        return
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
    walkers = [e for e in scene.actors if not e.is_vehicle]
    by = [e for e in scene.actors if e.is_vehicle and not e.ego]
    by += [e for e in _behind(scene.event) if e not in by]
    if walkers or by or isinstance(scene.event.object, Thing):
        context.draft.hazard(HazardKind.OCCLUSION, scene.words, by)


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
        hidden = prep.word.cat == "locus" and prep.value in {"behind", "between"}
        sprung = prep.outer == "from" or scene.event.name == "appear"
        sprung = sprung or (prep.value == "between" and bool(scene.walkers))
        target: NounPhrase | Event | None = prep.target
        if not hidden or not sprung or target is None:
            continue
        by = list(target.entities) if isinstance(target, Mention) else []
        if isinstance(target, Mention | Thing) or by:
            basis = Basis(prep.word.i, target.j)
            by = [e for e in by if e not in scene.actors]
            context.draft.hazard(HazardKind.OCCLUSION, basis, by)


def cause(scene: Scene, context: Context) -> None:
    """A parked vehicle that makes others react stands in their way."""
    parked = [e for e in scene.actors if e.parked]
    if parked:
        context.draft.hazard(HazardKind.OBSTACLE, scene.words, parked)


def door(scene: Scene, context: Context) -> None:
    """An opened door stands in the way."""
    basis = scene.words
    context.draft.hazard(HazardKind.OBSTACLE, basis, scene.actors)
    context.draft.note(scene.event.i, scene.event.j, "doors are not modelled; an obstacle is")
