"""Sides that name a turn without the word: "an unprotected left", "during its left"."""

from __future__ import annotations

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term, longest_match
from scegen.understanding.words.tokens import Token

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
    if not _bare(tokens, term):
        return False
    k = len(terms) - 1
    if terms[k].value == "unprotected" or tokens[terms[k].i].low in {"protected", "permitted"}:
        return True
    while k > 0 and (terms[k].cat == "manner" or tokens[terms[k].i].low.endswith("ed")):
        k -= 1
    if terms[k].cat not in _ARTICLES or k == 0:
        return False
    before = tokens[terms[k - 1].j - 1]
    definite = tokens[terms[k].i].low not in {"a", "an", "another"}
    if before.low in word_list("during"):
        own = (terms[k].cat == "possessive" and before.low != "to") or not definite
        return own if before.low in word_list("into") else before.low != "after" or own
    return before.base in word_list("beginning") and not (definite and terms[k].cat == "det")


def _bare(tokens: list[Token], term: Term) -> bool:
    """No noun follows that the side would belong to."""
    following = longest_match(tokens, term.j)
    if following is not None and tokens[term.j].low in {"of", "side", "hand"}:
        return False
    return following is None or not following.has(*_NOUNS)
