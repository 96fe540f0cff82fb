"""Light lemmatisation: the base forms of a word that the lexicon knows, slips mended."""

from functools import lru_cache

from scegen.understanding.lexicon import load, word_list, word_lists

_MIN_STEM = 2


def _candidates(word: str) -> list[tuple[str, str]]:
    found: list[tuple[str, str]] = []
    for ending, base, form in (("ies", "y", "s"), ("ied", "y", "ed"), ("men", "man", "s")):
        if word.endswith(ending):
            found.append((word.removesuffix(ending) + base, form))
    if len(word) > _MIN_STEM + 1:
        if word.endswith("es"):
            found.append((word[:-2], "s"))
        if word.endswith("s") and not word.endswith("ss"):
            found.append((word[:-1], "s"))
    for ending, form in (("ing", "ing"), ("ed", "ed")):
        if word.endswith(ending):
            stem = word[: -len(ending)]
            doubled = len(stem) > _MIN_STEM and stem[-1] == stem[-2] and stem[-1] not in "aeiou"
            undoubled = [stem[:-1]] if doubled else []  # "stopp"
            found += [(base, form) for base in (stem, stem + "e", *undoubled)]
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
