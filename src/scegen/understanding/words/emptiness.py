"""Words that add nothing: "5 m of air between them", "a van is all that hides him"."""

from __future__ import annotations

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.quantities import after_a_measure
from scegen.understanding.words.tokens import Token, low_at


def without_emptiness(tokens: list[Token]) -> list[Token]:
    """The tokens without the room that a length is of, and without what only stresses who does it.

    Args:
        tokens: of the text.
    """
    empty = {m for k in range(len(tokens)) for m in range(k, k + _empty(tokens, k))}
    return [token for k, token in enumerate(tokens) if k not in empty]


def _empty(tokens: list[Token], k: int) -> int:
    if tokens[k].low == "of":
        return _room(tokens, k)
    return _stress(tokens, k) if tokens[k].low in word_list("being") else 0


def _room(tokens: list[Token], k: int) -> int:
    """How many words ``of free road`` has before a word that says between whom."""
    end = k + 1
    while low_at(tokens, end) in word_list("free"):
        end += 1
    between = low_at(tokens, end + 1) in word_list("apart")
    empty = between and tokens[end].low in word_list("emptiness") and after_a_measure(tokens, k)
    return end + 1 - k if empty else 0


def _stress(tokens: list[Token], k: int) -> int:
    """How many words ``is all that`` has before a verb: who it is does that."""
    for phrase in word_list("stressing"):
        words = phrase.split()
        if [t.low for t in tokens[k + 1 : k + 1 + len(words)]] == words:
            return 1 + len(words)
    return 0
