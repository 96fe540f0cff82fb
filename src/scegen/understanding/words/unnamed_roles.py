"""Ordinals and roles without article or noun: "First lead brakes, second stops"."""

from __future__ import annotations

from scegen.understanding.words.ordinals import POSITIONS
from scegen.understanding.words.terms import Term, term_at
from scegen.understanding.words.tokens import Token

_OPENERS = frozenset({"punct", "conj", "sub"})
_VERBAL = frozenset({"s", "ed"})


def with_articles(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """``First car stops, second brakes``: the first car, the second."""
    found: list[Term] = []
    named = {k for k in range(len(terms)) if _names(terms, k, tokens)}
    for k, term in enumerate(terms):
        word = tokens[term.i].low
        if k in named and (len(named) > 1 or word != "first"):
            found += [Term("det", "def", term.i, term.i), Term("label", word, term.i, term.j)]
        else:
            found.append(term)
    return found


def _names(terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """Whether an ordinal that opens a clause stands for a participant."""
    term = terms[k]
    if tokens[term.i].low not in POSITIONS or term.j - term.i != 1:
        return False
    before, after = term_at(terms, k - 1), term_at(terms, k + 1)
    if after is None or (before is not None and before.cat not in _OPENERS):
        return False
    acts = (after.cat == "verb" and after.form in _VERBAL) or after.cat in {"aux", "copy"}
    return acts or after.cat == "actor" or after.value in {"(", ","}
