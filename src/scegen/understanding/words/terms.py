"""Phrases of the lexicon as they occur in a text, with all meanings that they may have."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from scegen.understanding.lexicon import Entry, load, word_list
from scegen.understanding.lexicon.loader import Node
from scegen.understanding.words.lemmas import lemmas
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


def term_at(terms: Sequence[Term], k: int) -> Term | None:
    """The term with an index, if there is one."""
    return terms[k] if 0 <= k < len(terms) else None


def cat_at(terms: Sequence[Term], k: int) -> str:
    """The class of the term with an index, empty where there is none."""
    return terms[k].cat if 0 <= k < len(terms) else ""


def begins(tokens: list[Token], i: int, *cats: str) -> bool:
    """Whether the longest phrase at token ``i`` has a meaning of one of these classes."""
    match = longest_match(tokens, i)
    return match is not None and match.has(*cats)


@lru_cache(maxsize=8192)
def _begins_nothing(word: str) -> bool:
    """Whether no phrase of the lexicon begins with a form of a word."""
    following = load().root.following
    return not any(base in following for base, _ in lemmas(word)) and "~" not in following


def longest_match(tokens: list[Token], i: int, end: int | None = None) -> Match | None:
    """The longest phrase of the lexicon that begins at token ``i``, with all meanings.

    Two readings of equal length ("left": a side, or the past of "leave") are merged.

    Args:
        tokens: the tokens of the text.
        i: index of the first token.
        end: index after the last token that it may take; None for all.

    Returns:
        The phrase, or None where none begins, as behind the last token.
    """
    last = len(tokens) if end is None else min(end, len(tokens))
    if i >= last or _begins_nothing(tokens[i].low):
        return None
    best: list[tuple[Node, str]] = []
    best_j = j = i
    states = [(load().root, "base")]
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
        states = reached
        ends = [state for state in reached if state[0].entries]
        if ends:
            best, best_j = ends, j
    if not best:
        return None
    if len(best) == 1:
        node, form = best[0]
        return Match(node.entries, best_j, form, node.cats)
    entries = tuple([entry for node, _ in best for entry in node.entries])
    cats = frozenset[str]().union(*(node.cats for node, _ in best))
    return Match(entries, best_j, next((form for _, form in best if form != "base"), "base"), cats)
