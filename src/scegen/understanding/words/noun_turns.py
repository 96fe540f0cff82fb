"""Sides that name a turn without the word: "an unprotected left", "during its left"."""

from __future__ import annotations

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term, begins
from scegen.understanding.words.tokens import Token, low_at

_NOUNS = ("verb", "place", "actor", "dir", "locus", "noted", "thing", "leg", "view")
_ARTICLES = frozenset({"det", "possessive"})


def names_a_turn(term: Term, terms: list[Term], tokens: list[Token]) -> bool:
    """Whether a bare side is a turn.

    Args:
        term: "left" or "right".
        terms: the terms before it.
        tokens: the tokens of the text.
    """
    if term.cat != "dir" or term.value not in {"left", "right"} or not terms:
        return False
    of = low_at(tokens, term.j) in {"of", "side", "hand"}
    if of or begins(tokens, term.j, *_NOUNS):
        return False  # the side of something
    k = len(terms) - 1
    if terms[k].value == "unprotected" or tokens[terms[k].i].low in {"protected", "permitted"}:
        return True
    while k > 0 and (terms[k].cat == "manner" or tokens[terms[k].i].low.endswith("ed")):
        k -= 1
    if terms[k].cat not in _ARTICLES or k == 0:
        return False
    before = tokens[terms[k - 1].j - 1]
    own = terms[k].cat == "possessive" and before.low != "to"
    own = own or tokens[terms[k].i].low in {"a", "an", "another"}
    if before.low in word_list("during"):
        return own or not (before.low == "after" or before.low in word_list("into"))
    return own and before.base in word_list("beginning")
