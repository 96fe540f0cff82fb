"""Traffic lights that do not work, or only flash."""

from __future__ import annotations

from itertools import takewhile

from scegen.understanding.entity import Basis
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_CLAUSES = frozenset({",", ".", ";", "when", "while", "as", "and", "before", "but"})
_BROKEN_REACH, _BROKEN_NEAR = 7, 4


def out_of_order(term: Term, tokens: list[Token]) -> Basis | None:
    """``non-working traffic lights``, ``traffic lights that are out of order``: all these words."""
    i, j = term.i, term.j
    before = [t.low for t in tokens[max(0, i - 3) : i]]
    if before[-1:] and before[-1] in word_list("broken"):
        return Basis(i - 1, j)
    for count in (2, 3):
        if " ".join(before[-count:]) in {*word_list("switched_off"), "non working"}:
            return Basis(i - count, j)
    after = _rest_of_clause(j, tokens)
    for m, word in enumerate(after):
        something_else = bool(m) and after[m - 1] in {"a", "an", "the"}
        if m < _BROKEN_NEAR and word in word_list("broken") and not something_else:
            return Basis(i, j + m + 1)
        for phrase in sorted(word_list("switched_off"), key=len, reverse=True):
            length = len(phrase.split())
            if " ".join(after[m : m + length]) == phrase:
                return Basis(i, j + m + length)
    return None


def flashing(term: Term, tokens: list[Token], colours: frozenset[str]) -> Basis | None:
    """``a flashing amber light``, ``a light that is flashing amber``."""
    i, j, words = term.i, term.j, word_list("flashing")
    if i and tokens[i - 1].low in words and colours & {t.low for t in tokens[i:j]}:
        return Basis(i - 1, j)
    after = _rest_of_clause(j, tokens)
    flashes = (m for m, word in enumerate(after[:-1]) if word in words)
    m = next((m for m in flashes if after[m + 1] in colours), None)
    return Basis(i, j + m + 2) if m is not None else None


def _rest_of_clause(j: int, tokens: list[Token]) -> list[str]:
    after = [t.low for t in tokens[j : j + _BROKEN_REACH]]
    return list(takewhile(lambda word: word not in _CLAUSES, after))
