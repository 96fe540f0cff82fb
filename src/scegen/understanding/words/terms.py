"""Phrases of the lexicon as they occur in a text, with all meanings that they may have."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, NamedTuple

from scegen.understanding.lexicon import Entry, load, word_list
from scegen.understanding.lexicon.loader import Node
from scegen.understanding.words.lemmas import lemmas
from scegen.understanding.words.quantities import quantity_at
from scegen.understanding.words.tokens import Token


@dataclass(slots=True, unsafe_hash=True)
class Term:
    """A phrase of the text with one meaning.

    Attributes:
        cat: word class, see the lexicon files; ``unknown`` if no entry matched.
        value: meaning within the class.
        i: index of the first token.
        j: index after the last token.
        form: inflection of the first inflected word: ``base``, ``s``, ``ed``, ``ing``.
        data: further keys of the entry.
        premod: a participle that stands before the noun it describes ("a speeding car").
    """

    cat: str
    value: str
    i: int
    j: int
    form: str = "base"
    data: dict[str, Any] = field(default_factory=dict, hash=False, compare=False)
    premod: bool = False


@dataclass(slots=True)
class Match:
    """A phrase of the lexicon found in the text, with all its meanings and their classes."""

    entries: tuple[Entry, ...]
    j: int
    form: str
    cats: frozenset[str]

    def has(self, *cats: str) -> bool:
        """Whether some meaning belongs to one of these classes."""
        return not self.cats.isdisjoint(cats)

    def only(self, *cats: str) -> bool:
        """Whether every meaning belongs to one of these classes."""
        return self.cats.issubset(cats)

    def get(self, *cats: str) -> Entry:
        """The meaning of the first of these classes that has one, else the first of all."""
        for cat in cats:
            if cat in self.cats:
                return next(entry for entry in self.entries if entry.cat == cat)
        return self.entries[0]


NOTHING = Term("", "", -1, -1)
"""What stands before the first term or chunk of a text, and behind the last."""


def term_at(terms: Sequence[Term], k: int) -> Term:
    """The term with an index; `NOTHING` before the text and behind it."""
    return terms[k] if 0 <= k < len(terms) else NOTHING


def cat_at(terms: Sequence[Term], k: int) -> str:
    """The class of the term with an index, empty where there is none."""
    return term_at(terms, k).cat


def begins(tokens: list[Token], i: int, *cats: str) -> bool:
    """Whether the longest phrase at token ``i`` has a meaning of one of these classes."""
    match = longest_match(tokens, i)
    return match is not None and match.has(*cats)


def _names_more(tokens: list[Token], j: int, phrase: _Phrase, end: int | None) -> bool:
    """``come to a stop sign``: whether the last word of a verb opens the name of a place."""
    if "verb" not in phrase.cats:
        return False
    place = longest_match(tokens, j - 1, end)
    return place is not None and place.j > j and place.has("place")


class _Phrase(NamedTuple):
    """What ends at some nodes: all meanings, the form, the classes."""

    entries: tuple[Entry, ...]
    form: str
    cats: frozenset[str]


@lru_cache(maxsize=8192)
def _opening(word: str) -> tuple[list[tuple[Node, str]], _Phrase | None, frozenset[str]]:
    """Where phrases go on behind a word, what it is alone, and which words may follow."""
    following = load().root.following
    states = [(following[base], form) for base, form in lemmas(word) if base in following]
    if "~" in following and word in word_list("whose"):
        states.append((following["~"], "base"))
    return states, _ending(states), frozenset(w for node, _ in states for w in node.following)


def _ending(states: list[tuple[Node, str]]) -> _Phrase | None:
    ends = [state for state in states if state[0].entries]
    if len(ends) < 2:
        return next((_Phrase(node.entries, form, node.cats) for node, form in ends), None)
    entries = tuple([entry for node, _ in ends for entry in node.entries])
    cats = frozenset[str]().union(*(node.cats for node, _ in ends))
    return _Phrase(entries, next((form for _, form in ends if form != "base"), "base"), cats)


def longest_match(tokens: list[Token], i: int, end: int | None = None) -> Match | None:
    """The longest phrase of the lexicon that begins at token ``i``, with all meanings.

    Two readings of equal length ("left": a side, or the past of "leave") are merged.

    It takes no token from ``end`` on. None where no phrase begins, as behind the last token.
    """
    last = len(tokens) if end is None else min(end, len(tokens))
    if i >= last:
        return None
    states, best, more = _opening(tokens[i].low)
    best_j = j = i + 1
    shorter = best, best_j
    if j < last and "~" not in more and more.isdisjoint([base for base, _ in tokens[j].forms]):
        states = []
    while states and j < last:
        token = tokens[j]
        j += 1
        reached: list[tuple[Node, str]] = []
        for node, form in states:
            following = node.following
            for base, inflection in token.forms:
                if base in following:
                    reached.append((following[base], inflection if form == "base" else form))
            if "~" in following and token.low in word_list("whose"):
                reached.append((following["~"], form))
        if token.low == "own" and tokens[j - 2].low in word_list("whose"):
            reached += states  # "applies its own brakes"
        states, ended = reached, _ending(reached)
        if ended is not None:
            shorter, (best, best_j) = (best, best_j), (ended, j)
    if best is not None and best_j > i + 1 and _names_more(tokens, best_j, best, end):
        best, best_j = shorter
    return Match(best.entries, best_j, best.form, best.cats) if best is not None else None


def noun_follows(tokens: list[Token], j: int) -> bool:
    """Whether a participant or thing is named at token ``j``, adjectives skipped."""
    for step in range(3):
        following = longest_match(tokens, j)
        if following is None and step == 0 and j < len(tokens) and tokens[j].kind == "word":
            j += 1  # "a slow milk truck"
            continue
        if following is None:
            return False
        if following.has("actor", "thing"):
            return not _needs_no_article(following, tokens)
        if not following.has("state", "label", "dir", "manner", "verb") or following.has("prep"):
            return following.has("view")
        if following.only("verb") and following.form not in {"ing", "ed"}:
            return False
        j = following.j
    return False


def _needs_no_article(noun: Match, tokens: list[Token]) -> bool:
    """Pronouns and names ("me", "V1", "vehicle 2"): no participle describes them."""
    if any("me" in e.data or "speaks" in e.data for e in noun.entries):
        return True
    after = tokens[noun.j] if noun.j < len(tokens) else None
    numbered = after is not None and after.kind == "number" and quantity_at(tokens, noun.j) is None
    return numbered and noun.form == "base"
