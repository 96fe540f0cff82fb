"""A number as a clause: in which part of the text it stands, whose it is, what follows it."""

from functools import cached_property
from typing import Any

from scegen.scenario.spacings import Measure
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Prep, Thing
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.frames import AmountFrame, Numbers
from scegen.understanding.happenings import Amount, Trigger
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause
from scegen.understanding.words.quantities import Quantity
from scegen.understanding.words.terms import Term

_MEASURES = {measure.value.rpartition("_")[0]: measure for measure in Measure}
NO_RULE = "a measure that no rule could attach; left out"
_SKIPPED = frozenset({"aux", "manner", "unknown", "possessive", "(", ":"})
_OWNS = (["'s"], ["'"], ["("])
"""``the ego's 60 km/h``, ``a van (45 km/h)``."""


class Figure(Clause):
    """A number as a clause: its role is its verb, on which it depends is what happens there.

    Who acts is who acts there; the phrase of place after it is its own.
    """

    def __init__(self, quantity: Quantity, numbers: Numbers, text: Telling) -> None:
        self.quantity, self.text = quantity, text
        self.i, self.j = quantity.i, quantity.j
        self.start, self.end = text.bounds(self.i)
        verb, scene = self.verb, self.scene
        told = (verb.name, None if verb.perfect else verb.i) if verb is not None else ()
        ahead = verb is not None and verb.i > self.j and any(map(self._modifies, text.mentions))
        told = () if ahead else told
        self.words_around, self.frame = numbers.measured(quantity, *told)
        self.quantity = quantity.unsigned  # "brakes with -6 m/s²"
        sized = self.frame.role in {"long", "wide"} or (
            self.frame.role == "other" and self.frame.next
        )
        inside = self.phrase_around(self.i) if self.frame.dimension == "length" else None
        if inside is not None and not sized:
            self.frame = AmountFrame("length", "long")  # "a 12 m bus": how large it is
        self.role = self.frame.role
        event = Event(self.role, self.i, self.j, "", parent=verb)
        event.pps = [Prep(*self.after)] if self.after is not None else []
        who, whom = (scene.actors, scene.targets) if scene is not None else ([], [])
        super().__init__(event, who, whom, {}, self.words_around)

    @property
    def amount(self) -> Amount:
        """Its value with its words."""
        return Amount(self.quantity.value, Basis(self.i, self.j, self.quantity.note))

    @property
    def exactly(self) -> Amount:
        """The number itself, without what "up to" or "about" make of it."""
        return Amount(self.quantity.exact, Basis(self.i, self.j))

    @property
    def placed(self) -> Amount:
        """Its value, also with the words of place after it: "15 m in front of"."""
        amount, noun = self.amount, self.noun
        if self.after is None:
            return amount
        end = self.after[0].j
        if isinstance(noun, Mention) and noun.possessor:
            end = noun.j + 2
        if isinstance(noun, Place) and noun.kind == "side":
            end = noun.j
        return Amount(amount.value, Basis(self.i, min(end, self.end), amount.basis.reason))

    def trigger(self, kind: str, **rest: Any) -> Trigger:  # noqa: ANN401 - fields of a trigger
        """What sets an act off by this number, wherever it is reached ("has fallen below 20 m")."""
        return Trigger(kind, self.placed.basis, self.exactly, **rest)

    def note(self, instead: str | None = None) -> None:
        """Reports that no field holds it."""
        left_out = instead or self.frame.instead or NO_RULE
        self.text.draft.note(self.i, self.j, left_out)

    @cached_property
    def scene(self) -> Clause | None:
        """The clause in which it stands."""
        own = [scene for scene in self.text.scenes if self._modifies(scene.event)]
        here = self.text.within(self.start, self.end)
        here = [s for s in here if s.event.name not in {"inert", "match"}]
        before = [s for s in here if s.event.i < self.i]
        if self.text.tokens[self.i - 1].low == "with":  # "passes a van parked there with 1 m"
            own = [s for s in own if not s.tells_parked]
            before = [s for s in before if not s.tells_parked] or before
        here.sort(key=lambda s: not s.event.finite)  # "30 m short of a van standing there it …"
        return next(iter((*own, *before[-1:], *here)), None)

    def _modifies(self, phrase: Event | Mention) -> bool:
        return any((m.i, m.j) == (self.i, self.j) for m in phrase.mods)

    @property
    def measure(self) -> Measure:
        """What it measures between two."""
        return _MEASURES[self.role]

    @property
    def does(self) -> str:
        """What happens in its clause, as the lexicon calls it."""
        return self.verb.name if self.verb is not None else ""

    @cached_property
    def verb(self) -> Event | None:
        """What happens in its clause; None where it only is somewhere."""
        scene, clause = self.scene, self.clause
        if clause is not None and clause[2] in word_list("until"):  # "brakes until it does 30 km/h"
            main = self.text.within(self.start, clause[0])
            inside = self.text.within(clause[0], self.i)
            told = [s for s in inside if s.event.name != "move"] or main
            return told[-1].event if told else None
        if scene is None or clause is None or clause[0] <= scene.event.i < clause[1]:
            return scene.event if scene is not None else None
        return scene.event if self._modifies(scene.event) else None

    @cached_property
    def clause(self) -> tuple[int, int, str] | None:
        """The clause that sets something off in which it stands: begin, end, opening words."""
        return self.clause_of(self.i)

    def clause_of(self, i: int) -> tuple[int, int, str] | None:
        """The same of another token."""
        start, stop = self.text.bounds(i)
        opened = [c for c in self.text.subs if start <= c.i <= i]
        if not opened:
            return None
        begin = opened[-1].i
        commas = [k for k in range(begin, stop) if self.text.tokens[k].low == ","]
        before = sum(k < i for k in commas)
        aside = before % 2  # "when the ego, at 40 km/h, is 20 m away": it sets nothing off
        if aside and self.text.within(begin, commas[before - 1]):
            return None  # "when it sets off, the ego is 25 m behind it"
        words = "" if aside else self.text.low(begin, opened[-1].j).strip()
        return begin, next(iter(commas[before + aside :]), stop), words

    def phrase_around(self, i: int) -> Mention | Thing | None:
        """``a 12 m bus``: somebody or something in whose phrase a token stands."""
        phrases = [c for c in self.text.chunks if isinstance(c, Mention | Thing) and has_a_size(c)]
        return next((p for p in phrases if p.head is not None and p.i <= i < p.head.i), None)

    def named_before(self, i: int) -> list[Entity]:
        """Who is named right before a token, forms of "to be" and adverbs skipped."""
        if i > self.start and self.text.tokens[i - 1].low in {"our", "my"}:
            return [self.text.ego]
        for chunk in reversed(self.text.chunks):
            if chunk.j > i:
                continue
            if chunk.j <= self.start:
                return []
            if isinstance(chunk, Thing) and self.text.tokens[chunk.j - 1].low in word_list("rates"):
                if chunk.has("possessive", "first_person"):
                    return [self.text.ego]  # "…, our speed 85 km/h"
                if chunk.owner is not None:
                    return chunk.owned_by
                continue  # "the ego's speed of 90 km/h"
            if self.role == "lateral_offset" and (isinstance(chunk, Thing) or chunk.value == "by"):
                continue  # "a van offset by 0.5 m"
            if isinstance(chunk, Mention):
                owns = self.text.low(chunk.j, i).split() in _OWNS
                linked = self.text.low(chunk.j, i).strip() in {":", "is", "was"} or self._goes_on
                told = linked or self.role == "relative_speed"  # "the van behind it 20 km/h faster"
                whole = self.placed_by(chunk) if told else chunk
                return list(whole.entities) if owns or not chunk.possessor else []
            of = chunk.value == "of"
            if not isinstance(chunk, Term) or not (of or {chunk.cat, chunk.value} & _SKIPPED):
                return []
        return []

    @property
    def _goes_on(self) -> bool:
        """``the van ahead of the ego (70 km/h) brakes``: a verb comes behind the brackets."""
        after = [c for c in self.text.chunks if c.i >= self.j][:2]
        return [c.value for c in after[:1]] == [")"] and isinstance(after[-1], Event)

    def placed_by(self, landmark: Mention) -> Mention:
        """``car in front of the ego: 80 km/h``: the noun that is placed by another, else that."""
        before = (m for m in reversed(self.text.mentions) if m.i < landmark.i)
        placed = (m for m in before if any(p.target is landmark for p in m.pps))
        located = landmark.prep is not None and landmark.prep.cat == "locus"
        return next(placed, landmark) if located else landmark

    def _free(self, start: int) -> list[Mention]:
        """Who is named before it and in no phrase of place, and only owns nothing."""
        named = [m for m in self.text.mentions if start <= m.i < self.i and m.entities]
        return [m for m in named if m.prep is None and not m.possessor]

    def last_named(self, start: int) -> list[Entity]:
        """Who is named last before it, in no phrase of place if that can be."""
        named = [m for m in self.text.mentions if start <= m.i < self.i and m.entities]
        return list((self._free(start) or named)[-1].entities) if named else []

    @cached_property
    def said_of(self) -> Entity | None:
        """Whom a clause is about that says how far off one is: "a van that is still 60 m away"."""
        words_ = (c for c in self.text.chunks if isinstance(c, Term) and self.start <= c.i < self.i)
        opened = [c for c in words_ if c.cat in {"rel", "sub"}]
        free = self._free(opened[-1].i + 1) if opened else []
        who = free[0].entities if free else []
        if opened and opened[-1].cat == "rel":
            before = (m for m in reversed(self.text.mentions) if m.i < opened[-1].i)
            who = next((m.entities for m in before if not m.possessor), [])
        return next(iter(who), None)

    @cached_property
    def subject(self) -> list[Entity]:
        """Who the sentence is about up to it: the subject of its last verb, or its first noun."""
        own = self.named_before(self.i) or self._owner()
        if own:
            return own
        before = [s for s in self.text.within(self.start, self.i) if s.actors]
        if not before:
            return self.last_named(self.start)
        last = before[-1]
        later = [m for m in self._free(last.event.i + 1) if m is not last.event.object]
        return list(later[-1].entities if later else last.actors)

    def _owner(self) -> list[Entity]:
        """``its speed is 50 km/h``, ``my speed``, ``their rears are 20 m away``: whose that is."""
        mentions, lows = self.text.mentions, [t.low for t in self.text.tokens[: self.i]]
        last = max([self.start - 1, *(m.i for m in mentions if m.i < self.i)])
        whose = [k for k in range(last + 1, self.i) if lows[k] in word_list("its_own")]
        start = whose[-1] if whose else -1
        if not whose or not (start == self.start or lows[-1] in word_list("links")):
            return []
        if lows[start] in {"my", "our"}:
            return [e for m in mentions for e in m.entities if e.ego][:1]
        before = [m for m in mentions if m.i < start and m.entities and not m.possessor]
        opening = self.text.bounds(self.start - 2)[0] if self.start > 1 else self.start
        said = [m for m in before if m.i >= opening and m.prep is None] or before[-1:]
        count = len(said) if lows[start] == "their" else 1
        return list(dict.fromkeys(e for m in said[:count] for e in m.entities))

    @cached_property
    def after(self) -> tuple[Term, NounPhrase | None] | None:
        """A phrase of place right after it: "ahead of the ego", "from the junction"."""
        chunks = self.text.chunks
        j = self.words_around.resumes
        k = next((k for k, c in enumerate(chunks) if c.i >= j), len(chunks))
        tokens = self.text.tokens
        while k < len(chunks) and tokens[chunks[k].i].low in {"(", ")", "remaining"}:
            k += 1  # "26.7 m (1.6 s) behind a car"
        word = chunks[k] if k < len(chunks) else None
        if not isinstance(word, Term):
            return None
        before = word.cat == "sub" and self.text.low(word.i, word.j) == " before "
        before = before or self.text.tokens[word.i].low in {"short", "away", "distant"}
        if word.cat not in {"locus", "prep"} and not before:
            return word, None
        for chunk in chunks[k + 1 : k + 5]:
            if isinstance(chunk, Mention | Place | Thing):
                return word, chunk
            if isinstance(chunk, Event) or chunk.cat == "conj" or chunk.value in {",", ";", "."}:
                break  # "80 m ahead and a car …": ahead of nobody that is named
        return word, None

    @property
    def noun(self) -> NounPhrase | None:
        """The noun of that phrase."""
        return self.after[1] if self.after is not None else None

    @property
    def led_by(self) -> str:
        """The word that opens that phrase."""
        return self.text.tokens[self.after[0].i].low if self.after is not None else ""


def has_a_size(noun: Mention | Thing) -> bool:
    """Whether it is somebody who takes part, or a thing on or beside the road."""
    if isinstance(noun, Mention):
        return bool(noun.entities)
    return noun.head is not None and "thing" in noun.head.data
