"""Tells English from other languages, by the words that stand in nearly every sentence."""

from __future__ import annotations

import unicodedata
from functools import lru_cache

from scegen.errors import InputError
from scegen.understanding.lexicon import load, word_lists
from scegen.understanding.words.tokens import Token

_ENGLISH = "English"
_FEWEST = 3
_HALF = 0.5
_HINT = "Describe the situation in English, for example 'Two cars meet at a T-junction.'"


@lru_cache(maxsize=1)
def _languages() -> dict[str, list[str]]:
    """A word -> the languages in which it stands in nearly every sentence."""
    found: dict[str, list[str]] = {}
    for name, common in word_lists("languages").items():
        for word in common:
            found.setdefault(word, []).append(name)
    return found


def require_english(tokens: list[Token], text: str) -> None:
    """Refuses a text in another language.

    Raises:
        InputError: if it is plainly not English.
    """
    letters = [] if text.isascii() else [c for c in text if c.isalpha()]
    foreign = [c for c in letters if not unicodedata.name(c, "").startswith("LATIN")]
    if len(letters) > _FEWEST and len(foreign) > _HALF * len(letters):
        msg = "the description is not written in Latin letters; only English is read"
        raise InputError(msg, where="description", hint=_HINT)
    words = [t.text.lower() for t in tokens if t.kind == "word"]
    counts = dict.fromkeys(word_lists("languages"), 0)
    for word in words:
        for name in _languages().get(word, ()):
            counts[name] += 1
    english = counts.pop(_ENGLISH)
    likeliest = max(counts, key=lambda name: counts[name])
    if counts[likeliest] >= _FEWEST and counts[likeliest] > english + len(words) * 0.1:
        msg = f"the description seems to be written in {likeliest}; only English is read"
        raise InputError(msg, where="description", hint=_HINT)
    strange = 0 if english else sum(t.kind == "word" and _strange(t) for t in tokens)
    if strange >= _FEWEST and strange > _HALF * len(words):
        msg = "the description does not seem to be written in English; only English is read"
        raise InputError(msg, where="description", hint=_HINT)


def _strange(token: Token) -> bool:
    """Whether no form of a word is known to the lexicon."""
    known = load().words
    return token.low not in known and not any(form in known for form, _ in token.forms)
