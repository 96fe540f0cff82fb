"""Dangers from those who cross."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, Maneuver, ParticipantKind
from scegen.understanding.chunks import Event, Mention, Place
from scegen.understanding.draft import Basis
from scegen.understanding.meaning.standing import in_the_road
from scegen.understanding.meaning.walking import keep_along
from scegen.understanding.semantics.context import Clause, Context

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


def cross(clause: Clause, context: Context) -> None:
    """Somebody on foot or on a bicycle crosses the way of vehicles."""
    basis = clause.sudden or clause.words
    if clause.walkers:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, basis, clause.walkers)
    cyclists = [e for e in clause.actors if e.kind is ParticipantKind.BICYCLE]
    if cyclists:
        context.draft.hazard(HazardKind.CROSSING_CYCLIST, basis, cyclists)


def after_a_thing(clause: Clause, context: Context) -> None:
    """``a ball rolls onto the road, followed by a boy``: the boy crosses.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    if clause.event.name != "follow" or not clause.event.passive or clause.targets:
        return
    for entity in clause.walkers:
        context.draft.maneuver(entity, {Maneuver.CROSS}, clause.words)
    if clause.walkers:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, clause.words, clause.walkers)


def onto_the_road(clause: Clause, context: Context) -> None:
    """Whoever is on foot and gets onto the road or into somebody's way crosses, by any verb."""
    if in_the_road(clause, context):
        return
    onto = any(
        (p.value == "into" or context.tokens[p.word.i].low in _OVER)
        and isinstance(p.target, Place)
        and p.target.kind in _WAY
        for p in clause.event.pps
    )
    onto = onto or _stays_on_the_road(clause, context)
    if _across_by_any_verb(clause, context):
        cyclists_cross(clause, context)
        onto = True
    if onto and clause.walkers:
        for entity in clause.walkers:
            context.draft.maneuver(entity, {Maneuver.CROSS}, clause.words)
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, clause.words, clause.walkers)


def _to_the_other_side(goal: object) -> bool:
    """``zips over to the other side``, ``runs to the opposite pavement``."""
    if not isinstance(goal, Place) or goal.kind not in {"side", "sidewalk"}:
        return False
    return "opposite" in goal.dirs or any(m.value == "other" for m in goal.mods)


def _across_by_any_verb(clause: Clause, context: Context) -> bool:
    """``pedals straight across the road``, ``files across``: over it, whatever the verb."""
    event = clause.event
    if event.name in _ALONG_IT or event.nominal:
        return False
    own = {t.low for t in context.tokens[event.i : event.j]}
    own |= {context.tokens[m.j - 1].low for m in event.mods if m.cat in {"dir", "manner"}}
    direct = event.object
    if own & _OVER and isinstance(direct, Place) and direct.kind in _CROSSED:
        return True
    if any(_to_the_other_side(p.target) for p in event.pps if p.value == "to"):
        return True
    if own & _OVER and direct is None and clause.walkers:
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


def _stays_on_the_road(clause: Clause, context: Context) -> bool:
    """``stops on the crosswalk``, ``is lying in the road``: got there by crossing."""
    return (
        not clause.event.nominal
        and any(
            context.tokens[p.word.i].low in {"on", "in"}
            and isinstance(p.target, Place)
            and p.target.kind in _WAY - {"path"}
            for p in clause.event.pps
            if clause.event.name in _REMAINING
        )
    ) or (clause.event.name in _TAKING and clause.event.object in clause.places())


def answered(clause: Clause, context: Context) -> None:
    """``brakes for a child``, ``yields to pedestrians``: somebody crosses."""
    for prep in clause.event.pps:
        if prep.value not in {"for", "to"} or not isinstance(prep.target, Mention):
            continue
        walkers = [e for e in prep.target.entities if not e.is_vehicle]
        if walkers:
            basis = Basis(clause.event.i, prep.target.j)
            context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, basis, walkers)


def struck(clause: Clause, context: Context) -> None:
    """``was hit on the crosswalk``: whoever is hit there on foot was crossing."""
    _struck_aside(clause, context)
    there = any(p.kind == "crosswalk" for p in clause.places())
    walkers = [e for e in clause.targets if not e.is_vehicle]
    if there and walkers:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, clause.words, walkers)


