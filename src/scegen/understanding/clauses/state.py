"""What the clause reader remembers within a sentence."""

from dataclasses import dataclass, field, replace

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Prep
from scegen.understanding.phrases.lookahead import chunk_at, finite_follows, sentence_end
from scegen.understanding.words.terms import Term


@dataclass(slots=True)
class State:
    """What the reader remembers within a sentence.

    Attributes:
        chunks: the chunks of the text.
        k: index of the chunk that is read.
        candidate: the mention that waits for, or has got, the verb of its clause.
        candidate_done: the candidate has a finite verb.
        main: subject of the last finite verb, kept over sentence ends for fragments.
        anchor: the last phrase outside prepositional phrases of place.
        between: classes and values of the words since the anchor.
        events: events of the sentence so far.
        pending: events before their subject ("Turning left, the car …").
        ahead: adverbs that wait for the next verb.
        prep: the preposition that waits for its target.
        mentions: mentions of the sentence so far.
        topic: the thing that the clause is about ("the light turns green"), no participant.
        last_pp: the mention in the prepositional phrase just read, if it is no anchor.
        fronted: phrases of place at the start of a clause, for the mention that follows.
        opening: the same phrases once that mention has come, for its verb.
        last_prep: the phrase read last.
        resumed: verbs before a clause put between; one goes on ("and, once it is past, drives on").
        relating: whom a relative clause is about that is interrupted ("who, looking down, walks").
        where: a clause has been opened that says what takes place somewhere.
        trailing: the ego where it opens a clause after that of another ("…, as the ego turns").
        being: who is said to be somewhere before an "and" ("is 20 m away and doing 30 km/h").
        dependent: the clause of the candidate is opened by "when", "while" and the like.
        outside: the candidate as brackets open, and whether it has its verb; so it is again behind.
        relative: who acts in a relative clause, and on whom ("the van that the ego follows").
    """

    chunks: list[Chunk]
    k: int = 0
    candidate: Mention | None = None
    candidate_done: bool = False
    main: list[Mention] = field(default_factory=list)
    anchor: Mention | NounPhrase | Event | None = None
    between: set[str] = field(default_factory=set)
    events: list[Event] = field(default_factory=list)
    pending: list[Event] = field(default_factory=list)
    ahead: list[Term] = field(default_factory=list)
    prep: Prep | None = None
    mentions: list[Mention] = field(default_factory=list)
    topic: NounPhrase | None = None
    last_pp: Mention | None = None
    fronted: list[Prep] = field(default_factory=list)
    opening: list[Prep] = field(default_factory=list)
    last_prep: Prep | None = None
    where: bool = False
    trailing: list[Mention] = field(default_factory=list)
    relative: tuple[Mention, Mention] | None = None
    relating: Mention | None = None
    resumed: list[Event] = field(default_factory=list)
    being: Mention | None = None
    dependent: bool = False
    outside: tuple[Mention | None, bool] = None, False

    def at(self, n: int) -> Chunk:
        """The chunk so many after the one that is read, or before it."""
        return chunk_at(self.chunks, self.k + n)

    def before(self, n: int) -> list[Chunk]:
        """So many chunks right before the one that is read."""
        return self.chunks[max(0, self.k - n) : self.k]

    def after(self, n: int) -> list[Chunk]:
        """So many chunks right after the one that is read."""
        return self.chunks[self.k + 1 : self.k + 1 + n]

    @property
    def verb_follows(self) -> bool:
        """Whether a verb of its own comes after what is read."""
        return finite_follows(self.chunks, self.k)

    @property
    def waiting(self) -> Mention | None:
        """The candidate, as long as it has no verb of its own."""
        return self.candidate if not self.candidate_done else None

    def awaits(self, *words: str) -> bool:
        """Whether one of these prepositions waits for its target."""
        return self.prep is not None and self.prep.value in words

    def stand_at(self, phrase: Mention | NounPhrase | Event) -> None:
        """A phrase becomes the anchor; no words have come since."""
        self.anchor, self.between, self.last_pp = phrase, set(), None

    @property
    def last(self) -> Event | None:
        """The last event of the sentence."""
        return self.events[-1] if self.events else None


def only_then(until: Term, state: State) -> None:
    """``does not stop until the van has passed``, ``not until …``: it does so, but then."""
    rest = state.chunks[state.k : sentence_end(state.chunks, state.k)]
    comes = {c.name if isinstance(c, Event) else c.cat for c in rest if c.cat in {"", "quantity"}}
    held = [e for e in state.events if e.negated and not e.unable]
    if (held or state.at(-1).cat == "neg") and comes - {""} and "collide" not in comes:
        for event in held:
            event.negated = False
        state.chunks[state.k] = replace(until, value="once")
