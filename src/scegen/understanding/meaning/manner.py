"""Which way, in which manner and in which state somebody drives or stands, by words beside it."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind
from scegen.understanding.chunks import Event, Mention
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.meaning import placing
from scegen.understanding.semantics.conditions import holds
from scegen.understanding.semantics.context import Clause, Context, clause_of
from scegen.understanding.semantics.marks import comes_to_rest, in_the_lane
from scegen.understanding.words.terms import Term


def note_braking(events: list[Event], context: Context) -> None:
    """``brakes hard; once it stands …``: it does not stand from the start."""
    for clause in map(clause_of, events):
        for entity in clause.drivers if holds("slows_now", clause, context) else []:
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


_BY_MANNER = {
    "backwards": HazardKind.REVERSING,
    "fast": HazardKind.SPEEDING,
    "slow": HazardKind.SLOW_DRIVING,
    "wrong_way": HazardKind.ONCOMING_LANE,
    "out_of_control": HazardKind.LOSS_OF_CONTROL,
    "out_of_turn": HazardKind.FAILURE_TO_YIELD,
}
_COMING = frozenset({"move", "approach", "appear", "enter", "speed", "accelerate", "collide",
                     "overtake"})  # fmt: skip
_TRAVEL = frozenset({"move", "approach", "enter", "merge", "turn", "cross", "follow", "overtake",
                     "bypass", "leave", "lane_change", "accelerate", "speed", "try"})  # fmt: skip


class Manners:
    """Notes what words of manner and state say."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._draft = context.draft

    def word(self, term: Term, entities: list[Entity]) -> None:
        """``a slow van``, ``a parked car``."""
        drivers = [e for e in entities if e.moving_vehicle]
        kind = _BY_MANNER.get(term.value) if term.cat == "manner" else None
        slow = kind is HazardKind.SLOW_DRIVING
        if slow:  # the ego under test may drive as slowly as it likes
            drivers = [e for e in drivers if "ego" not in e.named_by or "speaks" in e.named_by]
        own = (
            slow and "quantity" in term.data and all(e.ego for e in drivers)
        )  # "I was only doing 25 km/h"
        if kind is not None and drivers and not own:
            self._draft.hazard(kind, Basis(term.i, term.j), drivers)
        elif term.cat == "manner" and term.value == "close":
            follows = [e for e in drivers if self._context.placed(e, Approach.BEHIND)]
            if follows:
                self._draft.hazard(HazardKind.TAILGATING, Basis(term.i, term.j), follows)
        elif term.cat == "state":
            state(term, entities, self._context)

    def verb(self, clause: Clause) -> None:
        """``drives northbound``, ``approaches head-on``, ``backs out slowly``."""
        event = clause.event
        travels = event.name in _TRAVEL
        for term in event.mods:
            if term.cat == "compass":
                placing.heading(term, clause.actors)
            elif (term.cat, term.value) == ("dir", "opposite") and travels:
                for entity in clause.drivers:
                    self._draft.place(entity, None, {Approach.OPPOSITE}, Basis(term.i, term.j))
            elif term.cat == "state":
                self.word(term, clause.actors)
            elif (term.cat, term.value) == ("manner", "head_on"):
                self._meet_head_on(term, clause)
        for term in event.mods if travels or not event.nominal else []:
            slows = term.value == "slow" and (clause.reaction or not travels)  # "brakes slowly"
            aside = term.value == "wrong_way" and any(p.names("sidewalk") for p in event.pps)
            if term.cat == "manner" and term.value in _BY_MANNER and not (slows or aside):
                self.word(term, clause.drivers)

    def _meet_head_on(self, term: Term, clause: Clause) -> None:
        """``a motorcycle approaches head-on``: who collides so has come from the front, too."""
        several = len(clause.drivers) > 1 and not clause.targets  # "two trucks meet head-on"
        whom = clause.drivers[:1] if several else clause.targets
        for entity in clause.drivers if several or clause.event.name in _COMING else []:
            to = next((e for e in whom if e.moving_vehicle), None)
            self._draft.place(entity, to, {Approach.OPPOSITE}, Basis(term.i, term.j))
