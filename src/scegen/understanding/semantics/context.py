"""The clause of one event with those in it, and the scenario in the making."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any

from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep
from scegen.understanding.clauses.dependents import chain
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.frames.windows import Window
from scegen.understanding.lexicon import word_list
from scegen.understanding.road.junctions import JunctionReading
from scegen.understanding.words.tokens import Token

_SPAN_REACH = 6
_ORDER_REACH = 3


@dataclass(slots=True)
class Clause:
    """One event with the participants in it.

    Attributes:
        event: the event.
        actors: who acts, after passives are turned round.
        targets: whom it is done to.
        amounts: what numbers say of it, by the field (SI units); None where one is not told.
        around: the words around the number that it is, if it is one.
        cues: its cues, once they are known (`semantics.cues`).
    """

    event: Event
    actors: list[Entity]
    targets: list[Entity]
    amounts: dict[str, list[Interval | None]] = field(default_factory=dict)
    around: Window | None = None
    cues: frozenset[str] | None = field(default=None, init=False)

    @property
    def drivers(self) -> list[Entity]:
        """Actors that drive."""
        return [e for e in self.actors if e.moving_vehicle]

    @property
    def alternative(self) -> int | None:
        """Marks events that the text offers as alternatives ("either … or …")."""
        told = (e.alternative for e in self.event.upwards() if e.alternative is not None)
        return next(told, None)

    @property
    def tells_parked(self) -> bool:
        """It only says that somebody is parked ("a van parked, or standing, on the right")."""
        event = self.event
        told_of = event.form != "base" and (event.embedded or not event.finite)
        rests = told_of and event.name in {"wait", "stop"}
        return (event.name, event.form) == ("park", "ed") or rests

    def how(self, *values: str) -> Basis | None:
        """Words of manner of the event, joined with the event if they are close."""
        term = self.event.how(*values)
        return span(self.event, term.i, term.j) if term is not None else None

    @property
    def words(self) -> Basis:
        """The words of the event itself."""
        return Basis(self.event.i, self.event.j)

    def places(self) -> list[Place]:
        """Places named with the event."""
        return [p for p in self.event.nouns() if isinstance(p, Place)]


def span(event: Event, i: int, j: int) -> Basis:
    """The event's words together with further words, or these alone if they are far away."""
    start, end = min(event.i, i), max(event.j, j)
    if end - start > _SPAN_REACH + (event.j - event.i):
        return Basis(i, j)
    return Basis(start, end)


_FILES = ({Approach.AHEAD}, {Approach.BEHIND})


@dataclass(slots=True)
class Context:
    """The scenario in the making, as the rules of meaning see it."""

    draft: Draft
    junction: JunctionReading
    tokens: list[Token]
    across: str = "left"
    """The side of a turn across oncoming traffic: right where traffic keeps left."""
    told_in_the_past: bool = False
    """Whether the text tells in the past tense, so that "stopped" is something that happened."""
    screens: list[int] = field(default_factory=list)
    """Where in the text things are named that one cannot see through."""
    acts: list[Any] = field(default_factory=list)
    """What is done, as rows tell it."""
    letting: list[Entity] = field(default_factory=list)
    """Those who let somebody by."""
    barred: bool = False
    """Whether a thing is in the way, or the text tells of getting past."""
    words: list[str] = field(init=False)

    def __post_init__(self) -> None:
        self.words = [token.low for token in self.tokens]

    def lows(self, i: int, j: int) -> list[str]:
        """The words from one token to before another."""
        return self.words[max(i, 0) : max(j, 0)]

    @property
    def meeting(self) -> bool:
        """Whether roads meet, as the text says or implies so far."""
        return self.junction.crossing or "crossing" in self.draft.implied

    def ahead(self, front: list[Entity], back: list[Entity], basis: Basis) -> None:
        """The first drive ahead of the second."""
        for leader in front:
            for follower in back[:1]:
                self.draft.place(leader, follower, {Approach.AHEAD}, basis)

    def placed(self, entity: Entity, approach: Approach) -> bool:
        """Whether a participant is said to be, or to come from, somewhere."""
        return any(approach in p.approaches for p in self.draft.placements_of(entity))

    def oncoming(self, entity: Entity) -> bool:
        """Whether a vehicle comes from the front, or on a road in one file with one that does."""
        files = (p for p in self.draft.placements if p.approaches in _FILES and not self.meeting)
        pairs = [(p.entity, p.reference) for p in files if entity in (p.entity, p.reference)]
        near = {e for pair in [(entity, None), *pairs] for e in pair if e is not None}
        return any(self.placed(e, Approach.OPPOSITE) for e in near)

    def from_the_side(self, entity: Entity) -> bool:
        """Who comes from a road at the side does not turn across oncoming traffic."""
        return self.placed(entity, Approach.LEFT) or self.placed(entity, Approach.RIGHT)

    def in_order(self, earlier: Basis | None, event: Event) -> bool:
        """Whether words of order stand between, or right before, two things that one does."""
        if earlier is None or earlier.i is None or event.i <= earlier.i:
            return False
        between = self.lows(earlier.i - _ORDER_REACH, event.i)
        return not word_list("order").isdisjoint(between)

    def comes_across(self, entity: Entity) -> bool:
        """Whether a vehicle comes from another arm of a junction than the ego."""
        across = {Approach.LEFT, Approach.RIGHT, Approach.OPPOSITE}
        named = self.draft.placements_of(entity)
        lateral = {Approach.LEFT, Approach.RIGHT}
        met = self.meeting or "side_road" in self.draft.implied
        met = met or any(p.approaches == lateral for p in named)  # "on perpendicular roads"
        return met and any(p.approaches & across for p in named)


