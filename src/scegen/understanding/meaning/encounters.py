"""Dangers from those who cross."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, Maneuver, ParticipantKind
from scegen.understanding.chunks import Event, Mention, Place
from scegen.understanding.draft import Basis
from scegen.understanding.meaning.context import Context, Scene
from scegen.understanding.meaning.standing import in_the_road
from scegen.understanding.meaning.walking import keep_along

_HIDING = frozenset({"behind", "between"})
_CARRIAGEWAY = frozenset({"road", "crosswalk", "highway"})
_WAY = frozenset({"crosswalk", "road", "lane", "path", "highway"})
_OVER = frozenset({"over", "across"})
_ALONG_A_CROSSWALK = frozenset({"through", "on", "along", "via", "in", "over", "across"})
_UNDERWAY = frozenset({"move", "speed", "accelerate", "crawl", "dash", "pass", "leave"})
_CROSSED = _WAY | {"exit", "leg", "junction"}
_ALONG_IT = frozenset({"turn", "sharp_turn", "u_turn", "hide", "block", "park", "locate", "look",
                       "inert", "see", "encounter", "lane_change", "wait"})  # fmt: skip
_TAKING = frozenset({"use", "block", "enter"})
_MERGED = frozenset({HazardKind.CUT_IN, HazardKind.MERGING_CONFLICT, HazardKind.ONCOMING_LANE})
_REMAINING = frozenset({"stop", "wait", "locate", "inert", "unknown", "slow"})


def cross(scene: Scene, context: Context) -> None:
    """Somebody on foot or on a bicycle crosses the way of vehicles."""
    basis = scene.sudden or scene.words
    if scene.walkers:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, basis, scene.walkers)
    cyclists = [e for e in scene.actors if e.kind is ParticipantKind.BICYCLE]
    if cyclists:
        context.draft.hazard(HazardKind.CROSSING_CYCLIST, basis, cyclists)


def after_a_thing(scene: Scene, context: Context) -> None:
    """``a ball rolls onto the road, followed by a boy``: the boy crosses.

    Args:
        scene: what happens.
        context: the scenario in the making.
    """
    if scene.event.name != "follow" or not scene.event.passive or scene.targets:
        return
    for entity in scene.walkers:
        context.draft.maneuver(entity, {Maneuver.CROSS}, scene.words)
    if scene.walkers:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, scene.words, scene.walkers)


def onto_the_road(scene: Scene, context: Context) -> None:
    """Whoever is on foot and gets onto the road or into somebody's way crosses, by any verb."""
    if in_the_road(scene, context):
        return
    onto = any(
        (p.value == "into" or context.tokens[p.word.i].low in _OVER)
        and isinstance(p.target, Place)
        and p.target.kind in _WAY
        for p in scene.event.pps
    )
    onto = onto or _stays_on_the_road(scene, context)
    if _across_by_any_verb(scene, context):
        cyclists_cross(scene, context)
        onto = True
    if onto and scene.walkers:
        for entity in scene.walkers:
            context.draft.maneuver(entity, {Maneuver.CROSS}, scene.words)
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, scene.words, scene.walkers)


def _to_the_other_side(goal: object) -> bool:
    """``zips over to the other side``, ``runs to the opposite pavement``."""
    if not isinstance(goal, Place) or goal.kind not in {"side", "sidewalk"}:
        return False
    return "opposite" in goal.dirs or any(m.value == "other" for m in goal.mods)


def _across_by_any_verb(scene: Scene, context: Context) -> bool:
    """``pedals straight across the road``, ``files across``: over it, whatever the verb."""
    event = scene.event
    if event.name in _ALONG_IT or event.nominal:
        return False
    own = {t.low for t in context.tokens[event.i : event.j]}
    own |= {context.tokens[m.j - 1].low for m in event.mods if m.cat in {"dir", "manner"}}
    direct = event.object
    if own & _OVER and isinstance(direct, Place) and direct.kind in _CROSSED:
        return True
    if any(_to_the_other_side(p.target) for p in event.pps if p.value == "to"):
        return True
    if own & _OVER and direct is None and scene.walkers:
        return not any(m.value == "halfway" for m in event.mods)
    return _on_a_crosswalk(event, context) or any(
        context.tokens[p.word.i].low in _OVER
        and isinstance(p.target, Place)
        and p.target.kind in _CROSSED
        for p in event.pps
    )


def _on_a_crosswalk(event: Event, context: Context) -> bool:
    """``rides through the crosswalk``: whoever is underway on one crosses."""
    return event.name in _UNDERWAY and any(
        context.tokens[p.word.i].low in _ALONG_A_CROSSWALK
        and isinstance(p.target, Place)
        and p.target.kind == "crosswalk"
        for p in event.pps
    )


def _stays_on_the_road(scene: Scene, context: Context) -> bool:
    """``stops on the crosswalk``, ``is lying in the road``: got there by crossing."""
    return (
        not scene.event.nominal
        and any(
            context.tokens[p.word.i].low in {"on", "in"}
            and isinstance(p.target, Place)
            and p.target.kind in _WAY - {"path"}
            for p in scene.event.pps
            if scene.event.name in _REMAINING
        )
    ) or (scene.event.name in _TAKING and scene.event.object in scene.places())


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
    _struck_aside(scene, context)
    there = any(p.kind == "crosswalk" for p in scene.places())
    walkers = [e for e in scene.targets if not e.is_vehicle]
    if there and walkers:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, scene.words, walkers)


def _struck_aside(scene: Scene, context: Context) -> None:
    """``changed lanes and struck its side``: no room was left for the change of lane."""
    hit = scene.event.object
    owner = hit.owner if isinstance(hit, Place) else None
    whom = [*scene.targets, *(owner.entities if owner is not None else [])]
    changed = [e for e in scene.drivers if e.maneuvers == {Maneuver.LANE_CHANGE} and not e.ego]
    cut = {e.index for d in context.draft.dangers if d.kind in _MERGED for e in d.by}
    moved = [e for e in whom if e.moving_vehicle]
    if changed and moved and not context.junction.crossing and not cut & {e.index for e in changed}:
        context.draft.hazard(HazardKind.CUT_IN, scene.words, changed, moved)


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
    sided = any(p.value == "from" and isinstance(p.target, Place) for p in scene.event.pps)
    onto = onto or (sided and _into_a_path(scene))
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


def _into_a_path(scene: Scene) -> bool:
    """``rides from the right into the path of the ego``."""
    return any(
        p.value == "into" and isinstance(p.target, Place) and p.target.kind == "path"
        for p in scene.event.pps
    )


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


def door(scene: Scene, context: Context) -> None:
    """An opened door stands in the way."""
    basis = scene.words
    people = any(h.value == "pedestrian" for m in scene.event.subject for h in m.heads)
    for entity in scene.drivers if people else []:  # "a woman opens her door": she has parked
        if not entity.ego and entity.moves is None and not entity.maneuvers:
            entity.parked, entity.parked_basis = True, basis
    context.draft.hazard(HazardKind.OBSTACLE, basis, scene.actors)
    context.draft.note(scene.event.i, scene.event.j, "doors are not modelled; an obstacle is")
