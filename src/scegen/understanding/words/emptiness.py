"""Words that add nothing: "5 m of air between them", "a van is all that hides him"."""

from __future__ import annotations

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.quantities import ends_a_quantity
from scegen.understanding.words.tokens import Token


def without_emptiness(tokens: list[Token]) -> list[Token]:
    """The tokens without the room that a length is of, and without what only stresses who does it.

    Args:
        tokens: of the text.
    """
    long = {k: _room(tokens, k) if token.low == "of" else _stress(tokens, k)
            for k, token in enumerate(tokens)}  # fmt: skip
    left_out = {m for k, length in long.items() for m in range(k, k + length)}
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


def _stress(tokens: list[Token], k: int) -> int:
    """How many words ``is all that`` has before a verb: who it is does that."""
    for phrase in word_list("stressing"):
        words = phrase.split()
        if [t.low for t in tokens[k + 1 : k + 1 + len(words)]] == words:
            return 1 + len(words) if tokens[k].low in word_list("being") else 0
    return 0
