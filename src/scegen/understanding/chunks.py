"""The pieces that clauses are made of: mentions, places, things, events, and single words."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, ClassVar, TypeAlias

from scegen.scenario.vocabulary import CrossedArm, ParticipantKind
from scegen.understanding.words.terms import Term


@dataclass(slots=True, eq=False)
class NounPhrase:
    """What all noun phrases share: a span, the words before the head, and who owns it."""

    cat: ClassVar[str] = ""
    value: ClassVar[str] = ""
    i: int
    j: int
    mods: list[Term]
    head: Term | None
    owner: Mention | None = None
    pps: list[Prep] = field(default_factory=list)
    prep: Term | None = None

    def mod(self, *cats: str) -> Term | None:
        """The first word before the head of one of these classes."""
        return next((m for m in self.mods if m.cat in cats), None)

    def has(self, cat: str, *values: str) -> bool:
        """Whether a word of a class, and of one of the values if any are given, is before it."""
        return any(m.cat == cat and (not values or m.value in values) for m in self.mods)

    @property
    def noun(self) -> str:
        """What the head says, if there is one."""
        return self.head.value if self.head is not None else ""

    @property
    def plural(self) -> bool:
        """Whether the head names several."""
        return self.head is not None and self.head.form == "s"

    @property
    def ways(self) -> list[Term]:
        """The words for directions before the head."""
        return [m for m in self.mods if m.cat == "dir"]

    @property
    def opening(self) -> str:
        """Which preposition governs it; empty where none does."""
        return self.prep.value if self.prep is not None else ""

    @property
    def owned_by(self) -> list[Any]:
        """Whose it is: those whom its owner means."""
        return list(self.owner.entities) if self.owner is not None else []

    def opened_by(self, value: str) -> bool:
        """Whether its first word is of that value ("def": the article)."""
        return bool(self.mods) and self.mods[0].value == value

    def stands_after(self, *words: str) -> bool:
        """Whether one of these prepositions governs it."""
        return self.opening in words

    @property
    def dirs(self) -> list[str]:
        """Directions named before the head."""
        own = [self.head.data["dir"]] if self.head is not None and "dir" in self.head.data else []
        return [*(m.value for m in self.ways), *own]


@dataclass(slots=True, eq=False)
class Mention(NounPhrase):
    """Words that refer to participants.

    Attributes:
        heads: all nouns of a compound ("ego vehicle"), the last is ``head``.
        pronoun: which pronoun it is, if it is one.
        label: a name such as ``#1`` for "vehicle 1".
        marks: what clauses say of it, in the words of `reference.describing`.
        label_at: index of the token that holds the label.
        possessor: it only says whose something is.
        joined: the mention that it is joined to by "and".
        same_as: the mention that it describes further ("vehicle 1, a sedan, …").
        listed: one of those who were counted before ("two cars, a taxi and a van").
        whole: the set, named after it, of which it is a part ("one of the cars").
        ranked: who has which place among them ("fifth in a row of eight cars"), counted from 0.
        aside: somebody is on one side of it ("on the right of the ego").
        goes_by: how somebody moves who is no vehicle ("the claimant was cycling").
        negated: there is none ("no pedestrians").
        sides: it, or what it does, is said to come from there ("the one from the left").
        denied: it does not do what its verb says ("neither the bus nor the taxi").
        entities: whom it refers to, filled in by the discourse.
    """

    heads: list[Term] = field(default_factory=list)
    pronoun: str | None = None
    label: str | None = None
    marks: set[str] = field(default_factory=set)
    label_at: int | None = None
    possessor: bool = False
    joined: Mention | None = None
    same_as: Mention | None = None
    listed: bool = False
    whole: Mention | None = None
    ranked: tuple[Mention, int] | None = None
    aside: bool = False
    goes_by: ParticipantKind | None = None
    negated: bool = False
    denied: bool = False
    sides: frozenset[str] = frozenset()
    entities: list[Any] = field(default_factory=list)

    @property
    def is_ego(self) -> bool:
        """Whether it names the vehicle under test."""
        return any(h.data.get("ego") for h in self.heads)

    @property
    def is_named(self) -> bool:
        """Whether it has a name of its own ("vehicle 1")."""
        return self.label is not None and self.label.startswith("#")

    @property
    def is_me(self) -> bool:
        """Whether it is "me" or "us"."""
        return any("me" in h.data for h in self.heads)

    @property
    def is_mass(self) -> bool:
        """Whether it names many as one ("traffic", "a jam")."""
        return self.head is not None and "mass" in self.head.data


@dataclass(slots=True, eq=False)
class Place(NounPhrase):
    """A place: a lane, a side, a junction, a sign; ``beside`` whom it lies, if that is said.

    ``arm``: for its ``user``, the road by which that one comes to the junction or leaves it.
    """

    kind: str = "side"
    beside: Mention | None = None
    arm: CrossedArm | None = None
    user: Mention | None = None


@dataclass(slots=True, eq=False)
class Thing(NounPhrase):
    """Anything else that a noun phrase names."""

    kind: str = "noun"

    @property
    def lies_there(self) -> bool:
        """Whether it is something that may be in a lane: a fallen tree, a crate."""
        return self.kind in {"object", "obstacle"}


@dataclass(slots=True, eq=False)
class Event:
    """A verb, or a noun that names an action, with who does it to whom.

    Attributes:
        name: the event, a ``value`` of the lexicon's verbs.
        form: inflection: ``base``, ``s``, ``ed``, ``ing``.
        lemma: base form of its first word; a verb that is left out ("another in the next lane")
            has that of the verb it repeats.
        nominal: it stands as a noun ("a left turn").
        finite: it makes a clause of its own.
        mods: words before a nominal event; adverbs around a verb are added to them.
        control: ``object`` or ``subject`` for verbs that take another verb.
        subject: who does it.
        object: what it is done to.
        pps: prepositional phrases that belong to it.
        parent: the verb on which it depends ("tries" in "tries to merge").
        data: what else the lexicon says of it: only vehicles do it, it tells what somebody says.
        embedded: it makes a clause that describes a noun ("a spot where two cars stand").
        supplement: it is told besides of a noun, between commas ("the ego, which brakes").
        link: how it hangs on its parent: ``inf``, ``ing`` or ``noun``.
        reduced: it only describes its noun ("a man hidden behind a van runs out").
        unable: it does not take place because it cannot ("could not stop").
        perfect: it is over ("had slowed").
        late: it comes too late for the one in front ("failed to stop and hit its rear").
        modal: obliged, forced or reacting ("must stop", "causing it to stop").
        denied_ways: where it does not lead ("turns neither left nor right").
    """

    cat: ClassVar[str] = ""
    value: ClassVar[str] = ""
    name: str
    i: int
    j: int
    form: str
    lemma: str = ""
    control: str | None = None
    nominal: bool = False
    finite: bool = False
    passive: bool = False
    reduced: bool = False
    negated: bool = False
    unable: bool = False
    perfect: bool = False
    modal: bool = False
    late: bool = False
    mods: list[Term] = field(default_factory=list)
    subject: list[Mention] = field(default_factory=list)
    object: NounPhrase | None = None
    pps: list[Prep] = field(default_factory=list)
    parent: Event | None = None
    link: str | None = None
    children: list[Event] = field(default_factory=list)
    alternative: int | None = None
    data: dict[str, Any] = field(default_factory=dict)
    embedded: bool = False
    supplement: bool = False
    sentence: int = 0
    premod_of: Mention | None = None
    denied_ways: set[str] = field(default_factory=set)

    @property
    def dirs(self) -> list[Term]:
        """Direction words that belong to the event."""
        return [m for m in self.mods if m.cat == "dir"]

    def nouns(self, *prepositions: str) -> list[NounPhrase | Event]:
        """Its object, and what its phrases name; of some prepositions, where these are given."""
        named = [p.target for p in self.pps if not prepositions or p.value in prepositions]
        return [n for n in (self.object, *named) if n is not None]

    def whom(self, *prepositions: str) -> list[Any]:
        """Whom its phrases with these prepositions name."""
        return [e for p in self.pps if p.value in prepositions and p.who for e in p.who.entities]

    def upwards(self) -> Iterator[Event]:
        """It, and the verbs on which it hangs, one after the other: three of them at most."""
        node: Event | None = self
        for _ in range(4):
            if node is not None:
                yield node
                node = node.parent

    @property
    def doers(self) -> list[Any]:
        """The participants that its subject refers to."""
        return [e for m in self.subject for e in m.entities]

    def how(self, *values: str) -> Term | None:
        """The first word of manner with one of these values, here or on the verbs above."""
        for event in self.upwards():
            term = next((m for m in event.mods if m.cat == "manner" and m.value in values), None)
            if term is not None or event.parent is None or event.parent.control != "subject":
                return term
        return None


@dataclass(slots=True, eq=False)
class Prep:
    """A prepositional phrase: the preposition (or "behind", "ahead of") and what follows it.

    Attributes:
        word: the preposition.
        target: what it governs; None for "the car ahead".
        outer: a preposition before it ("from behind").
        on_mention: the mention right before it, if one stands there.
        fronted: it opens its clause and places who comes after it ("behind me a van brakes").
        predicate: it tells where somebody known is ("the van is behind a bus"), not which one.
    """

    word: Term
    target: NounPhrase | Event | None = None
    outer: str | None = None
    on_mention: Mention | None = None
    fronted: bool = False
    predicate: bool = False

    @property
    def value(self) -> str:
        """Which preposition."""
        return self.word.value

    @property
    def place(self) -> Place | None:
        """The place that it governs, if it is one."""
        return self.target if isinstance(self.target, Place) else None

    def names(self, *kinds: str) -> bool:
        """Whether it governs a place of one of these kinds."""
        return self.place is not None and self.place.kind in kinds

    @property
    def who(self) -> Mention | None:
        """Those whom it governs, if it is somebody."""
        return self.target if isinstance(self.target, Mention) else None


Chunk: TypeAlias = Term | Mention | Place | Thing | Event
