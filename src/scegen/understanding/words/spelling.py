"""Slips of one letter in long key words: "intersecton", "pedestrain"."""

from __future__ import annotations

from functools import lru_cache

from scegen.understanding.lexicon import word_lists
from scegen.understanding.words.lemmas import lemmas

_SHORTEST_KEY = 6
_SHORTEST_WORD = 5


def one_slip(written: str, meant: str) -> bool:
    """Whether one letter more, less or other, or two swapped neighbours, tell the words apart."""
    if written == meant or abs(len(written) - len(meant)) > 1:
        return False
    if len(written) != len(meant):
        longer, shorter = sorted((written, meant), key=len, reverse=True)
        return any(shorter == longer[:k] + longer[k + 1 :] for k in range(len(longer)))
    wrong = [k for k, (a, b) in enumerate(zip(written, meant, strict=True)) if a != b]
    if len(wrong) == 1:
        return True
    swapped = len(wrong) == 2 and wrong[1] == wrong[0] + 1
    return swapped and written[wrong[0]] == meant[wrong[1]] and written[wrong[1]] == meant[wrong[0]]


@lru_cache(maxsize=4096)
def meant(word: str) -> str | None:
    """The key word that an unknown word is a slip of, if exactly one is.

    First letters are seldom wrong, and many other words differ in them ("learning", "turning"):
    only words that begin alike count.
    """
    if not _SHORTEST_WORD <= len(word) <= 20 or word in word_lists("spelling")["real_words"]:
        return None
    fitting = {
        key
        for key in word_lists("spelling")["keys"]
        if len(key) >= _SHORTEST_KEY and key[0] == word[0] and one_slip(word, key)
    }
    bases = {lemmas(key)[-1][0] for key in fitting}
    return min(fitting, key=lambda key: (len(key), key)) if len(bases) == 1 else None
