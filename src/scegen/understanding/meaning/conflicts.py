"""Dangers between vehicles: right of way, lanes, turns."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, ParticipantKind
from scegen.understanding.chunks import Event, Mention, Place
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.meaning import encounters, lane_moves, movements
from scegen.understanding.meaning.context import Context, Scene
from scegen.understanding.meaning.ways import (
    across_the_road,
    against,
    directions,
    into_lane,
    leads,
    next_lane,
    overtaking,
    without_arrow,
)

_ACROSS = {"left": Maneuver.LEFT, "right": Maneuver.RIGHT}
_TURNS = frozenset(_ACROSS.values())


def turn(scene: Scene, context: Context) -> None:
    """Unprotected and sudden turns, and turning into somebody's way."""
    event = scene.event
    cyclists = [e for e in scene.drivers if context.is_cyclist(e) and not e.ego]
    if cyclists and cyclists == scene.drivers and across_the_road(event, context):
        encounters.cyclists_cross(scene, context)
        return
    left = _ACROSS[context.across] in directions(event, context.tokens)
    lit = any(m.value == "unprotected" for p in scene.places() for m in p.mods)
    lit = lit or without_arrow(context)
    unprotected = scene.how("unprotected") or (scene.words if lit else None)
    if unprotected is not None and left:
        context.draft.hazard(HazardKind.UNPROTECTED_LEFT_TURN, scene.words, scene.drivers)
        return
    into_way = any(p.kind == "path" for p in scene.places()) or _across_somebody(scene, context)
    known = {m for e in scene.drivers for m in e.maneuvers}
    left = left or (not event.dirs and known & _TURNS == {_ACROSS[context.across]})
    settled = event.dirs or known & _TURNS
    sideways = all(context.from_the_side(e) for e in scene.drivers)
    if settled and scene.drivers and into_way:
        kind = HazardKind.FAILURE_TO_YIELD
        if left and not sideways:
            kind = HazardKind.UNPROTECTED_LEFT_TURN
        ways = [p for p in scene.places() if p.kind == "path" and p.owner is not None]
        to = [e for p in ways if p.owner is not None for e in p.owner.entities]
        context.draft.hazard(kind, scene.words, scene.drivers, to)
        return
    fronts = (p for p in event.pps if p.word.cat == "locus" and p.value == "ahead")
    in_front = next((p for p in fronts if not leads(p, context)), None)
    if in_front is not None and in_front.target is not None and scene.drivers:
        basis = Basis(event.i, in_front.target.j)
        to = in_front.target.entities if isinstance(in_front.target, Mention) else []
        abreast = any(context.placed(e, Approach.ADJACENT) for e in scene.drivers)
        kind = HazardKind.UNPROTECTED_LEFT_TURN if left else HazardKind.FAILURE_TO_YIELD
        kind = HazardKind.SUDDEN_TURN if left and abreast else kind
        across = all(context.comes_across(e) for e in scene.drivers)
        if left or (across and (not event.dirs or scene.sudden is None)):
            context.draft.hazard(kind, basis, scene.drivers, to)
            return
    sudden = scene.sudden
    lane = into_lane(event)
    if next_lane(event, context):
        lane_change(scene, context)
        return
    encroaches = lane is not None and "opposite" not in lane.dirs and not event.dirs
    if scene.drivers and not scene.reaction and (sudden is not None or encroaches):
        context.draft.hazard(HazardKind.SUDDEN_TURN, sudden or scene.words, scene.drivers)


def _across_somebody(scene: Scene, context: Context) -> bool:
    """``turned left right across me``: across my way."""
    return all(context.oncoming(e) for e in scene.drivers) and any(
        context.tokens[p.word.i].low == "across"
        and isinstance(p.target, Mention)
        and any(e.moving_vehicle for e in p.target.entities)
        for p in scene.event.pps
    )


