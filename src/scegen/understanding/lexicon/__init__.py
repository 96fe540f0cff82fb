"""The words that the offline reader knows, as data, and their loader."""

from scegen.understanding.lexicon.loader import (
    Entry,
    Lexicon,
    abbreviations,
    known_words,
    load,
    load_contexts,
    word_list,
    word_lists,
)

__all__ = [
    "Entry",
    "Lexicon",
    "abbreviations",
    "known_words",
    "load",
    "load_contexts",
    "word_list",
    "word_lists",
]
