"""Who stands in the lane from the start: stationary, broken down, stopped before it begins."""

from __future__ import annotations

from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding.chunks import Event, Mention, Place
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.doing import by_then
from scegen.understanding.semantics.patterns import noun
from scegen.understanding.semantics.roles import clause_of
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import base_words

_LINES = frozenset({"signal", "stop_sign", "stop_line", "yield_sign"})
_ROADSIDE = frozenset({"shoulder", "sidewalk", "parking"})
_HALTS = frozenset({"stop_line", "crosswalk", "junction"})
_EDGE = noun(["place", "+edge", "+left|right"])
_IN_LANE = frozenset({"road", "lane", "middle"})
_SLOWING = frozenset({"brake", "hard_brake", "slow", "stop"})
_IN_THE_WAY = frozenset({HazardKind.STOPPING, HazardKind.OBSTACLE})
_REACH = 3
_FROM_REACH = 10
_STARTING = frozenset({"accelerate", "leave", "move", "light", "try"})


def note_braking(events: list[Event], context: Context) -> None:
    """``brakes hard; once it stands …``: it does not stand from the start."""
    for event in events:
        told = event.finite and not (event.perfect or event.negated or event.modal)
        slows = event.name in _SLOWING and not _stands(event, context)
        for entity in clause_of(event).drivers if told and slows else []:
            entity.brakes_from = event.i if entity.brakes_from is None else entity.brakes_from


def _stand_in_the_way(clause: Clause) -> None:
    """``blocks the road``, ``the road is blocked by a van``: that does nothing else."""
    places = [*clause.places(), clause.event.object]
    road = any(isinstance(p, Place) and p.kind in _IN_LANE for p in places)
    idle = [e for e in clause.actors if e.is_vehicle and not (e.ego or e.maneuvers)]
    _stand_in_the_lane([e for e in idle if road and e.sets_off < 0], clause.words)


def _comes_to_rest(entities: list[Entity], basis: Basis) -> list[Entity]:
    """Leaves those who stand from the start, and notes who stands since it has braked."""
    for entity in entities:
        if entity.brakes_from is not None and entity.brakes_from < (basis.i or 0):
            entity.rests.append(basis)
    return [e for e in entities if basis not in e.rests]


def stand(clause: Clause, context: Context) -> None:
    """``a van stands in the lane``, ``a bus has stopped``: from the start, and all the time."""
    event = clause.event
    stays = _never_moves(event, context)
    if event.modal or event.nominal or (event.negated and not stays) or _until(event, context):
        return
    vehicles = [e for e in clause.actors if e.is_vehicle]
    if event.name in _STARTING and (_from_rest(event, context) or _first_goes(clause, context)):
        _until_it_goes(vehicles, clause)
        return
    if event.name == "block":
        _stand_in_the_way(clause)
        return
    behind = _queues(event, context)
    stands = stays or bool(behind) or _stands(event, context)
    _stand_in_the_lane(behind, clause.words)
    places = [p for p in clause.places() if p.prep is None or p.prep.value != "with"]  # its lights
    in_lane = any(p.kind in _IN_LANE for p in places)
    in_lane |= any((p.word.cat, p.value) == ("locus", "ahead") for p in event.pps)
    in_lane = in_lane and event.lemma not in word_list("standing")
    waiting = event.name == "wait" and (event.premod_of is not None or in_lane)
    if waiting and not context.junction.crossing:  # "a waiting bus", "a car waits on the road"
        _stand_in_the_lane([e for e in vehicles if e.sets_off < 0], clause.words)
        return
    at = {p.kind for p in places} & (_LINES | _HALTS)
    if at and _waits_there(event, context):
        _wait_at_a_line(clause, at)
    if not stands:
        return
    actors = _comes_to_rest(clause.actors, clause.words)
    aside = any(p.kind in _ROADSIDE or (p.dirs and _EDGE(p, context)) for p in places)
    if aside:
        _beside_the_lanes(actors, clause, context)
    if (aside or at & _LINES) and not _lasting(event, context):
        return
    _stand_in_the_lane(actors, clause.words)
    for entity in actors:
        walks = not entity.is_vehicle and not entity.parked
        if walks and Maneuver.CROSS not in entity.maneuvers:
            context.draft.maneuver(entity, {Maneuver.STAY}, clause.words)


def _wait_at_a_line(clause: Clause, at: set[str]) -> None:
    """``waits at a red light``, ``the ego waits at the stop line``."""
    if at & _LINES:
        lit = "signal" in at
        for entity in [e for e in clause.actors if lit or e.sets_off < 0]:
            entity.held = entity.held or clause.words
    if at & _HALTS:
        _stand_in_the_lane([e for e in clause.actors if e.ego and e.sets_off < 0], clause.words)


def _beside_the_lanes(actors: list[Entity], clause: Clause, context: Context) -> None:
    """``stands on the shoulder``, ``… and pulls out``: parked, all the time or at first."""
    beside: list[Entity] = []
    for entity in [e for e in actors if e.is_vehicle]:
        if entity.sets_off >= clause.event.i:
            entity.was_parked, entity.pulls_out = entity.was_parked or clause.words, True
        elif not entity.ego:
            beside.append(entity)
            entity.parked, entity.parked_basis = True, clause.words
    context.draft.dangers[:] = [  # "a broken-down van stands on the shoulder": in nobody's way
        d for d in context.draft.dangers
        if d.kind not in _IN_THE_WAY or not d.by or not all(e in beside for e in d.by)
    ]  # fmt: skip


