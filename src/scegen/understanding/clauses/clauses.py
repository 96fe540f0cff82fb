"""Reads chunks clause by clause: who does what to whom.

English puts the subject before its verb and the object after it. The reader walks over the
chunks of a sentence once and remembers the mention that waits for its verb (the candidate),
the subject of the last finite verb, and the words that stood between the last two phrases;
these decide who acts in participles ("a car turning left"), infinitives ("tries to merge",
"forcing the van to stop"), coordinations, relative clauses and clauses without a subject.
"""

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Prep, Thing
from scegen.understanding.clauses import subjects
from scegen.understanding.clauses.attachment import outside, preposition, release, shown
from scegen.understanding.clauses.dependents import chain
from scegen.understanding.clauses.further import close_relative
from scegen.understanding.clauses.located import is_it
from scegen.understanding.clauses.nominals import premodifiers, read_mention, read_noun
from scegen.understanding.clauses.state import State, only_then
from scegen.understanding.phrases.lookahead import (
    ADVERBS,
    BOUNDARIES,
    GOVERNING,
    by_follows,
    event_follows,
    only_a_noun_follows,
    view_of,
)
from scegen.understanding.words.terms import NOTHING, Term

_OPENERS = frozenset({"conj", "sub", "punct"})
_PREDICATES = frozenset({"manner", "state"})
_LANES = frozenset({"lane", "bike_lane", "shoulder", "sidewalk", "side", "bus_stop"})


