"""Dangers between vehicles: right of way, lanes, turns."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, ParticipantKind
from scegen.understanding.chunks import Event, Mention, Place
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.meaning import encounters, lane_moves, movements
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
from scegen.understanding.semantics.context import Clause, Context

_ACROSS = {"left": Maneuver.LEFT, "right": Maneuver.RIGHT}
_TURNS = frozenset(_ACROSS.values())


def turn(clause: Clause, context: Context) -> None:
    """Unprotected and sudden turns, and turning into somebody's way."""
    event = clause.event
    cyclists = [e for e in clause.drivers if context.is_cyclist(e) and not e.ego]
    if cyclists and cyclists == clause.drivers and across_the_road(event, context):
        encounters.cyclists_cross(clause, context)
        return
    left = _ACROSS[context.across] in directions(event, context.tokens)
    lit = any(m.value == "unprotected" for p in clause.places() for m in p.mods)
    lit = lit or without_arrow(context)
    unprotected = clause.how("unprotected") or (clause.words if lit else None)
    if unprotected is not None and left:
        context.draft.hazard(HazardKind.UNPROTECTED_LEFT_TURN, clause.words, clause.drivers)
        return
    into_way = any(p.kind == "path" for p in clause.places()) or _across_somebody(clause, context)
    known = {m for e in clause.drivers for m in e.maneuvers}
    left = left or (not event.dirs and known & _TURNS == {_ACROSS[context.across]})
    settled = event.dirs or known & _TURNS
    sideways = all(context.from_the_side(e) for e in clause.drivers)
    if settled and clause.drivers and into_way:
        kind = HazardKind.FAILURE_TO_YIELD
        if left and not sideways:
            kind = HazardKind.UNPROTECTED_LEFT_TURN
        ways = [p for p in clause.places() if p.kind == "path" and p.owner is not None]
        to = [e for p in ways if p.owner is not None for e in p.owner.entities]
        context.draft.hazard(kind, clause.words, clause.drivers, to)
        return
    fronts = (p for p in event.pps if p.word.cat == "locus" and p.value == "ahead")
    in_front = next((p for p in fronts if not leads(p, context)), None)
    if in_front is not None and in_front.target is not None and clause.drivers:
        basis = Basis(event.i, in_front.target.j)
        to = in_front.target.entities if isinstance(in_front.target, Mention) else []
        abreast = any(context.placed(e, Approach.ADJACENT) for e in clause.drivers)
        kind = HazardKind.UNPROTECTED_LEFT_TURN if left else HazardKind.FAILURE_TO_YIELD
        kind = HazardKind.SUDDEN_TURN if left and abreast else kind
        across = all(context.comes_across(e) for e in clause.drivers)
        if left or (across and (not event.dirs or clause.sudden is None)):
            context.draft.hazard(kind, basis, clause.drivers, to)
            return
    sudden = clause.sudden
    lane = into_lane(event)
    if next_lane(event, context):
        lane_change(clause, context)
        return
    encroaches = lane is not None and "opposite" not in lane.dirs and not event.dirs
    if clause.drivers and not clause.reaction and (sudden is not None or encroaches):
        context.draft.hazard(HazardKind.SUDDEN_TURN, sudden or clause.words, clause.drivers)


def _across_somebody(clause: Clause, context: Context) -> bool:
    """``turned left right across me``: across my way."""
    return all(context.oncoming(e) for e in clause.drivers) and any(
        context.tokens[p.word.i].low == "across"
        and isinstance(p.target, Mention)
        and any(e.moving_vehicle for e in p.target.entities)
        for p in clause.event.pps
    )


def lane_change(clause: Clause, context: Context) -> None:
    """A lane change is a cut-in when abrupt or unsafe, or when it ends in another's lane."""
    sudden = clause.how("sudden", "emergency", "aggressive")
    if not clause.drivers:
        if sudden is not None and clause.event.nominal and not clause.event.subject:
            context.draft.hazard(HazardKind.CUT_IN, sudden, [])  # "dense traffic, a sudden …"
        return
    met = clause.event.object
    if isinstance(met, Mention) and "opposite" in met.dirs:
        context.draft.hazard(HazardKind.ONCOMING_LANE, clause.words, clause.drivers)
        return  # "crosses into oncoming traffic"
    lane = into_lane(clause.event)
    owners = _owners(lane, clause, context)
    in_front = [p for p in clause.event.pps if p.word.cat == "locus" and p.value == "ahead"]
    words = {t.low for t in context.tokens[clause.event.i : clause.event.j]}
    in_front = [] if "out" in words else in_front  # "cuts out in front of a stopped car"
    own_will = not clause.reaction and not all(e.ego for e in clause.drivers)
    if lane is not None and any(against(e, lane) for e in clause.drivers):
        return  # into the oncoming lane
    oncoming = any(context.oncoming(e) for e in clause.drivers) and not context.junction.crossing
    if lane is not None and lane.kind == "path" and owners and oncoming:
        context.draft.hazard(HazardKind.ONCOMING_LANE, clause.words, clause.drivers, owners)
        return
    if head_on(clause, lane, context):
        return  # an oncoming vehicle uses the wrong lane
    if oncoming and clause.event.lemma == "leave":
        context.draft.hazard(HazardKind.ONCOMING_LANE, clause.words, clause.drivers)
        return  # "an oncoming van leaves its lane"
    leaves = lane is not None and all(context.placed(e, Approach.AHEAD) for e in clause.drivers)
    if sudden is not None and leaves and not owners:
        return  # the one ahead leaves the lane at the last moment
    if sudden is not None and not clause.reaction:
        context.draft.hazard(
            HazardKind.CUT_IN, sudden, clause.drivers, _owners(lane, clause, context)
        )
    elif own_will and (owners or in_front):
        context.draft.hazard(
            HazardKind.CUT_IN, clause.words, clause.drivers, _owners(lane, clause, context)
        )


