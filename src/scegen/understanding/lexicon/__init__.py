"""The words that the offline reader knows, as data, and their loader."""

from scegen.understanding.lexicon.loader import (
    Entry,
    Lexicon,
    Spelling,
    load,
    load_languages,
    load_lists,
    load_spelling,
    load_ways,
)

__all__ = [
    "Entry",
    "Lexicon",
    "Spelling",
    "load",
    "load_languages",
    "load_lists",
    "load_spelling",
    "load_ways",
]
