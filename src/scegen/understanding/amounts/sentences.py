"""Finds one's way in a text: its sentences, the clause of a word, who is spoken of there."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Thing, Word
from scegen.understanding.draft import Entity
from scegen.understanding.frames import words
from scegen.understanding.semantics.context import Clause
from scegen.understanding.words.tokens import Token

_PARENTHESIS = 2
_ENDS = frozenset({".", ";", "!", "?", "\n"})


class Sentences:
    """A text with its clauses, mentions resolved.

    Args:
        tokens: its tokens.
        chunks: its chunks.
        scenes: what happens, in the order of the text.
    """

    def __init__(self, tokens: list[Token], chunks: list[Chunk], scenes: list[Clause]) -> None:
        self.tokens = tokens
        self.chunks = chunks
        self.scenes = scenes
        self.mentions = [c for c in chunks if isinstance(c, Mention)]
        self._subs = [c for c in chunks if isinstance(c, Word) and c.cat == "sub"]
        self._marks = [k for k, token in enumerate(tokens) if token.low in _ENDS]
        self._said: dict[str, list[str]] = {}

    def bounds(self, i: int) -> tuple[int, int]:
        """Where the sentence of a token begins and ends."""
        k = bisect_left(self._marks, i)
        start = self._marks[k - 1] + 1 if k else 0
        return start, self._marks[k] if k < len(self._marks) else len(self.tokens)

    def within(self, start: int, end: int) -> list[Clause]:
        """What happens between two tokens, participles before nouns left out."""
        return [s for s in self.scenes if start <= s.event.i < end and s.event.premod_of is None]

    def low(self, i: int, j: int) -> str:
        """The words of some tokens, with a blank at either end."""
        return f" {' '.join([t.low for t in self.tokens[max(0, i) : j]])} "

    def _phrases(self, name: str) -> list[str]:
        """The phrases of a list that the text holds anywhere."""
        if name not in self._said:
            text = self.low(0, len(self.tokens))
            self._said[name] = [p for p in words()[name] if p in text and f" {p} " in text]
        return self._said[name]

    def says(self, name: str, i: int, j: int) -> str | None:
        """The first phrase of a list that stands between two tokens."""
        found = self.find(name, i, j)
        return self.low(*found).strip() if found is not None else None

    def find(self, name: str, start: int, end: int) -> tuple[int, int] | None:
        """Where the first phrase of a list stands whole between two tokens."""
        phrases = self._phrases(name)
        text = self.low(start, end) if phrases else ""
        for phrase in phrases:
            at = text.find(f" {phrase} ")
            if at >= 0:
                first = max(0, start) + text[:at].count(" ")
                return first, first + phrase.count(" ") + 1
        return None

    def scene_at(self, i: int, j: int) -> Clause | None:
        """The clause in which a number stands.

        Args:
            i: index of the first token of the number.
            j: index after the last one.
        """
        for scene in self.scenes:
            if any((m.i, m.j) == (i, j) for m in scene.event.mods):
                return scene
        start, end = self.bounds(i)
        here = [s for s in self.within(start, end) if s.event.name not in {"inert", "match"}]
        before = [s for s in here if s.event.i < i]
        return before[-1] if before else next(iter(here), None)

    def verb_at(self, i: int, j: int) -> Event | None:
        """What happens in the clause of a number; None where it only is somewhere.

        Args:
            i: index of the first token of the number.
            j: index after the last one.
        """
        scene = self.scene_at(i, j)
        clause = self.subordinate(i)
        if clause is not None and clause[2] in {"until", "till"}:  # "brakes until it does 30 km/h"
            main = self.within(self.bounds(i)[0], clause[0])
            told = [s for s in self.within(clause[0], i) if s.event.name != "move"] or main
            return told[-1].event if told else None
        if scene is None or clause is None or any((m.i, m.j) == (i, j) for m in scene.event.mods):
            return scene.event if scene is not None else None
        return scene.event if clause[0] <= scene.event.i else None

    def subordinate(self, i: int) -> tuple[int, int, str] | None:
        """The clause that sets something off in which a token stands: begin, end, opening words."""
        start, stop = self.bounds(i)
        opened = [c for c in self._subs if start <= c.i <= i]
        if not opened:
            return None
        word = opened[-1]
        opening = self.low(word.i, word.j).strip()
        begin = word.i
        marks = sum(t.low == "," for t in self.tokens[begin:i])
        if marks not in {0, _PARENTHESIS}:
            return None  # "when the ego, at 40 km/h, is 20 m away"
        end = next((k for k in range(i, stop) if self._closes(k)), stop)
        return begin, end, opening

    def own_subject(self, i: int) -> list[Entity]:
        """Whom a clause after "when", "while" … is about in which a token stands."""
        start, _ = self.bounds(i)
        opened = [c for c in self._subs if start <= c.i <= i]
        if not opened:
            return []
        inside = [m for m in self.mentions if opened[-1].i < m.i < i and m.entities]
        free = [m for m in inside if m.prep is None and not m.possessor]
        return list(free[0].entities) if free else []

    def said_of(self, i: int) -> Entity | None:
        """Whom a clause is about that says how far off one is: "a van that is still 60 m away".

        Args:
            i: index of the first token of the distance.
        """
        start, _ = self.bounds(i)
        opened = [
            c
            for c in self.chunks
            if isinstance(c, Word) and c.cat in {"rel", "sub"} and start <= c.i < i
        ]
        if not opened:
            return None
        if opened[-1].cat == "rel":
            named = [m for m in self.mentions if m.i < opened[-1].i and not m.possessor]
            return named[-1].entities[0] if named and named[-1].entities else None
        return next(iter(self.own_subject(i)), None)

    def _closes(self, k: int) -> bool:
        """Whether a clause ends at a token: a comma, "and then"."""
        pair = [t.low for t in self.tokens[k : k + 2]]
        return pair[:1] == [","] or pair == ["and", "then"]

    def adjacent(self, i: int) -> list[Entity]:
        """Who is named right before a token, forms of "to be" and adverbs skipped."""
        start, _ = self.bounds(i)
        for chunk in reversed(self.chunks):
            if chunk.j > i:
                continue
            if chunk.j <= start:
                return []
            if isinstance(chunk, Mention):
                between = self.low(chunk.j, i).split()
                owns = between in (
                    ["'s"],
                    ["'"],
                    ["("],
                )  # "the ego's 60 km/h", "a van (45 km/h)"
                return list(chunk.entities) if owns or not chunk.possessor else []
            if not isinstance(chunk, Word):
                return []
            if chunk.cat not in {"aux", "manner", "unknown", "possessive"} and chunk.value not in {
                "(",
                ":",
            }:
                return []
        return []

    def subject_before(self, i: int) -> list[Entity]:
        """Who a sentence is about up to a token: the subject of its last verb, or its first noun.

        Args:
            i: index of a token.
        """
        start, _ = self.bounds(i)
        own = self.adjacent(i) or self._owner(start, i)
        if own:
            return own
        before = [s for s in self.within(start, i) if s.actors]
        named = [m for m in self.mentions if start <= m.i < i and m.entities]
        free = [m for m in named if m.prep is None and not m.possessor]
        last = before[-1] if before else None
        if last is not None and free and free[-1].i > last.event.i:
            objects = {id(last.event.object)}
            later = [m for m in free if m.i > last.event.i and id(m) not in objects]
            if later:
                return list(later[-1].entities)
        if last is not None:
            return list(last.actors)
        return list((free or named)[-1].entities) if (free or named) else []

    def _owner(self, start: int, i: int) -> list[Entity]:
        """``its speed is 50 km/h``, ``my speed``: whose a measure is that opens a sentence."""
        word = self.tokens[start].low
        if word not in words()["whose"]:
            return []
        acting = any(s.actors for s in self.within(start, i))
        if acting or any(start < m.i < i for m in self.mentions):
            return []
        if word in {"my", "our"}:
            return [e for m in self.mentions for e in m.entities if e.ego][:1]
        before = [m for m in self.mentions if m.i < start and m.entities and not m.possessor]
        opening = self.bounds(start - 2)[0] if start > 1 else start
        said = [m for m in before if m.i >= opening and m.prep is None]
        return list((said or before)[0 if said else -1].entities) if before else []

    def part(self, i: int) -> tuple[int, list[Entity]]:
        """Where the part of a sentence begins in which a token stands, and who it is about.

        A comma or conjunction begins a part if it has a subject of its own.
        """
        start, _ = self.bounds(i)
        for k in range(i - 1, start - 1, -1):
            if k > start and self.tokens[k - 1].low not in words()["joints"]:
                continue
            free = [m for m in self.mentions if k <= m.i < i and m.entities and m.prep is None]
            if free and not free[0].possessor:
                return k, list(free[0].entities)
        return start, []

    def elided(self, i: int) -> tuple[int, list[Entity]] | None:
        """``A brakes with 4 m/s², B 1 s later``: where a part begins without a verb, and of whom.

        Args:
            i: index of a number.
        """
        begin, who = self.part(i)
        start, end = self.bounds(i)
        after = next((k for k in range(i, end) if self.tokens[k].low in words()["joints"]), end)
        told = [c for c in self.within(start, begin) if c.actors]
        if not who or not told or self.within(begin, after):
            return None
        return begin, who

    def phrase_after(self, j: int) -> tuple[Word, NounPhrase | None] | None:
        """A phrase of place right after a number: "ahead of the ego", "from the junction".

        Args:
            j: index after the number.
        """
        k = next((k for k, c in enumerate(self.chunks) if c.i >= j), len(self.chunks))
        while k < len(self.chunks) and getattr(self.chunks[k], "value", "") in {"(", ")"}:
            k += 1  # "26.7 m (1.6 s) behind a car"
        k = self._shared(k)
        word = self.chunks[k] if k < len(self.chunks) else None
        if not isinstance(word, Word):
            return None
        before = word.cat == "sub" and self.low(word.i, word.j).strip() == "before"
        before = before or self.tokens[word.i].low in {"short", "away", "distant"}
        if word.cat not in {"locus", "prep"} and not before:
            return word, None
        for chunk in self.chunks[k + 1 : k + 5]:
            if isinstance(chunk, Mention | Place | Thing):
                return word, chunk
            if isinstance(chunk, Event) or chunk.cat == "conj" or chunk.value in {",", ";", "."}:
                break  # "80 m ahead and a car …": ahead of nobody that is named
        return word, None

    def _shared(self, k: int) -> int:
        """``a van 60 m and a bus 75 m ahead of the ego``: the phrase after both holds for each."""
        joint, *rest = [*self.chunks[k : k + 4], None, None]
        rest = rest[isinstance(rest[0], Mention) :]
        measure, locus = (*rest, None, None)[:2]
        both = isinstance(joint, Word) and joint.value in {"and", "or"}
        told = isinstance(measure, Word) and measure.cat == "quantity"
        placed = isinstance(locus, Word) and locus.cat == "locus"
        return (
            next(m for m, c in enumerate(self.chunks) if c is locus)
            if both and told and placed
            else k
        )

    def named(self, noun: NounPhrase | None) -> list[Entity]:
        """Whom a noun means, or whose part it is ("the ego's front")."""
        if isinstance(noun, Mention) and noun.entities and not noun.possessor:
            return list(noun.entities)
        owner = noun if isinstance(noun, Mention) else getattr(noun, "owner", None)
        return list(owner.entities) if owner is not None else []

    def places(self, start: int, end: int, kinds: Iterable[str]) -> list[Place]:
        """Places of some kinds that are named between two tokens."""
        wanted = set(kinds)
        return [
            c
            for c in self.chunks
            if isinstance(c, Place) and start <= c.i < end and c.kind in wanted
        ]
