"""Loads the lexicon files into one trie of phrases.

Each entry of a file has ``cat`` (word class), ``value`` (meaning within the class), ``words``
(phrases in base form) and further keys that stay available as ``data``.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache, lru_cache
from importlib.resources import files
from typing import Any

from scegen.scenario.parsing import parse

_ENTRY_FILES = ("participants", "roads", "events", "manner", "directions", "grammar",
                "environment", "things")  # fmt: skip


@dataclass(frozen=True, slots=True)
class Entry:
    """One meaning of a phrase."""

    cat: str
    value: str
    data: dict[str, Any] = field(hash=False)


@dataclass(slots=True)
class Node:
    """A trie node: the words that may follow, the meanings that end here, their classes."""

    following: dict[str, Node] = field(default_factory=dict)
    entries: tuple[Entry, ...] = ()
    cats: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class Lexicon:
    """All phrases, the irregular word forms and the names of units.

    Attributes:
        root: the trie of phrases.
        words: every single word that occurs in a phrase.
        irregular: word -> (base form, form).
        units: spelled unit, as a tuple of words -> its dimension and its name.
        unit_words: the words with which units begin.
    """

    root: Node
    words: frozenset[str]
    irregular: dict[str, tuple[str, str]]
    units: dict[tuple[str, ...], tuple[str, str]]
    unit_words: frozenset[str]


def read(name: str, package: str = __package__) -> Any:  # noqa: ANN401 - each file has its shape
    """What a file of a package holds."""
    text = files(package).joinpath(f"{name}.yaml").read_text(encoding="utf-8")
    return parse(text, where=f"{name}.yaml")


def _insert(root: Node, phrase: str, entry: Entry) -> None:
    node = root
    for word in phrase.split():
        node = node.following.setdefault(word, Node())
    node.entries = (*node.entries, entry)
    node.cats |= {entry.cat}


@lru_cache(maxsize=1)
def load() -> Lexicon:
    """The lexicon of the package, read once."""
    root = Node()
    words: set[str] = set()
    for name in _ENTRY_FILES:
        for record in read(name):
            extra = {k: v for k, v in record.items() if k not in {"cat", "value", "words"}}
            entry = Entry(record["cat"], record["value"], extra)
            for phrase in record["words"]:
                if not isinstance(phrase, str):
                    msg = f"{name}.yaml: {phrase!r} must be quoted"
                    raise TypeError(msg)
                _insert(root, phrase, entry)
                words.update(phrase.split())
    units = {
        tuple(spelling.split()): (dimension, unit)
        for dimension, units in read("units").items()
        for unit, spellings in units.items()
        for spelling in spellings
    }
    words.update(word for spelling in units for word in spelling)
    irregular = {word: (base, form) for word, (base, form) in read("irregular").items()}
    unit_words = frozenset(spelling[0] for spelling in units)
    return Lexicon(root, frozenset(words), irregular, units, unit_words)


@lru_cache(maxsize=1)
def load_contexts() -> list[dict[str, Any]]:
    """The rows that tell what a term is by the words around it."""
    return [*read("contexts"), *read("talk")]


@cache
def word_lists(file: str) -> dict[str, frozenset[str]]:
    """The lists of words that a file of the lexicon holds, by their names.

    Args:
        file: ``lists``, or ``languages``, ``spelling`` or ``ways`` for those of one purpose.

    Raises:
        TypeError: names a word that YAML takes for a truth value or a number.
    """
    lists = read(file)
    for name, words in lists.items():
        if not all(isinstance(word, str) for word in words):
            msg = f"{file}.yaml: what stands in {name!r} must be quoted"
            raise TypeError(msg)
    return {name: frozenset(words) for name, words in lists.items()}


@lru_cache(maxsize=1)
def abbreviations() -> dict[str, str]:
    """What is meant by each short form of a word; a form that nobody writes out means itself."""
    full: dict[str, list[str]] = read("abbreviations")
    return {s: s if word == "itself" else word for word, short in full.items() for s in short}


@cache
def known_words() -> frozenset[str]:
    """Every single word of the phrases and of the lists, but those that say nothing."""
    lists = word_lists("lists") | word_lists("around_numbers")
    said = (phrases for name, phrases in lists.items() if name not in {"asides", "citing"})
    return load().words.union(word for phrases in said for p in phrases for word in p.split())


@cache
def word_list(name: str) -> frozenset[str]:
    """The words of a list."""
    return (word_lists("lists") | word_lists("around_numbers"))[name]
