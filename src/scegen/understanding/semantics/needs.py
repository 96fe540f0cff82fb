"""What must stand in a clause for a condition of a row to hold, so that most rows are never asked.

A mark is a word for something that stands there: ``event brake``, ``lemma keep``, ``negated``,
``how late``, ``object lane``, ``at signal``, ``path into lane``. The same words in a condition tell
which marks it needs; where they say all that it asks, it is looked up and not tested.
"""

from __future__ import annotations

import re
from collections.abc import Set
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import product

from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.patterns import ANY, FRONT, listed
from scegen.understanding.words.tokens import Token

_FACTS = ("negated", "passive", "nominal")
_WORDS = ("event", "lemma", "form")
_NOUNS = ("path", "at", "object", "goal")


@dataclass(frozen=True, slots=True)
class _Need:
    """Marks of which one must be there; whether that is all that is asked; whether it is denied."""

    marks: frozenset[str]
    exact: bool = False
    denied: bool = False

    def holds(self, held: Set[str]) -> bool | None:
        if self.marks.isdisjoint(held):
            return self.denied
        return not self.denied if self.exact else None


@dataclass(frozen=True, slots=True)
class Known:
    """What the marks of a clause tell of a condition: of one of its alternatives, or of each."""

    needs: tuple[_Need | None, ...]

    @classmethod
    def of(cls, text: str) -> Known:
        """What is known of a condition as it is written."""
        return cls(tuple(map(_need, text.split(" or "))))

    @property
    def marks(self) -> frozenset[str]:
        """The marks on which it rests."""
        return frozenset().union(*(need.marks for need in self.needs if need is not None))

    def holds(self, held: Set[str]) -> bool | None:
        """Whether the condition holds where these marks stand; None where it has to be tested."""
        told = [need.holds(held) if need is not None else None for need in self.needs]
        return True if any(told) else None if None in told else False


def _need(text: str) -> _Need | None:
    """What a condition without alternatives needs; None where it may hold of any clause."""
    name, _, rest = text.partition(" ")
    if name == "not":
        need = _need(rest)
        return replace(need, denied=True) if need is not None else None
    if text in _FACTS or text == "verbless":
        return _Need(frozenset([text if text in _FACTS else "event "]), exact=True)
    if name in _WORDS:
        return _Need(frozenset(f"{name} {word}" for word in listed(rest)), exact=True)
    if name == "how":
        return _Need(frozenset(f"how {word}" for word in rest.split()))
    if name == "noun" and " +does." in rest:
        return _Need(frozenset([f"does {rest.rpartition('.')[2]}"]))
    if name == "some" and rest.startswith("@"):
        return _Need(_of_nouns("path", [*re.split("[+-]", rest[1:])[:1], "who"]).marks)
    return _of_nouns(name, rest.split()) if name in _NOUNS and rest[0] != "^" else None


def _of_nouns(name: str, pattern: list[str]) -> _Need:
    noun = pattern[1:] if name == "path" else pattern
    kinds = [kind.partition(".")[0] for kind in (noun or [ANY])[0].split("|")]
    openings = _openings(pattern[0]) if name == "path" else []
    where = "at" if name == "goal" else name
    parts = product([where], openings, kinds) if openings else product([where], kinds)
    whole = len(noun) <= 1 and not any("." in word for word in noun)
    plain = name != "goal" and (name != "path" or _plain(pattern[0]))
    return _Need(frozenset(map(" ".join, parts)), whole and plain)


def _plain(openings: str) -> bool:
    return not any(w[0] in "!~&" or "<" in w or w == FRONT for w in openings.split("|"))


def _openings(written: str) -> list[str]:
    """By which marks the prepositions of a pattern are told; by any, if not by what they are."""
    if not _plain(written.removeprefix("&")):
        return [ANY]
    found: list[str] = []
    for word in written.removeprefix("&").split("|"):
        lists = word_list(word[2:]) if word.startswith("=@") else None
        found += [word] if lists is None else [f"={low}" for low in lists]
    return found


def _kinds(noun: NounPhrase | Event | None) -> tuple[str, ...]:
    if noun is None:
        return ANY, "none"
    if isinstance(noun, Place):
        return ANY, "named", "place", noun.kind
    if isinstance(noun, Mention | Thing):
        return ANY, "named", "who" if isinstance(noun, Mention) else "thing"
    return ANY, "named"


@lru_cache(maxsize=4096)
def _of_phrase(value: str, low: str, kinds: tuple[str, ...]) -> frozenset[str]:
    marks = map(" ".join, product(["path"], [ANY, value, f"={low}"], kinds))
    return frozenset(marks).union(f"at {kind}" for kind in kinds if "place" in kinds)


@lru_cache(maxsize=4096)
def _of_verb(
    lemma: str, form: str, kinds: tuple[str, ...], facts: tuple[bool, ...]
) -> frozenset[str]:
    marks = {f"lemma {lemma}", f"form {form}", *(f"object {kind}" for kind in kinds)}
    marks |= {f"at {kind}" for kind in kinds if "place" in kinds}
    return frozenset(marks).union(name for name, held in zip(_FACTS, facts, strict=True) if held)


def marks_of(event: Event, tokens: list[Token]) -> frozenset[str]:
    """All marks of a clause but its event, which rows may rename.

    Args:
        event: what happens.
        tokens: the tokens of the text.
    """
    facts = (event.negated, event.passive, event.nominal)
    own = _of_verb(event.lemma, event.form, _kinds(event.object), facts)
    phrases = [
        _of_phrase(p.word.term.value, tokens[p.word.i].low, _kinds(p.target)) for p in event.pps
    ]
    manner = [f"how {m.value}" for e in event.upwards() for m in e.mods if m.cat == "manner"]
    does = [f"does {h.data['does']}" for m in event.subject for h in m.heads if "does" in h.data]
    return own.union(manner, does, *phrases)