def cuts_in(clause: Clause, context: Context) -> bool:
    """Whether whoever acts is known to cut in on an open road, by whatever verb.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    if context.junction.crossing or any(e.maneuvers for e in clause.drivers):
        return False
    cut = [e for d in context.draft.dangers if d.kind is HazardKind.CUT_IN for e in d.by]
    return bool(clause.drivers) and all(e in cut for e in clause.drivers)


def _owners(lane: Place | None, clause: Clause, context: Context) -> list[Entity]:
    """Whose lane it is; "its lane" is the ego's for everybody who moves into it."""
    if lane is None:
        return []
    if lane.owner is not None:
        return list(lane.owner.entities)
    possessed = any(m.cat == "possessive" for m in lane.mods)
    kept = any(m.value == "same" for m in lane.mods)
    others = [e for e in context.draft.entities if e.moving_vehicle and e not in clause.actors]
    named = [d for d in lane.dirs if d in _ACROSS]
    there = [e for e in others if e.ego and e.start_lane and e.start_lane[0] in named]
    if there and lane.kind == "lane":
        return there  # "the ego in the right lane …, a car changes to the right lane"
    its = [e for e in others if e.ego or (lane.kind == "path" and len(others) == 1)]
    return its if possessed and not kept else []


def head_on(clause: Clause, place: Place | None, context: Context) -> bool:
    """``an oncoming van drifts into the ego's lane``: it has no business there.

    Args:
        clause: what happens.
        place: where it ends.
        context: the scenario in the making.
    """
    if place is None or not _owners(place, clause, context):
        return False
    words = context.tokens
    if place.kind == "side" and not place.dirs:  # "comes onto the ego's side"
        return any(p.target is place and words[p.word.i].low == "onto" for p in clause.event.pps)
    entered = place is clause.event.object or any(
        p.target is place and p.value == "into" for p in clause.event.pps
    )
    if place.kind != "lane" or not (entered or place.owner is not None):
        return False  # "stays in its lane"
    egos = place.owner is not None and any(e.ego for e in place.owner.entities)
    sideways = any(t.value in _ACROSS for t in clause.event.dirs) and not egos
    return not sideways and any(context.oncoming(e) and not e.ego for e in clause.drivers)


def cut_in(clause: Clause, context: Context) -> None:
    """``cuts in`` from the next lane; across a junction the same words mean not giving way."""
    if not clause.drivers:
        return
    if _cuts_across_the_road(clause, context):
        movements.cross(clause, context)
        encounters.cross(clause, context)
        return
    if head_on(clause, into_lane(clause.event), context):
        context.draft.hazard(HazardKind.ONCOMING_LANE, clause.words, clause.drivers, clause.targets)
        return
    to = clause.targets or mentioned(clause.event)
    turning = any(e.maneuvers & {Maneuver.LEFT, Maneuver.RIGHT} for e in clause.drivers)
    words = {t.low for t in context.tokens[clause.event.i : clause.event.j]}
    across = "across" in words and context.junction.crossing
    beside = any(Maneuver.LANE_CHANGE in e.maneuvers for e in clause.drivers)
    if not beside and (turning or across or any(context.comes_across(e) for e in clause.drivers)):
        left = _ACROSS[context.across]
        oncoming = all(left in e.maneuvers and context.oncoming(e) for e in clause.drivers)
        kind = HazardKind.UNPROTECTED_LEFT_TURN if oncoming else HazardKind.FAILURE_TO_YIELD
        context.draft.hazard(kind, clause.words, clause.drivers, to)
        return
    basis = clause.words
    context.draft.hazard(HazardKind.CUT_IN, basis, clause.drivers, to)
    context.lanes_implied(basis, "cutting in needs a second lane")
    for entity in (e for e in clause.drivers if not e.maneuvers):
        context.draft.maneuver(entity, {Maneuver.LANE_CHANGE}, basis)


