"""Reads chunks clause by clause: who does what to whom.

English puts the subject before its verb and the object after it. The reader walks over the
chunks of a sentence once and remembers the mention that waits for its verb (the candidate),
the subject of the last finite verb, and the words that stood between the last two phrases;
these decide who acts in participles ("a car turning left"), infinitives ("tries to merge",
"forcing the van to stop"), coordinations, relative clauses and clauses without a subject.
"""

from __future__ import annotations

from scegen.understanding import subjects
from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Prep, Word
from scegen.understanding.lookahead import (
    ADVERBS,
    BOUNDARIES,
    GOVERNING,
    event_follows,
    finite_follows,
    main_verb_follows,
)
from scegen.understanding.phrases import also_from, apposes, bracketed
from scegen.understanding.state import State


class ClauseReader:
    """Turns the chunks of a text into events with their participants.

    Args:
        chunks: the chunks of the text in order.
    """

    def __init__(self, chunks: list[Chunk]) -> None:
        self._chunks = chunks
        self._state = State()
        self._sentence = 0
        self.events: list[Event] = []

    def run(self) -> list[Event]:
        """All events in the order of the text, premodifiers before the events of their noun."""
        for k, chunk in enumerate(self._chunks):
            if isinstance(chunk, Word):
                self._word(chunk, k)
            elif isinstance(chunk, Mention):
                self._mention(chunk, k)
            elif isinstance(chunk, Event):
                self._event(chunk, k)
            else:
                self._noun(chunk, k)
        self._end_sentence()
        return self.events

    def _end_sentence(self) -> None:
        self._release_prep()
        main = self._state.main
        self._state = State(main=main)
        self._sentence += 1

    def _word(self, word: Word, k: int) -> None:
        state = self._state
        if word.cat == "punct" and word.value in BOUNDARIES:
            self._end_sentence()
        elif word.cat in GOVERNING:
            self._preposition(word)
        elif word.cat in ADVERBS or word.cat == "state":
            self._adverb(word, k)
        else:
            self._release_prep()
            if word.cat == "punct" and word.value in "()":
                self._parenthesis(word.value)
                return
            state.between.add(word.value if word.cat in {"punct", "conj"} else word.cat)
            if word.cat == "conj":
                state.between.add("conj")
            if word.cat in {"sub", "conj"} and word.value != "or" and state.candidate_done:
                state.candidate = None

    def _parenthesis(self, mark: str) -> None:
        """What stands in brackets does not change who acts after them."""
        state = self._state
        if mark == "(":
            state.bracket = (state.anchor, set(state.between))
        elif state.bracket is not None:
            state.anchor, state.between = state.bracket
            state.bracket = None

    def _preposition(self, word: Word) -> None:
        state = self._state
        outer = state.prep.value if state.prep is not None else None
        if state.prep is not None and word.cat != "locus":
            self._release_prep()
            outer = None
        anchor = state.anchor
        near = anchor if isinstance(anchor, Mention) and not state.between else None
        if state.last_pp is not None and not state.between:
            near = state.last_pp
        state.prep = Prep(word, None, outer, near)

    def _release_prep(self) -> None:
        """A preposition without a target: "the car ahead", "positioned behind on the right"."""
        state = self._state
        if state.prep is not None:
            if state.prep.word.cat == "locus":
                self._attach_prep(state.prep)
            state.prep = None

    def _attach_prep(self, prep: Prep) -> None:
        state = self._state
        if prep.on_mention is not None:
            prep.on_mention.pps.append(prep)
        if state.events and (prep.on_mention is None or state.anchor is not state.candidate):
            state.events[-1].pps.append(prep)
        elif prep.on_mention is None and state.candidate is not None:
            state.candidate.pps.append(prep)

    def _adverb(self, word: Word, k: int) -> None:
        state = self._state
        if word.cat in {"aux", "neg"}:
            state.between.add(f"{word.cat}:{word.value}")
            return
        self._release_prep()
        after_event = isinstance(state.anchor, Event) and not (state.between - {"either", "or"})
        following = self._chunks[k + 1] if k + 1 < len(self._chunks) else None
        before_event = event_follows(self._chunks, k)
        waits = after_event and isinstance(state.anchor, Event) and state.anchor.control
        opens = word.cat == "manner" and isinstance(following, Event) and following.form == "s"
        if opens and after_event and not state.candidate_done:
            state.ahead.append(word.term)  # "a cyclist riding ahead suddenly turns"
            return
        copular = "aux:be" in state.between and not before_event and word.cat == "manner"
        if copular and state.candidate is not None and not state.candidate_done:
            state.candidate.mods.append(word.term)  # "the one behind me is too close"
            return
        predicate = not before_event or word.cat in {"dir", "state", "compass"}
        if "rel" in state.between and state.mentions and predicate:
            state.mentions[-1].mods.append(word.term)
        elif before_event and (not after_event or waits) and word.cat not in {"dir", "compass"}:
            state.ahead.append(word.term)
        elif state.events and not self._clause_start():
            state.events[-1].mods.append(word.term)
            if isinstance(following, Word) and following.value == "or":
                state.between.discard("or")
        elif state.candidate is not None:
            state.candidate.mods.append(word.term)
        elif before_event:
            state.ahead.append(word.term)
        elif self.events and not state.mentions:
            self.events[-1].mods.append(word.term)

    def _clause_start(self) -> bool:
        """The candidate is new: words after it belong to it and not to the verb before."""
        state = self._state
        if state.candidate is None or state.anchor is not state.candidate:
            return False
        return not any(state.candidate in event.subject for event in state.events)

    def _mention(self, mention: Mention, k: int) -> None:
        state = self._state
        state.mentions.append(mention)
        state.inanimate = False
        self._premodifiers(mention)
        if mention.possessor:
            return
        if state.prep is not None:
            self._prepositional(mention, k)
            return
        anchor = state.anchor
        direct = isinstance(anchor, Event) and not anchor.nominal and not state.between
        if isinstance(anchor, Event) and direct and anchor.object is None:
            anchor.object = mention
        elif bracketed(self._chunks, k) and isinstance(anchor, Mention):
            mention.same_as = anchor
            return
        elif apposes(self._chunks, k, state):
            mention.same_as = anchor if isinstance(anchor, Mention) else state.candidate
            return
        elif self._joins(mention, k):
            return
        else:
            self._start_clause(mention)
        state.anchor = mention
        state.between = set()
        state.last_pp = None

    def _joins(self, mention: Mention, k: int) -> bool:
        """``a car and a truck``: the second takes the role of the first."""
        state = self._state
        anchor = state.anchor
        listed = "and" in state.between or "or" in state.between or state.between == {","}
        if not (isinstance(anchor, Mention) and listed) or "sub" in state.between:
            return False
        if mention.pronoun in {"count", "one", "another"} and "," in state.between:
            return False  # "four vans, two turning left": some of them, not further ones
        waiting = anchor is state.candidate and not state.candidate_done
        waiting = waiting and not any(anchor in event.subject for event in state.events)
        if state.between == {","} and not waiting:
            return False
        if not waiting and (finite_follows(self._chunks, k) or "," in state.between):
            return False
        mention.joined = anchor
        if waiting:
            state.candidate = mention
        for event in state.events:
            if event.object is anchor:
                event.object = mention
        state.anchor = mention
        state.between = set()
        return True

    def _start_clause(self, mention: Mention) -> None:
        state = self._state
        mention.denied = "neg:not" in state.between
        state.candidate = mention
        state.candidate_done = False
        for event in state.pending:
            event.subject = [mention]
        state.pending = []

    def _prepositional(self, mention: Mention, k: int) -> None:
        state = self._state
        prep = state.prep
        state.prep = None
        if prep is None:
            return
        prep.target = mention
        mention.prep = prep.word
        self._attach_prep(prep)
        last = state.events[-1] if state.events else None
        if last and last.nominal and prep.value in {"by", "of"} and not last.subject:
            last.subject = [mention]
        named = prep.value in {"with", "due", "against"}
        if prep.value == "of" and state.anchor is not None and prep.on_mention is not None:
            prep.on_mention.partitive = True
            return
        pending = state.candidate is not None and not state.candidate_done
        if pending and finite_follows(self._chunks, k):
            state.last_pp = mention
            return
        if named and state.candidate is None:
            self._start_clause(mention)
        state.anchor = mention
        state.between = set()
        state.last_pp = None

    def _noun(self, noun: NounPhrase, k: int) -> None:
        state = self._state
        opens = not state.events or bool(state.between & {"sub", ",", "conj"})
        if state.prep is None and opens and finite_follows(self._chunks, k):
            opens = not (state.events and "," in state.between and "sub" not in state.between)
            state.inanimate = opens and (state.candidate is None or "sub" in state.between)
        if state.prep is not None:
            state.prep.target = noun
            noun.prep = state.prep.word
            self._attach_prep(state.prep)
            state.prep = None
            return
        if also_from(noun, state):
            return
        anchor = state.anchor
        direct = isinstance(anchor, Event) and anchor.object is None
        if isinstance(anchor, Event) and direct and not (state.between - {"or", "either"}):
            anchor.object = noun
            state.anchor = noun
            state.between = set()
        elif not state.events and state.candidate is None:
            state.anchor = noun
            state.between = set()

    def _premodifiers(self, mention: Mention) -> None:
        """``a speeding car``, ``the left turning truck``: events of the noun itself."""
        for position, mod in enumerate(mention.mods):
            if mod.cat != "verb":
                continue
            before = [m for m in mention.mods[:position] if m.cat in {"dir", "manner"}]
            event = Event(mod.value, mod.i, mod.j, mod.form, subject=[mention], mods=before)
            event.premod_of = mention
            event.sentence = self._sentence
            self.events.append(event)

    def _event(self, event: Event, k: int) -> None:
        state = self._state
        event.reduced = state.anchor is state.candidate and main_verb_follows(self._chunks, k)
        if state.prep is not None and state.prep.word.cat == "locus":
            self._release_prep()
        event.sentence = self._sentence
        event.mods += state.ahead
        state.ahead = []
        subjects.link(event, state)
        event.negated = any(word.startswith("neg:") for word in state.between) or event.negated
        event.negated = event.negated or any(
            m.denied or m.pronoun == "neither" for m in event.subject
        )
        event.modal = event.modal or "aux:modal" in state.between
        self._release_prep()
        state.events.append(event)
        self.events.append(event)
        state.anchor = event
        state.between = set()
        state.last_pp = None
