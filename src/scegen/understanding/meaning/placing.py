"""Where participants are or come from: "the oncoming car", "behind the van", "in a row"."""

from dataclasses import replace
from itertools import combinations, pairwise, product

from scegen.scenario.vocabulary import Approach, ParticipantKind
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Prep, Thing
from scegen.understanding.clauses.dependents import chain
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.conditions import holds
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.lanes import INVERSE, SIDES, adjective_approaches
from scegen.understanding.semantics.rows import say
from scegen.understanding.words.numbers import POSITIONS
from scegen.understanding.words.terms import Term

_FROM_THE_KERB = frozenset({ParticipantKind.PEDESTRIAN, ParticipantKind.BICYCLE})


def adjectives(mention: Mention, context: Context) -> None:
    """``the oncoming car``, ``a northbound truck``, ``a nearside pedestrian``."""
    approaches = adjective_approaches(mention.dirs)
    term = mention.mod("dir") or mention.head
    first = term is not None and mention.head is not None and term.i < mention.head.i
    sides = {SIDES[d] for d in mention.dirs if first and d in SIDES}
    named = [context.tokens[term.i].low] if term is not None and context.draft.ego is None else []
    turning = mention.has("verb", "turn")  # "a right-turning cyclist"
    pair = mention.entities if mention.plural and named == ["opposing"] else []  # to each other
    beside = sides | {Approach.ADJACENT} if term and "beside" in term.data else set()
    for entity in mention.entities:
        comes = entity.kind in _FROM_THE_KERB or context.junction.crossing  # "the right-hand car"
        seen = approaches or (sides if comes and not (turning or beside) else beside)
        if seen and term is not None:
            context.draft.place(entity, next(iter(pair), None), set(seen), Basis(term.i, term.j))
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
    target = prep.target
    basis = Basis(prep.word.i, target.j if isinstance(target, Mention) else prep.word.j)
    if isinstance(target, Thing | Place):
        return
    led = prep.who.entities if prep.who is not None else []
    if prep.value == "between":
        for entity in entities if len(led) == 1 and led[0].ego else []:
            context.draft.place(entity, None, {Approach.ADJACENT}, basis)
        return  # "between the ego and the kerb"
    clause = Clause(event or Event("", prep.word.i, prep.word.j, ""), entities, [])
    circulate = any("circulates" in e.told for e in led)
    follows = prep.value == "behind" and not circulate and holds("gets_in_line", clause, context)
    moves = event is not None and event.name not in word_list("steady")
    if moves and prep.outer != "from" and not follows:
        afoot = [e for e in entities if prep.value == "behind" and not e.is_vehicle]
        for entity in afoot if any(e.ego for e in led) else []:  # "crosses behind the ego": there
            context.draft.place(entity, None, {Approach.BEHIND}, basis)
        return
    out_of = prep.outer == "from" and isinstance(target, Mention)
    aside = prep.value in {"behind", "ahead"} and holds("goes_past", clause, context)
    leads = prep.value == "ahead" and holds("leads_there", clause, context)
    if out_of or (event is not None and target and (aside or leads)):
        return
    hidden = event is not None and event.name == "hide" and all(e.is_vehicle for e in entities)
    approaches = _told(prep, context, hidden=hidden)
    reference = led[0] if led else None
    if isinstance(target, Mention) and reference is None:
        return
    if approaches == {Approach.ADJACENT} and any(e.parked for e in (*entities, *led[:1])):
        return  # "1 m beside the parked cars": they have no lane of their own
    same = holds("the_same_way", clause, context)
    for entity in entities:
        if entity.is_vehicle or prep.value != "ahead" or same:
            context.draft.place(entity, reference, approaches, basis)
    for other in led[1:] if len(entities) == 1 else []:
        context.draft.place(other, entities[0], {INVERSE[a] for a in approaches}, basis)


def _told(prep: Prep, context: Context, *, hidden: bool) -> set[Approach]:
    """From where one comes, or where one is: ``hidden`` behind one that is ahead, beyond it."""
    if prep.target is None and (prep.outer, prep.value) == ("from", "ahead"):
        return {Approach.OPPOSITE}
    who = prep.who.entities if prep.who is not None and prep.value == "behind" else []
    beyond = hidden and any(context.placed(e, Approach.AHEAD) for e in who)
    return {Approach.AHEAD if beyond else Approach(prep.value)}


def heading(term: Term, entities: list[Entity]) -> None:
    """``travelling northbound``, ``a northbound truck``."""
    for entity in entities:
        entity.bound = entity.bound or "bound" in term.data
        if entity.heading is None:
            entity.heading, entity.heading_basis = term.value, Basis(term.i, term.j)


_FEWEST = 2
_NUMBERS = ("first", "second", "third", "fourth", "fifth", "sixth")
_BRAKING = frozenset({"brake", "hard_brake", "stop", "slow"})
_UNTOLD = 99
"""Behind those whose place is told, before the last."""
_ELSEWHERE = {Approach.ADJACENT, Approach.OPPOSITE, Approach.LEFT, Approach.RIGHT}
_ORDERS = {"row": Approach.AHEAD, "abreast": Approach.ADJACENT}