def _cuts_across_the_road(clause: Clause, context: Context) -> bool:
    """``a cyclist cuts across the road``: the road is crossed, nobody is cut off."""
    cyclists = all(e.kind is ParticipantKind.BICYCLE and not e.ego for e in clause.actors)
    over = any(p.kind == "road" for p in clause.places())
    over = over or any(Maneuver.CROSS in e.maneuvers for e in clause.actors)
    over = over or "across" in {t.low for t in context.tokens[clause.event.i : clause.event.j]}
    return cyclists and not clause.targets and over


def enter(clause: Clause, context: Context) -> None:
    """``enters the lane in front of V1``: a cut-in; from the front, the oncoming lane is used."""
    lane = into_lane(clause.event)
    others = [e for e in clause.drivers if not e.ego and Maneuver.CROSS not in e.maneuvers]
    _enter_in_front(clause, context)
    if lane is None or not others or clause.reaction:
        return
    if lane.kind == "path" and _owners(lane, clause, context):
        to = _owners(lane, clause, context)
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, clause.words, others, to)
    if lane.kind != "lane":
        return
    in_front = any(
        p.word.cat == "locus" and p.value == "ahead" for p in (*clause.event.pps, *lane.pps)
    )
    owners = _owners(lane, clause, context)
    if not in_front and not owners:
        return
    if any(context.oncoming(e) for e in others):
        context.draft.hazard(HazardKind.ONCOMING_LANE, clause.words, others, owners)
        return
    context.draft.hazard(HazardKind.CUT_IN, clause.words, others, owners or mentioned(clause.event))
    lane_moves.lane_change(clause, context)


def _enter_in_front(clause: Clause, context: Context) -> None:
    """``pulls into the junction in front of the bus``: the bus had to be let through."""
    to = mentioned(clause.event)
    meets = any(p.kind == "junction" for p in clause.places())
    if meets and to and clause.drivers and not clause.reaction:
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, clause.words, clause.drivers, to)


def unpark(clause: Clause, context: Context) -> None:
    """Leaving a parking space is a danger when careless, sudden or right in front of somebody."""
    careless = clause.how("aggressive", "sudden")
    to = mentioned(clause.event)
    others = [e for e in clause.drivers if not e.ego]
    for entity in others:
        entity.pulls_out = True
        if entity.kind is not ParticipantKind.BUS:  # one at its stop is not parked
            entity.was_parked = entity.was_parked or clause.words
    if others and (careless is not None or to):
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, careless or clause.words, others, to)


def leave(clause: Clause, context: Context) -> None:
    """``leaves a lay-by right in front of the ego``: like leaving a parking space."""
    if any(p.kind in {"access", "bus_stop", "parking"} for p in clause.places()):
        unpark(clause, context)


def mentioned(event: Event) -> list[Entity]:
    """Who is named in the phrases that place an event ("in front of the bus")."""
    found = [p.target for p in event.pps if p.word.cat == "locus"]
    return [e for t in found if isinstance(t, Mention) for e in t.entities]


def merge(clause: Clause, context: Context) -> None:
    """Merging into traffic is a conflict; into the lane of another vehicle it is a cut-in."""
    if not clause.drivers:
        return
    lane = into_lane(clause.event)
    basis = clause.how("sudden", "aggressive") or clause.words
    ahead = [p for p in clause.event.pps if p.word.cat == "locus" and p.value == "ahead"]
    alone = all(e.ego for e in clause.drivers) and clause.event.modal
    if ahead and mentioned(clause.event) and not (alone or context.junction.crossing):
        context.draft.hazard(HazardKind.CUT_IN, basis, clause.drivers, mentioned(clause.event))
        return  # "merges in front of the bus"
    own = all(e.ego for e in clause.drivers) and not _owners(lane, clause, context)
    if lane is not None and (lane.owner is not None or lane.dirs) and not own:
        context.draft.hazard(
            HazardKind.CUT_IN, basis, clause.drivers, _owners(lane, clause, context)
        )
        return
    to = [
        e
        for p in clause.event.pps
        if p.value in {"into", "with"} and isinstance(p.target, Mention)
        for e in p.target.entities
    ]
    context.draft.hazard(HazardKind.MERGING_CONFLICT, basis, clause.drivers, to)


def overtake(clause: Clause, context: Context) -> None:
    """Overtaking another moving vehicle."""
    if not overtaking(clause, context):
        return
    afoot = bool(clause.targets) and not any(e.is_vehicle for e in clause.targets)
    if clause.event.name == "pass" and afoot:
        return
    if clause.drivers and (not clause.targets or any(not e.parked for e in clause.targets)):
        context.draft.hazard(HazardKind.OVERTAKING, clause.words, clause.drivers, clause.targets)
