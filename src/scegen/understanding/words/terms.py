"""Phrases of the lexicon as they occur in a text, with all meanings that they may have."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from scegen.understanding.lexicon import Entry, load, word_list
from scegen.understanding.lexicon.loader import Node
from scegen.understanding.words.tokens import Token


@dataclass(frozen=True, slots=True)
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


@dataclass(frozen=True, slots=True)
class Match:
    """A phrase of the lexicon found in the text, with all its meanings."""

    entries: tuple[Entry, ...]
    j: int
    form: str

    def has(self, *cats: str) -> bool:
        """Whether some meaning belongs to one of these classes."""
        return any(entry.cat in cats for entry in self.entries)

    def only(self, *cats: str) -> bool:
        """Whether every meaning belongs to one of these classes."""
        return all(entry.cat in cats for entry in self.entries)

    def get(self, *cats: str) -> Entry:
        """The meaning of the first of these classes that has one, else the first of all."""
        return next(
            (entry for cat in cats for entry in self.entries if entry.cat == cat), self.entries[0]
        )


def _step(node: Node, token: Token) -> list[tuple[Node, str]]:
    found = [(node.following[base], form) for base, form in token.forms if base in node.following]
    if "~" in node.following and token.low in word_list("whose"):
        found.append((node.following["~"], "base"))
    return found


def longest_match(tokens: list[Token], i: int) -> Match | None:
    """The longest phrase of the lexicon that begins at token ``i``, with all meanings.

    Two readings of equal length ("left": a side, or the past of "leave") are merged.
    """
    best: list[tuple[Node, str]] = []
    best_j = i
    states = [(load().root, "base")]
    j = i
    while states and j < len(tokens):
        reached: list[tuple[Node, str]] = []
        for node, form in states:
            for following, inflection in _step(node, tokens[j]):
                reached.append((following, form if form != "base" else inflection))
        j += 1
        ends = [(node, form) for node, form in reached if node.entries]
        if ends:
            best, best_j = ends, j
        states = reached
    if not best:
        return None
    entries = tuple(entry for node, _ in best for entry in node.entries)
    forms = [form for _, form in best if form != "base"]
    return Match(entries, best_j, forms[0] if forms else "base")
