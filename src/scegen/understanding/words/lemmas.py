"""Light lemmatisation: the base forms of a word that the lexicon knows."""

from __future__ import annotations

from functools import lru_cache

from scegen.understanding.lexicon import load, word_list

_MIN_STEM = 2


def _undoubled(stem: str) -> list[str]:
    """``stopp`` -> ``stop``; English doubles the consonant before -ing and -ed."""
    doubled = len(stem) > _MIN_STEM and stem[-1] == stem[-2] and stem[-1] not in "aeiou"
    return [stem[:-1]] if doubled else []


def _candidates(word: str) -> list[tuple[str, str]]:
    found: list[tuple[str, str]] = []
    if word.endswith("ies"):
        found.append((word[:-3] + "y", "s"))
    if len(word) > _MIN_STEM + 1:
        if word.endswith("es"):
            found.append((word[:-2], "s"))
        if word.endswith("s") and not word.endswith("ss"):
            found.append((word[:-1], "s"))
    if word.endswith("ied"):
        found.append((word[:-3] + "y", "ed"))
    for ending, form in (("ing", "ing"), ("ed", "ed")):
        if word.endswith(ending):
            stem = word[: -len(ending)]
            found += [(base, form) for base in (stem, stem + "e", *_undoubled(stem))]
    return found


@lru_cache(maxsize=8192)
def lemmas(word: str) -> tuple[tuple[str, str], ...]:
    """Base forms with the inflection that leads to ``word``.

    Returns:
        Pairs (base, form), form one of ``base``, ``s``, ``ed``, ``ing``; the word itself comes
        first; only bases that occur in the lexicon follow it.
    """
    lexicon = load()
    found = [(word, "base")]
    if word in lexicon.irregular:
        found.append(lexicon.irregular[word])
    bases = lexicon.words - word_list("uninflected")  # "uses" are those of "use", not of "us"
    found += [(base, form) for base, form in _candidates(word) if base in bases]
    return tuple(dict.fromkeys(found))