class ClauseReader:
    """Turns the chunks of a text into events with their participants."""

    def __init__(self, chunks: list[Chunk]) -> None:
        self._chunks = chunks
        self._state = State(chunks)
        self._sentence = 0
        self.events: list[Event] = []

    def run(self) -> list[Event]:
        """All events in the order of the text, premodifiers before the events of their noun."""
        for k, chunk in enumerate(self._chunks):
            self._state.k = k
            if isinstance(chunk, Term):
                self._word(chunk)
            elif isinstance(chunk, Mention):
                self.events += premodifiers(chunk, self._sentence)
                read_mention(chunk, self._state)
            elif isinstance(chunk, Event):
                self._event(chunk)
            else:
                read_noun(chunk, self._state)
        self._end_sentence()
        return self.events

    def _end_sentence(self) -> None:
        release(self._state)
        self._state = State(self._chunks, main=self._state.main)
        self._sentence += 1

    def _word(self, word: Term) -> None:
        state = self._state
        if word.cat == "punct" and word.value in BOUNDARIES:
            self._end_sentence()
        elif word.cat in GOVERNING or only_a_noun_follows(word, state.k, self._chunks):
            preposition(word, state)
        elif self._governed_on(word):
            return
        elif word.cat in ADVERBS or word.cat == "state":
            if not self._denied_way(word):
                self._adverb(word)
        else:
            release(state)
            if word.value == "(":
                state.outside = state.candidate, state.candidate_done
            elif word.value == ")":
                state.candidate, state.candidate_done = state.outside
            else:
                self._joint(word)

    def _joint(self, word: Term) -> None:
        """A word between phrases or clauses: "and", a comma, "where", "that"."""
        state, following = self._state, self._state.at(1)
        if word.value == "before" and following.cat == "quantity":
            return  # "and after 3 s brakes": a moment, no clause
        ends = word.value == "," or word.cat in {"conj", "sub"}
        denied = ends and state.at(-1).cat == "neg"
        if word.data.get("holds"):
            only_then(word, state)
        if denied and isinstance(following, Mention):  # "It can't, we ram it"
            state.between = {w for w in state.between if not w.startswith(("neg:", "aux:"))}
        state.between.add(word.value if word.cat in {"punct", "conj"} else word.cat)
        if word.cat == "conj" and word.value != "either":
            state.between.add("conj")
            state.between |= {"neg:not"} if word.data.get("denies") else set()
        if word.cat == "conj" and word.value in {"and", "but"}:
            who = state.candidate
            somewhere = who is not None and any(p.predicate for p in who.pps)
            state.being = who if somewhere or "aux:be" in state.between else None
            state.between -= {"aux:be", "copy"}  # "was tired and …", "there's no arrow and a van"
        if word.value == "where":
            self._where()
        if word.cat == "sub" and self._put_between():
            state.resumed = [e for e in state.events if e.finite and e.subject]
        if word.cat == "sub" or word.value == ",":
            state.where = word.value == "where"
        if word.cat == "rel" and _is_thing(state.at(-1 - (state.at(-1).value == ","))):
            state.between.add("thing")
        if word.cat in {"sub", "conj"} and word.value != "or" and state.candidate_done:
            state.candidate = None

    def _governed_on(self, word: Term) -> bool:
        """``from either the left or …``, ``without the two touching``, ``overtakes the two of us``.

        So it is in "without ever braking".
        """
        noun, prep = self._state.at(1), self._state.prep
        lacking = prep is not None and prep.value == "without"
        if word.cat == "det" and isinstance(noun, Mention):
            return noun.has("num") or lacking
        adverb = lacking and word.cat == "manner" and event_follows(self._chunks, self._state.k)
        return adverb or (prep is not None and word.value == "either")

    def _put_between(self) -> bool:
        """``and, when …``: after that clause the one before goes on."""
        before = [c.value for c in self._state.before(2) if isinstance(c, Term)]
        return before[-1:] in (["and"], ["but"]) or before in (["and", ","], ["but", ","])

    def _where(self) -> None:
        """``the next lane, where a van drives``: the van is in that lane."""
        places = [c for c in self._state.before(2) if isinstance(c, Place)]
        for place in places[-1:]:
            if place.kind in _LANES and not is_it(self._state.at(1)):  # who gets there itself
                word = Term("prep", "in", place.i, place.i + 1)
                self._state.fronted.append(Prep(word, place, fronted=True))

    def _adverb(self, word: Term) -> None:
        state = self._state
        if word.cat in {"aux", "neg"}:
            if state.waiting is not None:
                release(state)  # "the car behind is a taxi"
            state.between -= {"aux:be"} if word.value == "will" else set()  # "is going to cut in"
            state.between.add(f"{word.cat}:{word.value}")
            return
        release(self._state)
        verb = state.anchor if not (state.between - {"either", "or"}) else None
        after_event = isinstance(verb, Event)
        following = self._state.at(1)
        before_event = event_follows(self._chunks, state.k)
        waits = isinstance(verb, Event) and verb.control
        opens = word.cat == "manner" and isinstance(following, Event) and following.form == "s"
        copular = "aux:be" in state.between and not before_event and word.cat in _PREDICATES
        predicate = not before_event or word.cat in {"dir", "state", "compass"}
        relative = word.cat == "quantity" and bool(state.events) and not state.between
        before_event = before_event and (not relative or self._clause_start())
        related = "rel" in state.between and bool(state.mentions) and predicate
        noun = state.mentions[-1] if related else state.last_pp or state.anchor
        stated = word.cat == "state" and (state.between == {","} or state.at(-1).value == "(")
        stated = stated or (word.value == "speed" and noun is not None and noun is shown(state))
        if opens and after_event and not state.candidate_done:
            state.ahead.append(word)  # "a cyclist riding ahead suddenly turns"
        elif copular and state.waiting is not None:
            for who in chain(state.waiting):  # "the one behind me is too close"
                who.mods.append(word)
        elif isinstance(noun, Mention) and (related or stated):
            noun.mods.append(word)  # "hits the van, by then stationary, in the rear"
        elif before_event and (not after_event or waits) and not self._told_before(word):
            state.ahead.append(word)
        elif state.events and not self._clause_start():
            told = outside(state, word) if word.cat == "quantity" else state.events[-1]
            told.mods.append(word)
        elif state.candidate is not None:
            state.candidate.mods.append(word)
        elif word.cat == "manner" and isinstance(state.at(1 + (following.value == ",")), Mention):
            state.ahead.append(word)  # "Suddenly a van …", "In reverse, the ego …"

    def _told_before(self, word: Term) -> bool:
        """``a van following the ego too closely is unable to react``: how it follows."""
        close = [e.embedded or not e.finite for e in self._state.events if word.value == "close"]
        return any(close[-1:]) or word.cat in {"dir", "compass"}

    def _denied_way(self, word: Term) -> bool:
        """``turns right, not left``."""
        state = self._state
        denied = word.cat == "dir" and bool(state.events) and "neg:not" in state.between
        if denied:
            release(state)
            state.between.discard("neg:not")
            state.events[-1].denied_ways.add(word.value)
        return denied

    def _clause_start(self) -> bool:
        """The candidate is new: words after it belong to it and not to the verb before."""
        state = self._state
        who, anchor = state.candidate, state.anchor
        if who is None or any(who in event.subject for event in state.events):
            return False
        beside = isinstance(anchor, Mention) and anchor.pronoun is not None
        beside = beside and any(p.target is anchor for p in who.pps)  # "the ego, behind it at …"
        return anchor is who or beside

    def _inverted(self, event: Event) -> bool:
        """``from the left comes a bus``, ``along comes a van``: the subject follows its verb."""
        following = self._state.at(1)
        finite = not event.nominal and event.form != "ing"
        before, opener = (self._state.at(n) for n in (-1, -2))
        if before.cat == "conj":
            return False  # "comes up from behind and overtakes the ego"
        adverb = before.cat == "manner" and event.name == "move"
        opens = opener is NOTHING or opener.cat in _OPENERS
        fronted = bool(self._state.fronted) or (adverb and opens)
        return fronted and finite and isinstance(following, Mention | Thing)

    def _by_a_stranger(self, event: Event) -> bool:
        """``roadworks blocking the lane``, ``a steward waves``: no participant does it."""
        before = self._state.at(-1)
        if event.nominal:
            return False
        if _is_thing(before):
            there = "copy" in self._state.between  # "we stop, there's a crate lying in the lane"
            return event.form == "ing" and (there or not self._state.between)
        view = view_of(self._state.before(3))
        if view is not None and event.form == "ed":
            event.passive, event.object = True, view  # "its view blocked by a truck"
            return "aux:be" not in self._state.between
        return False

    def _event(self, event: Event) -> None:
        state = self._state
        event.reduced = subjects.only_describes(event, state)
        if state.prep is not None and state.prep.word.cat == "locus":
            release(self._state)
        event.sentence = self._sentence
        event.mods += state.ahead
        state.ahead = []
        whom = state.relative[1] if state.relative is not None else event
        if close_relative(event, state):
            state.prep = None
        elif self._inverted(event):
            event.finite = True
            state.pending.append(event)
        elif not self._by_a_stranger(event):
            subjects.link(event, state)
            if event.form != "ing" or event.finite:  # "ahead of it a van doing 50 km/h brakes"
                event.pps += state.opening
                state.opening = []
        undergone = event.name == "collide" and state.at(1).value == "from"  # "hit from behind"
        if undergone or by_follows(self._chunks, state.k):
            subjects.before_by(event)
        apart = {"aux:do", "conj"} <= state.between and event.form in {"s", "ed"}
        if apart:  # "the van behind doesn't and overtakes us"
            state.between -= {word for word in state.between if word.startswith("neg:")}
        negated = any(word.startswith("neg:") for word in state.between)
        if event.nominal and isinstance(state.anchor, Event) and state.anchor.name == "light":
            negated = negated or state.anchor.negated
        event.negated |= negated or self._lacking(event) or self._neither(event)
        event.unable = event.negated and bool({"neg:unable", "aux:can"} & state.between)
        denied = any(m.denied or m.pronoun == "neither" for m in event.subject)
        event.negated = event.negated or denied
        if any("had" in m.marks for m in event.subject):  # "had it braked, it …": it did not
            event.negated = not event.negated
        event.perfect = "aux:have" in state.between
        owed = "aux:shall" in state.between and any(m.is_ego for m in event.subject)
        event.modal = event.modal or owed or "aux:modal" in state.between
        release(self._state)
        state.events.append(event)
        self.events.append(event)
        state.stand_at(whom)

    def _neither(self, event: Event) -> bool:
        """``does not steer, brake or accelerate``, ``without slowing or braking``: none of them."""
        last, between = self._state.last, self._state.between
        listed = "or" in between or (event.form == "base" and between == {","})
        return listed and last is not None and last.negated and event.form == last.form != "s"

    def _lacking(self, event: Event) -> bool:
        """``without braking``, ``without either driver braking``."""
        who, own = self._state.anchor, self._state.prep
        by = who.prep if event.form == "ing" and isinstance(who, Mention) else None
        return any(word is not None and word.value == "without" for word in (by, own))


def _is_thing(chunk: Chunk) -> bool:
    """``a fallen tree that blocks the lane``: the tree does it, and no participant."""
    return isinstance(chunk, Thing) and chunk.lies_there