def lane_change(scene: Scene, context: Context) -> None:
    """A lane change is a cut-in when abrupt or unsafe, or when it ends in another's lane."""
    sudden = scene.how("sudden", "emergency", "aggressive")
    if not scene.drivers:
        if sudden is not None and scene.event.nominal and not scene.event.subject:
            context.draft.hazard(HazardKind.CUT_IN, sudden, [])  # "dense traffic, a sudden …"
        return
    met = scene.event.object
    if isinstance(met, Mention) and "opposite" in met.dirs:
        context.draft.hazard(HazardKind.ONCOMING_LANE, scene.words, scene.drivers)
        return  # "crosses into oncoming traffic"
    lane = into_lane(scene.event)
    owners = _owners(lane, scene, context)
    in_front = [p for p in scene.event.pps if p.word.cat == "locus" and p.value == "ahead"]
    words = {t.low for t in context.tokens[scene.event.i : scene.event.j]}
    in_front = [] if "out" in words else in_front  # "cuts out in front of a stopped car"
    own_will = not scene.reaction and not all(e.ego for e in scene.drivers)
    if lane is not None and any(against(e, lane) for e in scene.drivers):
        return  # into the oncoming lane
    oncoming = any(context.oncoming(e) for e in scene.drivers) and not context.junction.crossing
    if lane is not None and lane.kind == "path" and owners and oncoming:
        context.draft.hazard(HazardKind.ONCOMING_LANE, scene.words, scene.drivers, owners)
        return
    if head_on(scene, lane, context):
        return  # an oncoming vehicle uses the wrong lane
    if oncoming and scene.event.lemma == "leave":
        context.draft.hazard(HazardKind.ONCOMING_LANE, scene.words, scene.drivers)
        return  # "an oncoming van leaves its lane"
    leaves = lane is not None and all(context.placed(e, Approach.AHEAD) for e in scene.drivers)
    if sudden is not None and leaves and not owners:
        return  # the one ahead leaves the lane at the last moment
    if sudden is not None and not scene.reaction:
        context.draft.hazard(
            HazardKind.CUT_IN, sudden, scene.drivers, _owners(lane, scene, context)
        )
    elif own_will and (owners or in_front):
        context.draft.hazard(
            HazardKind.CUT_IN, scene.words, scene.drivers, _owners(lane, scene, context)
        )


def cuts_in(scene: Scene, context: Context) -> bool:
    """Whether whoever acts is known to cut in on an open road, by whatever verb.

    Args:
        scene: what happens.
        context: the scenario in the making.
    """
    if context.junction.crossing or any(e.maneuvers for e in scene.drivers):
        return False
    cut = [e for d in context.draft.dangers if d.kind is HazardKind.CUT_IN for e in d.by]
    return bool(scene.drivers) and all(e in cut for e in scene.drivers)


def _owners(lane: Place | None, scene: Scene, context: Context) -> list[Entity]:
    """Whose lane it is; "its lane" is the ego's for everybody who moves into it."""
    if lane is None:
        return []
    if lane.owner is not None:
        return list(lane.owner.entities)
    possessed = any(m.cat == "possessive" for m in lane.mods)
    kept = any(m.value == "same" for m in lane.mods)
    others = [e for e in context.draft.entities if e.moving_vehicle and e not in scene.actors]
    named = [d for d in lane.dirs if d in _ACROSS]
    there = [e for e in others if e.ego and e.start_lane and e.start_lane[0] in named]
    if there and lane.kind == "lane":
        return there  # "the ego in the right lane …, a car changes to the right lane"
    its = [e for e in others if e.ego or (lane.kind == "path" and len(others) == 1)]
    return its if possessed and not kept else []


def head_on(scene: Scene, place: Place | None, context: Context) -> bool:
    """``an oncoming van drifts into the ego's lane``: it has no business there.

    Args:
        scene: what happens.
        place: where it ends.
        context: the scenario in the making.
    """
    if place is None or not _owners(place, scene, context):
        return False
    words = context.tokens
    if place.kind == "side" and not place.dirs:  # "comes onto the ego's side"
        return any(p.target is place and words[p.word.i].low == "onto" for p in scene.event.pps)
    entered = place is scene.event.object or any(
        p.target is place and p.value == "into" for p in scene.event.pps
    )
    if place.kind != "lane" or not (entered or place.owner is not None):
        return False  # "stays in its lane"
    egos = place.owner is not None and any(e.ego for e in place.owner.entities)
    sideways = any(t.value in _ACROSS for t in scene.event.dirs) and not egos
    return not sideways and any(context.oncoming(e) and not e.ego for e in scene.drivers)


def cut_in(scene: Scene, context: Context) -> None:
    """``cuts in`` from the next lane; across a junction the same words mean not giving way."""
    if not scene.drivers:
        return
    if _cuts_across_the_road(scene, context):
        movements.cross(scene, context)
        encounters.cross(scene, context)
        return
    if head_on(scene, into_lane(scene.event), context):
        context.draft.hazard(HazardKind.ONCOMING_LANE, scene.words, scene.drivers, scene.targets)
        return
    to = scene.targets or mentioned(scene.event)
    turning = any(e.maneuvers & {Maneuver.LEFT, Maneuver.RIGHT} for e in scene.drivers)
    words = {t.low for t in context.tokens[scene.event.i : scene.event.j]}
    across = "across" in words and context.junction.crossing
    beside = any(Maneuver.LANE_CHANGE in e.maneuvers for e in scene.drivers)
    if not beside and (turning or across or any(context.comes_across(e) for e in scene.drivers)):
        left = _ACROSS[context.across]
        oncoming = all(left in e.maneuvers and context.oncoming(e) for e in scene.drivers)
        kind = HazardKind.UNPROTECTED_LEFT_TURN if oncoming else HazardKind.FAILURE_TO_YIELD
        context.draft.hazard(kind, scene.words, scene.drivers, to)
        return
    basis = scene.words
    context.draft.hazard(HazardKind.CUT_IN, basis, scene.drivers, to)
    context.lanes_implied(basis, "cutting in needs a second lane")
    for entity in (e for e in scene.drivers if not e.maneuvers):
        context.draft.maneuver(entity, {Maneuver.LANE_CHANGE}, basis)


