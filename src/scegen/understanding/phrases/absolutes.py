"""What is said of a light in a phrase of its own: "with the signal just turned green"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Word
from scegen.understanding.phrases.lookahead import ADVERBS

_REACH = 3


def absolute(event: Event, k: int, chunks: list[Chunk]) -> bool:
    """``with the lights having changed``: no participant does it.

    Args:
        event: a participle.
        k: its index among the chunks.
        chunks: the chunks of the text.
    """
    if event.form not in {"ed", "ing"} or event.nominal:
        return False
    for m in range(k - 1, max(-1, k - 1 - _REACH), -1):
        chunk = chunks[m]
        if not isinstance(chunk, Word) or chunk.cat not in ADVERBS:
            return False
        if (chunk.cat, chunk.value) == ("aux", "be"):
            return False  # "a van with the lights on is turning"
    return False
