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
    opening = (k for k, token in enumerate(tokens) if token.low == "of")
    left_out = {m for k in opening for m in range(k, k + _room(tokens, k))}
    return [token for k, token in enumerate(tokens) if k not in left_out]


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