def _cuts_across_the_road(scene: Scene, context: Context) -> bool:
    """``a cyclist cuts across the road``: the road is crossed, nobody is cut off."""
    cyclists = all(e.kind is ParticipantKind.BICYCLE and not e.ego for e in scene.actors)
    over = any(p.kind == "road" for p in scene.places())
    over = over or any(Maneuver.CROSS in e.maneuvers for e in scene.actors)
    over = over or "across" in {t.low for t in context.tokens[scene.event.i : scene.event.j]}
    return cyclists and not scene.targets and over


def enter(scene: Scene, context: Context) -> None:
    """``enters the lane in front of V1``: a cut-in; from the front, the oncoming lane is used."""
    lane = into_lane(scene.event)
    others = [e for e in scene.drivers if not e.ego and Maneuver.CROSS not in e.maneuvers]
    _enter_in_front(scene, context)
    if lane is None or not others or scene.reaction:
        return
    if lane.kind == "path" and _owners(lane, scene, context):
        to = _owners(lane, scene, context)
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, scene.words, others, to)
    if lane.kind != "lane":
        return
    in_front = any(
        p.word.cat == "locus" and p.value == "ahead" for p in (*scene.event.pps, *lane.pps)
    )
    owners = _owners(lane, scene, context)
    if not in_front and not owners:
        return
    if any(context.oncoming(e) for e in others):
        context.draft.hazard(HazardKind.ONCOMING_LANE, scene.words, others, owners)
        return
    context.draft.hazard(HazardKind.CUT_IN, scene.words, others, owners or mentioned(scene.event))
    lane_moves.lane_change(scene, context)


def _enter_in_front(scene: Scene, context: Context) -> None:
    """``pulls into the junction in front of the bus``: the bus had to be let through."""
    to = mentioned(scene.event)
    meets = any(p.kind == "junction" for p in scene.places())
    if meets and to and scene.drivers and not scene.reaction:
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, scene.words, scene.drivers, to)


def unpark(scene: Scene, context: Context) -> None:
    """Leaving a parking space is a danger when careless, sudden or right in front of somebody."""
    careless = scene.how("aggressive", "sudden")
    to = mentioned(scene.event)
    others = [e for e in scene.drivers if not e.ego]
    for entity in others:
        entity.pulls_out = True
        if entity.kind is not ParticipantKind.BUS:  # one at its stop is not parked
            entity.was_parked = entity.was_parked or scene.words
    if others and (careless is not None or to):
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, careless or scene.words, others, to)


def leave(scene: Scene, context: Context) -> None:
    """``leaves a lay-by right in front of the ego``: like leaving a parking space."""
    if any(p.kind in {"access", "bus_stop", "parking"} for p in scene.places()):
        unpark(scene, context)


def mentioned(event: Event) -> list[Entity]:
    """Who is named in the phrases that place an event ("in front of the bus")."""
    found = [p.target for p in event.pps if p.word.cat == "locus"]
    return [e for t in found if isinstance(t, Mention) for e in t.entities]


def merge(scene: Scene, context: Context) -> None:
    """Merging into traffic is a conflict; into the lane of another vehicle it is a cut-in."""
    if not scene.drivers:
        return
    lane = into_lane(scene.event)
    basis = scene.how("sudden", "aggressive") or scene.words
    ahead = [p for p in scene.event.pps if p.word.cat == "locus" and p.value == "ahead"]
    alone = all(e.ego for e in scene.drivers) and scene.event.modal
    if ahead and mentioned(scene.event) and not (alone or context.junction.crossing):
        context.draft.hazard(HazardKind.CUT_IN, basis, scene.drivers, mentioned(scene.event))
        return  # "merges in front of the bus"
    own = all(e.ego for e in scene.drivers) and not _owners(lane, scene, context)
    if lane is not None and (lane.owner is not None or lane.dirs) and not own:
        context.draft.hazard(HazardKind.CUT_IN, basis, scene.drivers, _owners(lane, scene, context))
        return
    to = [
        e
        for p in scene.event.pps
        if p.value in {"into", "with"} and isinstance(p.target, Mention)
        for e in p.target.entities
    ]
    context.draft.hazard(HazardKind.MERGING_CONFLICT, basis, scene.drivers, to)


def overtake(scene: Scene, context: Context) -> None:
    """Overtaking another moving vehicle."""
    if not overtaking(scene, context):
        return
    afoot = bool(scene.targets) and not any(e.is_vehicle for e in scene.targets)
    if scene.event.name == "pass" and afoot:
        return
    if scene.drivers and (not scene.targets or any(not e.parked for e in scene.targets)):
        context.draft.hazard(HazardKind.OVERTAKING, scene.words, scene.drivers, scene.targets)
