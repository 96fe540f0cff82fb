"""``5 m of air between them``: what lies between two where nothing does."""

from __future__ import annotations

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.quantities import after_a_measure
from scegen.understanding.words.tokens import Token, low_at


def without_emptiness(tokens: list[Token]) -> list[Token]:
    """The tokens without what a length is said to be of, if that is nothing but room.

    Args:
        tokens: of the text.
    """
    left_out = {m for k in range(len(tokens)) for m in range(k, k + _room(tokens, k))}
    return [token for k, token in enumerate(tokens) if k not in left_out]


def _room(tokens: list[Token], k: int) -> int:
    """How many words ``of free road`` has before a word that says between whom."""
    if tokens[k].low != "of":
        return 0
    end = k + 1
    while low_at(tokens, end) in word_list("free"):
        end += 1
    between = low_at(tokens, end + 1) in word_list("apart")
    empty = between and tokens[end].low in word_list("emptiness") and after_a_measure(tokens, k)
    return end + 1 - k if empty else 0
