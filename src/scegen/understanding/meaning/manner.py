"""How fast, which way and in which manner somebody drives, by words beside a noun or a verb."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ON_FOOT, Approach, HazardKind, ParticipantKind
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Numbers
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
_RUNNING_MPS = 8.0
"""What nobody on foot or on a bicycle outruns in traffic."""
_BY_MUSCLE = ON_FOOT | {ParticipantKind.BICYCLE}
_COMING = frozenset({"move", "approach", "enter", "speed", "accelerate", "collide", "overtake"})
_TRAVEL = frozenset({"move", "approach", "enter", "merge", "turn", "cross", "follow", "overtake",
                     "bypass", "leave", "lane_change", "accelerate", "speed", "try"})  # fmt: skip


class Manners:
    """Notes what words of manner, measure and state say.

    Args:
        context: the scenario in the making.
        numbers: the numbers of the text.
        of_the_road: quantities that are a speed limit and the like, and nobody's.
    """

    def __init__(self, context: Context, numbers: Numbers, of_the_road: Collection[Term]) -> None:
        self._context = context
        self._draft = context.draft
        self._numbers = numbers
        self._of_the_road = of_the_road

    def word(self, term: Term, entities: list[Entity]) -> None:
        """``a slow van``, ``a parked car``, ``a truck at 80 km/h``."""
        drivers = [e for e in entities if e.moving_vehicle]
        kind = _BY_MANNER.get(term.value) if term.cat == "manner" else None
        measured = "quantity" in term.data
        slow = kind is HazardKind.SLOW_DRIVING
        if slow:  # the ego under test may drive as slowly as it likes
            drivers = [e for e in drivers if "ego" not in e.named_by or "speaks" in e.named_by]
        own = slow and measured and all(e.ego for e in drivers)  # "I was only doing 25 km/h"
        if kind is not None and drivers:
            if not own:
                self._draft.hazard(kind, Basis(term.i, term.j), drivers)
            if measured:
                self._quantity(replace(term, cat="quantity", value="speed"), drivers)
        elif term.cat == "manner" and term.value == "close":
            follows = [e for e in drivers if self._context.placed(e, Approach.BEHIND)]
            if follows:
                self._draft.hazard(HazardKind.TAILGATING, Basis(term.i, term.j), follows)
        elif term.cat == "quantity":
            self._quantity(term, entities)
        elif term.cat == "state":
            standing.state(term, entities, self._context)

    def _quantity(
        self, term: Term, entities: list[Entity], verb: str = "", *, others: bool = False
    ) -> None:
        """A speed of some; it may be ``others``, if it stands right after somebody else."""
        quantity = term.data["quantity"]
        if quantity is None or any(term is r for r in self._of_the_road):
            return
        if self._numbers.measured(quantity, verb).frame.role != "speed":
            return
        for entity in entities:
            fastest = BODIES[entity.kind].top_speed_mps
            if others and entity.kind in _BY_MUSCLE:
                fastest = min(fastest, _RUNNING_MPS)
            outrun = quantity.value.low > fastest
            if not entity.parked and entity.speed is None and not outrun:
                entity.speed = quantity.value
                entity.speed_basis = Basis(term.i, term.j, quantity.note)

    def verb(self, clause: Clause) -> None:
        """``drives northbound at 50 km/h``, ``approaches head-on``, ``backs out slowly``."""
        event = clause.event
        travels = event.name in _TRAVEL
        for term in event.mods:
            if term.cat == "quantity":
                ahead_of = [p.target for p in event.pps if p.value == "ahead"]
                # "runs across in front of the ego at 50 km/h"
                after = any(t is not None and t.j + 1 == term.i for t in ahead_of)
                self._quantity(term, clause.actors, event.name, others=after)
            elif term.cat == "compass":
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
