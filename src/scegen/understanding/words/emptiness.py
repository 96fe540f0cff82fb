"""``5 m of air between them``: what lies between two where nothing does."""

from __future__ import annotations

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.quantities import ends_a_quantity
from scegen.understanding.words.tokens import Token


def without_emptiness(tokens: list[Token]) -> list[Token]:
    """The tokens without what a length is said to be of, if that is nothing but room.

    Args:
        tokens: of the text.
    """
    found: list[Token] = []
    k = 0
    while k < len(tokens):
        length = _room(tokens, k) if tokens[k].low == "of" else 0
        found += [] if length else [tokens[k]]
        k += length or 1
    return found


def _room(tokens: list[Token], k: int) -> int:
    """How many words ``of free road`` has before a word that says between whom."""
    end = k + 1
    while end < len(tokens) and tokens[end].low in word_list("free"):
        end += 1
    if end + 1 >= len(tokens) or tokens[end].low not in word_list("emptiness"):
        return 0
    quantity = ends_a_quantity(tokens, k)
    told = quantity is not None and quantity.dimension == "length"
    return end + 1 - k if told and tokens[end + 1].low in word_list("apart") else 0
