"""Who stands by a word of state, or in a jam; and who brakes, so that it does not stand before."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind
from scegen.understanding.chunks import Event, Mention
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.semantics.conditions import condition
from scegen.understanding.semantics.context import Context
from scegen.understanding.semantics.marks import comes_to_rest, in_the_lane
from scegen.understanding.semantics.roles import clause_of
from scegen.understanding.words.terms import Term


def note_braking(events: list[Event], context: Context) -> None:
    """``brakes hard; once it stands …``: it does not stand from the start."""
    slows = condition("slows_now")
    for clause in map(clause_of, events):
        for entity in clause.drivers if slows(clause, context) else []:
            at = clause.event.i if entity.brakes_from is None else entity.brakes_from
            entity.brakes_from = at


def jam(mention: Mention, context: Context) -> None:
    """``the end of a jam``: it stands, unless the text lets it move."""
    if mention.head is not None and mention.head.data.get("stands"):
        others = [e for e in mention.entities if not e.ego]
        state(Term("state", "stationary", mention.i, mention.j), others, context)


def state(term: Term, entities: list[Entity], context: Context) -> None:
    """``a stationary car``, ``a parked van``: in the lane, or beside it."""
    basis = Basis(term.i, term.j)
    if term.value == "stationary":
        for entity in entities:
            comes_to_rest(entity, basis)
        entities = [e for e in entities if basis not in e.rests]
        drivers = [e for e in entities if e.moving_vehicle and not e.ego]
        if drivers:
            kind = HazardKind.OBSTACLE if term.data.get("broken") else HazardKind.STOPPING
            context.draft.hazard(kind, basis, drivers)
        for entity in entities:
            if entity.ego:
                in_the_lane(entity, basis)
            entity.stands = entity.stands or basis
    elif term.value == "parked":
        others = [e for e in entities if not e.ego]
        for entity in others:
            if entity.is_vehicle and entity.sets_off < 0:
                entity.parked, entity.parked_basis = True, basis
        if term.data.get("in_lane"):
            context.draft.hazard(HazardKind.OBSTACLE, basis, [e for e in others if e.parked])
