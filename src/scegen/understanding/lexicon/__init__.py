"""The words that the offline reader knows, as data, and their loader."""

from scegen.understanding.lexicon.loader import (
    Entry,
    Lexicon,
    Spelling,
    load,
    load_contexts,
    load_languages,
    load_spelling,
    load_ways,
    word_list,
)

__all__ = [
    "Entry",
    "Lexicon",
    "Spelling",
    "load",
    "load_contexts",
    "load_languages",
    "load_spelling",
    "load_ways",
    "word_list",
]
