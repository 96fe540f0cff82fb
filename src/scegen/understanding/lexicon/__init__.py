"""The words that the offline reader knows, as data, and their loader."""

from scegen.understanding.lexicon.loader import Entry, Lexicon, load

__all__ = ["Entry", "Lexicon", "load"]
