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
    being = word_list("being")
    counts = {k: _room(tokens, k) for k, token in enumerate(tokens) if token.low == "of"}
    counts |= {k: _stress(tokens, k) for k, token in enumerate(tokens) if token.low in being}
    empty = {m for k, count in counts.items() for m in range(k, k + count)}
    return [token for k, token in enumerate(tokens) if k not in empty] if empty else tokens


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
