"""Applies the rules of meaning to the events of a text, in their order."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ON_FOOT, Approach, HazardKind, ParticipantKind
from scegen.understanding.chunks import Chunk, Event, Mention, Prep, Thing
from scegen.understanding.clauses import bearing
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Numbers
from scegen.understanding.meaning import (
    crossed_arms,
    on_strips,
    rows,
    screen_sides,
    side_roads,
    standing,
)
from scegen.understanding.meaning.lights import read_lights
from scegen.understanding.meaning.movements import follow_movement
from scegen.understanding.meaning.out_of_turn import out_of_turn
from scegen.understanding.meaning.placing import Placer
from scegen.understanding.meaning.reactions import mark_answers, mark_late
from scegen.understanding.meaning.roadside import read_thing
from scegen.understanding.phrases.on_sides import from_everywhere
from scegen.understanding.semantics import numbered_lanes
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.roles import (
    clause_of,
    clause_of_everybody,
    clause_of_noun,
    stray_clauses,
    without_nouns,
)
from scegen.understanding.semantics.rows import say
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
_BESIDE = frozenset({"overtake", "pass", "bypass", "undertake", "collide"})
"""With these verbs a side is where one gets past or is hit, and nobody comes from there."""
_ANSWERS = frozenset({"brake", "hard_brake", "stop", "slow", "yield", "wait"})
_INTO_LANES = frozenset({"lane_change", "cut_in", "merge", "cut_off"})
_UNDERWAY = frozenset({"overtake", "bypass", "pass", "cut_in", "cut_off", "approach", "cross",
                       "merge", "enter", "follow", "move", "turn", "appear", "swerve",
                       "pull_out", "collide"})  # fmt: skip
_COMING = frozenset({"move", "approach", "enter", "speed", "accelerate", "collide", "overtake"})
_PASSING = frozenset({"bypass", "overtake", "block"})
_TRAVEL = frozenset({"move", "approach", "enter", "merge", "turn", "cross", "follow", "overtake",
                     "bypass", "leave", "lane_change", "accelerate", "speed", "try"})  # fmt: skip


class Interpreter:
    """Turns events and mentions into statements about the scenario.

    Args:
        context: the scenario in the making.
        numbers: the numbers of the text.
        of_the_road: quantities that are a speed limit and the like, and nobody's.
    """

    def __init__(self, context: Context, numbers: Numbers, of_the_road: Collection[Term]) -> None:
        self._context = context
        self._draft = context.draft
        self._placer = Placer(context.draft)
        self._numbers = numbers
        self._of_the_road = of_the_road
        self._clauses: list[Clause] = []
        self._of_verbs: set[int] = set()
        self._chunks: list[Chunk] = []

    def run(self, chunks: list[Chunk], events: list[Event]) -> list[Clause]:
        """All statements of a text.

        Args:
            chunks: its chunks, mentions resolved.
            events: its events.

        Returns:
            What happens, in the order of the text.
        """
        self._chunks = chunks
        self._of_verbs = {
            id(p)
            for e in events
            for p in e.pps
            if p.on_mention is e.object
            and (
                self._starts(e, p)
                or (e.name in _BESIDE and bearing.is_side(p))
                or bearing.own_lane(e, p)
            )
        }
        self._context.told_in_the_past = any(
            e.finite and e.form == "ed" and e.name != "stop" for e in events
        )
        told = [clause_of(e) for e in events]
        for clause in told:
            say("movements.sets_off", clause, self._context)
        standing.note_braking(events, self._context)
        numbered_lanes.note_lanes(chunks, events, self._context.tokens, self._context.draft)
        handled = {
            id(e.object) for e in events if e.name in {"inert", "send"} and not e.passive
        }  # "kicks a ball"
        acting = {id(m) for e in events for m in e.subject if e.name not in {"hide", "collide"}}
        for chunk in chunks:
            if isinstance(chunk, Mention) and chunk.entities:
                self._mention(chunk)
                if id(chunk) not in acting:
                    standing.jam(chunk, self._context)
                    say("nouns.idle", clause_of_noun(chunk), self._context)
            elif isinstance(chunk, Thing) and id(chunk) not in handled:
                read_thing(chunk, chunks, self._draft)
                self._context.screens += [chunk.i] if chunk.kind == "object" else []
                self._context.barred |= chunk.kind in {"object", "obstacle"}
        mark_answers(events)
        mark_late(events, self._context)
        rows.line_up(chunks, events, self._draft)
        for clause in told:
            self._event(clause)
        self._all_told(chunks, events)
        return self._clauses

    def _all_told(self, chunks: list[Chunk], events: list[Event]) -> None:
        """What follows once everything that happens is known."""
        read_lights(self._clauses, chunks, self._context)
        out_of_turn(chunks, events, self._context)
        nouns = [clause_of_noun(c) for c in chunks if isinstance(c, Mention)]
        screen_sides.share(chunks, [*self._clauses, *nouns], self._context)
        everybody = clause_of_everybody(self._draft.entities)
        for clause in (*nouns, *self._clauses):
            say("nouns.hidden", clause, self._context)
        self._context.barred |= any(c.event.name in _PASSING for c in self._clauses)
        strays = list(stray_clauses(chunks, [*nouns, *self._clauses]))
        for clause in (everybody, *self._clauses, *nouns, *strays):
            say("nouns.past", clause, self._context)
        for clause in self._clauses:
            say("positions.first", clause, self._context)
        for clause in self._clauses:
            say("positions.any", clause, self._context)
            say("positions.up_to", clause, self._context)
        say("positions.after_all", everybody, self._context)
        on_strips.on_strips(chunks, self._clauses, self._context)
        for clause in (*nouns, *strays, *map(without_nouns, self._clauses)):
            say("nouns.place", clause, self._context)
        say("nouns.text", everybody, self._context)
        for clause in strays:
            say("nouns.stray", clause, self._context)
        crossed_arms.note_arms(chunks, self._clauses, self._context)

    def _mention(self, mention: Mention) -> None:
        self._placer.adjectives(mention)
        clause = clause_of_noun(mention)
        say("nouns.noun", clause, self._context)
        sides = [p for p in mention.pps if p.value in {"from", "in"} and bearing.is_side(p)]
        for prep in mention.pps:
            if id(prep) in self._of_verbs:
                continue  # "approaches the ego from the left": not the ego comes from there
            shared = len(sides) == len(mention.entities) > 1 and prep in sides
            whom = [mention.entities[sides.index(prep)]] if shared else mention.entities
            self._placer.phrase(prep, whom, None)
        for term in mention.mods:
            self._quality(term, mention.entities)
        say("nouns.named", clause, self._context)

    def _quality(self, term: Term, entities: list[Entity]) -> None:
        basis = Basis(term.i, term.j)
        drivers = [e for e in entities if e.moving_vehicle]
        kind = _BY_MANNER.get(term.value) if term.cat == "manner" else None
        if kind is HazardKind.SLOW_DRIVING:  # the ego under test may drive as slowly as it likes
            drivers = [e for e in drivers if "ego" not in e.named_by or "speaks" in e.named_by]
        own = all(e.ego for e in drivers) and "quantity" in term.data  # "I was only doing 25 km/h"
        if kind is not None and drivers:
            if not (own and kind is HazardKind.SLOW_DRIVING):
                self._draft.hazard(kind, basis, drivers)
            if "quantity" in term.data:
                self._quantity(replace(term, cat="quantity", value="speed"), drivers)
        elif term.cat == "manner" and term.value == "close":
            follows = [e for e in drivers if self._context.placed(e, Approach.BEHIND)]
            if follows:
                self._draft.hazard(HazardKind.TAILGATING, basis, follows)
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

    def _event(self, clause: Clause) -> None:
        event = clause.event
        say("dangers.move_off", clause, self._context)
        self._told_again(clause)
        say("constructions.any", clause, self._context)
        self._clauses.append(clause)
        standing.stand(clause, self._context)
        self._places(clause)
        side_roads.access(clause, self._context)
        failed = event.parent is not None and event.parent.name == "fail"
        if event.name in _ANSWERS:
            say("dangers.answered", clause, self._context)
        if event.negated or failed or event.name == "overlook":
            say("omissions.any", clause, self._context)
            return
        say("dangers.unnamed", clause, self._context)
        say("dangers.drives_on", clause, self._context)
        self._manner(clause)
        follow_movement(clause, self._context)
        say("dangers.onto_the_road", clause, self._context)
        say("dangers.after_a_thing", clause, self._context)
        if not self._overruled(clause):
            say(f"dangers.{event.name}", clause, self._context)
        say("dangers.oncoming", clause, self._context)
        say("dangers.from_behind", clause, self._context)

    def _places(self, clause: Clause) -> None:
        """Where the phrases of a verb put those who act, or on whom it is done."""
        event = clause.event
        side_roads.met_from_the_side(clause, self._context)
        for prep in event.pps if not self._ended(event) else []:
            if from_everywhere(prep):
                side_roads.spread(prep, clause.actors, self._context)
            elif self._from_behind_somebody(clause, prep):
                self._context.ahead(
                    clause.targets[:1], clause.actors, Basis(prep.word.i, prep.word.j)
                )
            elif prep.on_mention is None or self._starts(event, prep):
                turned = event.passive and event.name != "hide"
                turned = turned and prep.value not in {"behind", "from"}
                whom = clause.targets if turned else clause.actors
                self._placer.phrase(prep, whom, event)
                side_roads.side_road(prep, event, whom, self._context)

    def _told_again(self, clause: Clause) -> None:
        """``a van merges …, at the beginning of the lane change``: what the van does."""
        event = clause.event
        definite = any((m.cat, m.value) == ("det", "def") for m in event.mods)
        if not (event.nominal and definite and event.name in _INTO_LANES):
            return
        told = [s for s in self._clauses if s.event.name in _INTO_LANES and s.actors]
        if told and told[-1].actors != clause.actors:
            clause.actors = []

    def _ended(self, event: Event) -> bool:
        """``ends up in front of the ego``: where it gets to, not where it comes from."""
        word = event.lemma
        return event.name == "move" and word in {"end", "finish", "wind", "land"}

    def _meet_head_on(self, term: Term, clause: Clause) -> None:
        """``a motorcycle approaches head-on``: who collides so has come from the front, too."""
        if len(clause.drivers) > 1 and not clause.targets:
            for entity in clause.drivers:
                entity.opposed |= {e.index for e in clause.drivers} - {entity.index}
            return  # "two trucks meet head-on"
        for entity in clause.drivers if clause.event.name in _COMING else []:
            to = next((e for e in clause.targets if e.moving_vehicle), None)
            self._draft.place(entity, to, {Approach.OPPOSITE}, Basis(term.i, term.j))

    def _from_behind_somebody(self, clause: Clause, prep: Prep) -> bool:
        """``hits the van from behind``: behind the van."""
        behind = prep.outer == "from" and prep.value == "behind" and prep.target is None
        return behind and bool(clause.targets) and clause.event.name in _UNDERWAY

    def _starts(self, event: Event, prep: Prep) -> bool:
        """``overtakes the bus from the left`` says where the one who moves comes from.

        Verbs without a way of their own leave the phrase to the noun ("yields to a bus from …").
        """
        named = prep.on_mention
        target = named is not None and named not in event.subject
        moved = event.name in _UNDERWAY and (named is event.object or event.object is None)
        moved = moved and event.lemma != "meet"
        source = prep.value == "from" or (prep.outer == "from" and prep.target is None)
        return source and not (target and not moved)

    def _overruled(self, clause: Clause) -> bool:
        """``runs the red light`` is no walk."""
        return (
            clause.event.name == "walk"
            and not clause.walkers
            and any(p.kind in {"signal", "stop_sign"} for p in clause.places())
        )

    def _manner(self, clause: Clause) -> None:
        event = clause.event
        for term in event.mods:
            if term.cat == "quantity":
                after = any(
                    p.value == "ahead" and p.target is not None and p.target.j + 1 == term.i
                    for p in event.pps
                )  # "runs across in front of the ego at 50 km/h"
                self._quantity(term, clause.actors, event.name, others=after)
            elif term.cat == "compass":
                self._placer.heading(term, clause.actors)
            elif term.cat == "dir" and term.value == "opposite" and event.name in _TRAVEL:
                if self._ended(event):
                    continue
                for entity in clause.drivers:
                    basis = Basis(term.i, term.j)
                    self._draft.place(entity, None, {Approach.OPPOSITE}, basis)
            elif term.cat == "state":
                self._quality(term, clause.actors)
            elif (term.cat, term.value) == ("manner", "head_on"):
                self._meet_head_on(term, clause)
        if event.nominal and event.name not in _TRAVEL:
            return
        travels = event.name in _TRAVEL and not clause.reaction
        for term in event.mods:
            slows = term.value == "slow" and not travels  # "brakes slowly"
            if term.cat == "manner" and term.value in _BY_MANNER and not slows:
                self._quality(term, clause.drivers)