def clause_of(event: Event) -> Clause:
    """Who acts in an event, and on whom, passives turned round."""
    actors = [e for m in event.subject for e in m.entities]
    direct = event.object
    targets = [e for m in chain(direct) for e in m.entities] if isinstance(direct, Mention) else []
    if event.passive:
        # "is passed by a bus": the verb has taken the "by"
        agents = event.whom("by") or targets
        return Clause(event, actors, []) if event.name == "hide" else Clause(event, agents, actors)
    if not targets and event.name in {"yield", "merge", "follow", "collide"}:
        targets = event.whom("to", "with", "in", "into", "against")
    return Clause(event, actors, [e for e in targets if e not in actors])


def clause_of_noun(noun: Mention) -> Clause:
    """``a van from the left``: what the phrases after a noun say of it, a clause without a verb."""
    event = Event("", noun.i, noun.j, "", mods=noun.mods, subject=[noun], pps=noun.pps)
    event.negated = noun.negated
    return Clause(event, list(noun.entities), [])


def without_nouns(clause: Clause) -> Clause:
    """The clause without the phrases that say of one on whom it is done where that one is."""
    event = clause.event
    own = [
        p
        for p in event.pps
        if p.on_mention is None or p.on_mention.is_ego or p.on_mention in event.subject
    ]
    same = len(own) == len(event.pps)
    return clause if same else replace(clause, event=replace(event, pps=own))


def stray_clauses(chunks: list[Chunk], clauses: list[Clause]) -> Iterator[Clause]:
    """Phrases of place that belong to no noun or verb which names anybody.

    ``At a stop sign, the ego …`` says it of the noun that follows, ``its way round the van`` of
    whose way it is; of others nobody is named.
    """
    taken = [p for c in clauses if c.actors for p in c.places()]
    for k, noun in enumerate(chunks):
        before, after = chunks[max(0, k - 3) : k], chunks[k + 1 : k + 3]
        if not isinstance(noun, NounPhrase) or noun.prep is None:
            continue
        ways = [c for c in before[-3:] if isinstance(c, Place) and c.kind == "path"]
        if ways:
            who = ways[-1].owner
        elif not isinstance(noun, Place) or any(
            p is noun or (p.i < noun.i < p.j and noun.opening == "in") for p in taken
        ):
            continue
        else:
            opens = all(c.cat == "punct" for c in before[-2:-1])
            heads = [c for c in after if c.value != ","][:1] if opens else []
            who = next((c for c in heads if isinstance(c, Mention)), None)
        event = Event("", noun.prep.i, noun.j, "", pps=[Prep(noun.prep, noun)])
        yield Clause(event, list(who.entities) if who is not None else [], [])
