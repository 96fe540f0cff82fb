"""Where participants come from: "the oncoming car", "behind the van", "northbound"."""

from __future__ import annotations

from dataclasses import replace

from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Event, Mention, Place, Prep, Thing
from scegen.understanding.clauses.located import landmark
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.approaches import INVERSE, SIDES, adjective_approaches
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.rows import say
from scegen.understanding.words.terms import Term

_OUT_OF = frozenset({"parking", "access"})


def _in_line(prep: Prep, entities: list[Entity], event: Event) -> bool:
    """``enters the roundabout behind a car``: as it follows that one, which is not in it yet."""
    after = event.name in {"enter", "turn"} and prep.value == "behind"
    led = prep.who.entities if prep.who is not None else []
    comes = any("opposite" in e.dirs for e in (*entities, *led))
    return after and not comes and not any(e.circulates for e in led)


def _ends_there(event: Event, prep: Prep, entities: list[Entity]) -> bool:
    """``sweeps left in front of the bus``: where it gets to."""
    turns = any(d.value in SIDES for d in event.dirs)
    places = [(p.value, p.place.kind) for p in event.pps if p.place is not None]
    onto = any(word in {"to", "into"} and kind == "lane" for word, kind in places)
    # "a car comes the other way; the ego backs out in front of it"
    out = event.name in {"reverse", "appear"} and any(kind in _OUT_OF for _, kind in places)
    goal = event.object.kind if isinstance(event.object, Place) else ""
    out = out or (event.name, goal) == ("merge", "road")
    afoot = prep.who is not None and not any(e.is_vehicle for e in prep.who.entities)
    egos = any(e.ego for e in entities)  # "the ego stops in front of the van": it came up to it
    halts = (afoot or egos) and event.name == "stop"  # "stops 1 m in front of her"
    # "passes behind the ego", "passes just in front of it"
    past = prep.value in {"behind", "ahead"} and event.name in {"pass", "cross"}
    return past or ((turns or onto or out or halts) and prep.value == "ahead")


def _same_way(prep: Prep) -> bool:
    """``in the same direction as the ego``."""
    place = prep.place
    return place is not None and place.kind == "direction" and "same" in place.dirs


def adjectives(mention: Mention, context: Context) -> None:
    """``the oncoming car``, ``a northbound truck``."""
    approaches = adjective_approaches(mention.dirs)
    term = mention.mod("dir") or mention.head
    for entity in mention.entities:
        if approaches and term is not None:
            context.draft.place(entity, None, set(approaches), Basis(term.i, term.j))
    for mod in mention.mods:
        if mod.cat == "compass":
            heading(mod, mention.entities)


def phrase(prep: Prep, entities: list[Entity], event: Event | None, context: Context) -> None:
    """One prepositional phrase that belongs to some participants."""
    if prep.word.cat == "locus":
        _locus(prep, entities, event, context)
        return
    if isinstance(prep.target, Place):
        own = event or Event("", prep.word.i, prep.target.j, "")
        clause = Clause(replace(own, pps=[prep]), list(entities), [])
        say("positions.phrase", clause, context)


def _locus(prep: Prep, entities: list[Entity], event: Event | None, context: Context) -> None:
    target = landmark(prep.target)
    basis = Basis(prep.word.i, target.j if isinstance(target, Mention) else prep.word.j)
    if isinstance(target, Thing | Place):
        return
    if prep.value == "between":
        by = prep.who.entities if prep.who is not None else []
        for entity in entities if len(by) == 1 and by[0].ego else []:
            context.draft.place(entity, None, {Approach.ADJACENT}, basis)
        return  # "between the ego and the kerb"
    follows = event is not None and _in_line(prep, entities, event)
    moves = event is not None and event.name not in word_list("steady")
    if moves and prep.outer != "from" and not follows:
        _behind_the_ego(prep, entities, basis, context)
        return
    out_of = prep.outer == "from" and isinstance(target, Mention)
    if event is not None and target and (out_of or _ends_there(event, prep, entities)):
        return
    comes = target is None and (prep.outer, prep.value) == ("from", "ahead")
    approaches = {Approach.OPPOSITE if comes else Approach(prep.value)}
    seen_from = target.entities if isinstance(target, Mention) else []
    reference = seen_from[0] if seen_from else None
    if isinstance(target, Mention) and reference is None:
        return
    if approaches == {Approach.ADJACENT} and any(e.parked for e in (*entities, *seen_from[:1])):
        return  # "1 m beside the parked cars": they have no lane of their own
    same = event is not None and any(_same_way(p) for p in event.pps)
    for entity in entities:
        if entity.is_vehicle or prep.value != "ahead" or same:
            context.draft.place(entity, reference, approaches, basis)
    for other in seen_from[1:] if len(entities) == 1 else []:
        context.draft.place(other, entities[0], {INVERSE[a] for a in approaches}, basis)


def _behind_the_ego(prep: Prep, entities: list[Entity], basis: Basis, context: Context) -> None:
    """``crosses behind the ego``: on foot, that is where they are."""
    whom = prep.who.entities if prep.value == "behind" and prep.who is not None else []
    for entity in entities if any(e.ego for e in whom) else []:
        if not entity.is_vehicle:
            context.draft.place(entity, None, {Approach.BEHIND}, basis)


def heading(term: Term, entities: list[Entity]) -> None:
    """``travelling northbound``, ``a northbound truck``."""
    for entity in entities:
        entity.bound = entity.bound or "bound" in term.data
        if entity.heading is None:
            entity.heading, entity.heading_basis = term.value, Basis(term.i, term.j)
