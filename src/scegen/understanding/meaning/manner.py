"""Which way and in which manner somebody drives, by words beside a noun or a verb."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.meaning import placing, standing
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.words.terms import Term

_BY_MANNER = {
    "backwards": HazardKind.REVERSING,
    "fast": HazardKind.SPEEDING,
    "slow": HazardKind.SLOW_DRIVING,
    "wrong_way": HazardKind.ONCOMING_LANE,
    "out_of_control": HazardKind.LOSS_OF_CONTROL,
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
            standing.state(term, entities, self._context)

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
            if term.cat == "manner" and term.value in _BY_MANNER and not slows:
                self.word(term, clause.drivers)

    def _meet_head_on(self, term: Term, clause: Clause) -> None:
        """``a motorcycle approaches head-on``: who collides so has come from the front, too."""
        if len(clause.drivers) > 1 and not clause.targets:
            for entity in clause.drivers:
                entity.opposed |= {e.index for e in clause.drivers} - {entity.index}
            return  # "two trucks meet head-on"
        for entity in clause.drivers if clause.event.name in _COMING else []:
            to = next((e for e in clause.targets if e.moving_vehicle), None)
            self._draft.place(entity, to, {Approach.OPPOSITE}, Basis(term.i, term.j))