def _struck_aside(clause: Clause, context: Context) -> None:
    """``changed lanes and struck its side``: no room was left for the change of lane."""
    hit = clause.event.object
    owner = hit.owner if isinstance(hit, Place) else None
    whom = [*clause.targets, *(owner.entities if owner is not None else [])]
    changed = [e for e in clause.drivers if e.maneuvers == {Maneuver.LANE_CHANGE} and not e.ego]
    cut = {e.index for d in context.draft.dangers if d.kind in _MERGED for e in d.by}
    moved = [e for e in whom if e.moving_vehicle]
    if changed and moved and not context.junction.crossing and not cut & {e.index for e in changed}:
        context.draft.hazard(HazardKind.CUT_IN, clause.words, changed, moved)


def walk(clause: Clause, context: Context) -> None:
    """Walking counts as crossing unless it keeps along the road or on the sidewalk."""
    if keep_along(clause, context):
        return
    if any(p.value == "into" and isinstance(p.target, Mention) for p in clause.event.pps):
        return  # "ran into me": contact
    basis = clause.words
    for entity in clause.walkers:
        context.draft.maneuver(entity, {Maneuver.CROSS}, basis)
    if clause.walkers:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, basis, clause.walkers)


def appear(clause: Clause, context: Context) -> None:
    """Coming into sight: people step into the way, vehicles come out of a side road."""
    walk(clause, context)
    hidden = any(
        p.value in _HIDING and (p.outer == "from" or context.tokens[p.word.i].low == "from")
        for p in clause.event.pps
    )
    if hidden:
        cyclists_cross(clause, context)
        return
    ride(clause, context)
    aside = any(p.kind in {"access", "parking"} for p in clause.places())
    to = [e for p in clause.event.pps if isinstance(p.target, Mention) for e in p.target.entities]
    others = [e for e in clause.drivers if not e.ego and e.kind is not ParticipantKind.BICYCLE]
    if aside and others and (clause.sudden is not None or to):
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, clause.words, others, to)


def ride(clause: Clause, context: Context) -> None:
    """``a cyclist rides onto the road`` comes from beside it."""
    onto = any(
        p.value == "into" and isinstance(p.target, Place) and p.target.kind in _CARRIAGEWAY
        for p in clause.event.pps
    )
    aside = any(p.kind in {"sidewalk", "access", "parking"} for p in clause.places())
    direct = clause.event.object if clause.event.name == "enter" else None
    onto = onto or (isinstance(direct, Place) and direct.kind in _CARRIAGEWAY)
    sided = any(p.value == "from" and isinstance(p.target, Place) for p in clause.event.pps)
    onto = onto or (sided and _into_a_path(clause))
    springs = clause.event.name == "appear" or any(p.kind == "path" for p in clause.places())
    onto = onto or (aside and springs)
    onto = onto or _across_the_path(clause, context)
    away = {"off", "from"}
    onto = onto or any(
        context.tokens[p.word.i].low in away
        and isinstance(p.target, Place)
        and p.target.kind == "sidewalk"
        for p in clause.event.pps
    )
    if onto and not any(t.value in {"left", "right"} for t in clause.event.dirs):
        cyclists_cross(clause, context)


def _into_a_path(clause: Clause) -> bool:
    """``rides from the right into the path of the ego``."""
    return any(
        p.value == "into" and isinstance(p.target, Place) and p.target.kind == "path"
        for p in clause.event.pps
    )


def _across_the_path(clause: Clause, context: Context) -> bool:
    """``rides straight across the ego's path``: whose path it is has to look out."""
    event = clause.event
    words = {context.tokens[m.j - 1].low for m in event.dirs} | {
        context.tokens[p.word.i].low for p in event.pps
    }
    paths = [p for p in clause.places() if p.kind == "path"]
    owned = any(p.owner is not None or any(m.cat == "possessive" for m in p.mods) for p in paths)
    return owned and "across" in words


def cyclists_cross(clause: Clause, context: Context) -> None:
    """Somebody on a bicycle gets onto the road, or over it.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    cyclists = [e for e in clause.actors if e.kind is ParticipantKind.BICYCLE and not e.ego]
    for entity in cyclists:
        context.draft.maneuver(entity, {Maneuver.CROSS}, clause.words)
    if cyclists:
        basis = clause.sudden or clause.words
        context.draft.hazard(HazardKind.CROSSING_CYCLIST, basis, cyclists)


def door(clause: Clause, context: Context) -> None:
    """An opened door stands in the way."""
    basis = clause.words
    people = any(h.value == "pedestrian" for m in clause.event.subject for h in m.heads)
    for entity in clause.drivers if people else []:  # "a woman opens her door": she has parked
        if not entity.ego and entity.moves is None and not entity.maneuvers:
            entity.parked, entity.parked_basis = True, basis
    context.draft.hazard(HazardKind.OBSTACLE, basis, clause.actors)
    context.draft.note(clause.event.i, clause.event.j, "doors are not modelled; an obstacle is")