def _lasting(event: Event, context: Context) -> bool:
    """``stands at red the entire time``: it never goes on."""
    after = f" {' '.join(_words_after(event, context))} "
    return any(f" {words} " in after for words in word_list("all_the_time"))


def _stands(event: Event, context: Context) -> bool:
    at_rest = event.name in {"wait", "stop"} and event.lemma in word_list("standing")
    return at_rest or _over(event, context)


def _queues(event: Event, context: Context) -> list[Entity]:
    """``waits behind a car``: who stands there, too, where no junction tells for what."""
    waits = event.name == "wait" and event.object is None and not event.negated
    if not waits or context.junction.crossing:
        return []
    if word_list("waiting_for") & {*_words_after(event, context)}:
        return []
    whom = [p.who for p in event.pps if (p.value, p.outer) == ("behind", None)]
    return [e for m in whom if m is not None for e in m.entities if e.is_vehicle and not e.ego]


def _words_after(event: Event, context: Context) -> list[str]:
    return [t.low for t in context.tokens[event.j : event.j + _FROM_REACH]]


def _never_moves(event: Event, context: Context) -> bool:
    """``does not move``: not for a while, to nowhere, and before no light."""
    said = event.name == "move" and event.lemma in word_list("budging") and event.negated
    away = event.dirs or any(p.value in {"into", "to", "from"} for p in event.pps)
    timed = any((m.cat, m.value) == ("quantity", "time") for m in event.mods)
    return said and not (away or timed or context.junction.crossing)


def _from_rest(event: Event, context: Context) -> bool:
    """``accelerates from standstill``: it stands until then."""
    after = _words_after(event, context)
    at = after.index("from") if "from" in after else len(after)
    return bool(set(after[at + 1 : at + 3]) & word_list("at_rest"))


def _first_goes(clause: Clause, context: Context) -> bool:
    """``the truck sets off``: of whom nothing else is told before, on a road without a junction."""
    event = clause.event
    words = base_words(context.tokens, event.i, event.j)
    away = event.object is not None or event.pps or event.dirs or context.junction.crossing
    if away or words not in word_list("setting_off"):
        return False
    braked = any(e.brakes_from is not None and e.brakes_from < event.i for e in clause.actors)
    return not braked and not any(entity.pulls_out or entity.moves for entity in clause.actors)


def _waits_there(event: Event, context: Context) -> bool:
    """``waits at a red light``: it stands there when it begins; who stops there comes there.

    Who waits at a line for somebody gives way.
    """
    waits = (event.name == "wait" and event.link is None) or _over(event, context)
    if any(isinstance(p.target, Place) and p.target.kind == "signal" for p in event.pps):
        return waits
    after = context.tokens[event.j : event.j + _FROM_REACH]
    whom = any(p.value == "for" and isinstance(p.target, Mention) for p in event.pps)
    return waits and not (whom or any(t.low in word_list("until") for t in after))


def _until_it_goes(vehicles: list[Entity], clause: Clause) -> None:
    for entity in vehicles:
        entity.sets_off = max(entity.sets_off, clause.event.i)
    _stand_in_the_lane(vehicles, clause.words)


def _stand_in_the_lane(entities: list[Entity], basis: Basis) -> None:
    for entity in [e for e in entities if not e.parked]:
        entity.stands = entity.stands or basis
        if entity.ego and entity.speed is None:
            entity.speed, entity.speed_basis = Interval(low=0.0, high=0.0), basis


def jam(mention: Mention, context: Context) -> None:
    """``the end of a jam``: it stands, unless the text lets it move."""
    if mention.head is not None and mention.head.data.get("stands"):
        others = [e for e in mention.entities if not e.ego]
        state(Term("state", "stationary", mention.i, mention.j), others, context)


def state(term: Term, entities: list[Entity], context: Context) -> None:
    """``a stationary car``, ``a parked van``: in the lane, or beside it."""
    basis = Basis(term.i, term.j)
    if term.value == "stationary":
        entities = _comes_to_rest(entities, basis)
    others = [e for e in entities if not e.ego]
    if term.value == "stationary":
        drivers = [e for e in others if e.moving_vehicle]
        if drivers:
            kind = HazardKind.OBSTACLE if term.data.get("broken") else HazardKind.STOPPING
            context.draft.hazard(kind, basis, drivers)
        for entity in others:
            entity.stands = entity.stands or basis
        _stand_in_the_lane([e for e in entities if e.ego], basis)
    elif term.value == "parked":
        for entity in others:
            if entity.is_vehicle and entity.sets_off < 0:
                entity.parked, entity.parked_basis = True, basis
        if term.data.get("in_lane"):
            context.draft.hazard(HazardKind.OBSTACLE, basis, [e for e in others if e.parked])


def _until(event: Event, context: Context) -> bool:
    """``brakes until it stands``, ``once it has stopped``: not before."""
    return bool(word_list("until") & _words_before(event, context)) or by_then(event, context)


def _over(event: Event, context: Context) -> bool:
    """``has stopped``, ``is stopped``: before it begins."""
    if event.name != "stop":
        return False
    if event.perfect:
        return event.form in {"ed", "base"}  # "has come to a stop"
    now = not context.told_in_the_past and all(m.cat == "quantity" for m in event.mods)
    since = bool(word_list("since") & _words_before(event, context))
    return event.form == "ed" and (event.reduced or now or since)


def _words_before(event: Event, context: Context) -> set[str]:
    return {t.low for t in context.tokens[max(0, event.i - _REACH) : event.i]}