def line_up(chunks: list[Chunk], events: list[Event], draft: Draft) -> None:
    """``three cars in a row``, ``two vans drive one behind the other``."""
    for chunk in chunks:
        if isinstance(chunk, Mention):
            members = [e for m in chain(chunk) for e in m.entities]
            _behind_each_other(chunk.mods, members, draft)
            _at_its_end(chunk, draft)
    for event in events:
        _behind_each_other(event.mods, event.doers, draft)
    told = _numbered(chunks, events) or _labelled(chunks, draft) or _counted(events, draft)
    apart = {p.entity.index for p in draft.placements if p.approaches & _ELSEWHERE}
    row = [e for e in draft.entities if e.moving_vehicle and e.index not in apart]
    last = [e for e in row if told.get(e.index, (0, None))[0] < 0]
    row = [e for e in row if last or (len(told) >= _FEWEST and e.index in told)]
    row.sort(key=lambda e: (e in last, told.get(e.index, (_UNTOLD, None))[0]))
    for leader, follower in combinations(row, 2):
        if (found := told.get(follower.index) or told.get(leader.index)) is not None:
            draft.place(leader, follower, {Approach.AHEAD}, found[1])
            follower.named_by.add("ranked")


def _counted(events: list[Event], draft: Draft) -> dict[int, tuple[int, Basis]]:
    """``three wait there, we are the last``: who is told together is in that order."""
    told: dict[int, tuple[int, Basis]] = {}
    for entity in [e for e in draft.entities if "ranked" in e.named_by]:
        if not any(e.name == "approach" and entity in e.doers for e in events):
            group = [e for e in draft.entities if e.basis == entity.basis]
            told |= {e.index: (at, e.basis) for at, e in enumerate(group)}
    return told


def _labelled(chunks: list[Chunk], draft: Draft) -> dict[int, tuple[int, Basis]]:
    """``bus first, ego second``, ``a van, a taxi, the VUT last``: one behind the other."""
    told = {}
    stated = [c for c in chunks if (c.cat, c.value) != ("aux", "be")]  # "the VUT is last"
    for place, label in pairwise(stated):
        who = place.entities if isinstance(place, Mention) else []
        at = POSITIONS.get(draft.tokens[label.i].low) if label.cat == "label" else None
        if at is not None and len(who) == 1 and "ranked" not in who[0].named_by:
            told[who[0].index] = at, Basis(label.i, label.j)
    return told


def _numbered(chunks: list[Chunk], events: list[Event]) -> dict[int, tuple[int, Basis]]:
    """``first van brakes, second stops, third (the ego) is late``: one behind the other."""
    numbered = [c for c in chunks if isinstance(c, Mention) and _ordinal(c) is not None]
    braking = [m for e in events if e.name in _BRAKING for m in e.subject if m in numbered]
    by_number = {_ordinal(m): m.entities[0] for m in reversed(numbered) if braking and m.entities}
    why = "they brake one after the other"
    order = {
        e.index: (at or 0, Basis(braking[0].i, braking[0].j, why)) for at, e in by_number.items()
    }
    return order if len(order) == len(by_number) else {}


def _at_its_end(mention: Mention, draft: Draft) -> None:
    """``the rear one`` of two: behind the other."""
    for which in [m for m in mention.mods if "in_file" in m.data]:
        place = {Approach.AHEAD if which.value == "first" else Approach.BEHIND}
        for entity, other in product(mention.entities, draft.entities):
            if other.basis == entity.basis:
                draft.place(entity, draft.ego and other, place, Basis(which.i, which.j))


def _ordinal(mention: Mention) -> int | None:
    return next((_NUMBERS.index(m.value) for m in mention.mods if m.value in _NUMBERS), None)


def before_in_row(mention: Mention, context: Context) -> list[Entity]:
    """``the second, 2 s behind``: behind the first."""
    people = [e for e in context.draft.entities if not e.ego]
    at = people.index(mention.entities[0]) if _ordinal(mention) else 0
    alike = at and people[at - 1].kind is people[at].kind
    return people[at - 1 : at] if alike else []


def _behind_each_other(mods: list[Term], entities: list[Entity], draft: Draft) -> None:
    said = next((m for m in mods if m.cat == "manner" and m.value in _ORDERS), None)
    said = said or _gathered(mods, draft)
    drivers = [e for e in entities if e.moving_vehicle]
    if said is None or len(drivers) < _FEWEST:
        return
    if [e.brakes_from is not None for e in drivers] == [False, True]:
        drivers.reverse()  # "V1 and V2 in line; V2 brakes": whoever follows has to answer
    for leader, follower in combinations(drivers, 2):
        draft.place(leader, follower, {_ORDERS[said.value]}, Basis(said.i, said.j))


def _gathered(mods: list[Term], draft: Draft) -> Term | None:
    """``a chain of three cars``: in a row."""
    for mod in mods:
        words = {t.low for t in draft.tokens[mod.i : mod.j]} if mod.cat == "quant" else set()
        if words & word_list("rows"):
            return replace(mod, value="row")
    return None
