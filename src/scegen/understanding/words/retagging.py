"""Terms whose class only the words before them tell: "leaves its stop", "an unprotected left"."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.contexts import in_context
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.paces import doing
from scegen.understanding.words.terms import Term, begins
from scegen.understanding.words.tokens import Token, low_at

_OF_A_NOUN = ("verb", "place", "actor", "dir", "locus", "noted", "thing", "leg", "view")
_ARTICLES = frozenset({"det", "possessive"})
_MOST_LANES = 6
"""More lanes than that are no lanes that one tells apart."""


def retag(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """The term as the words before it would have it.

    Some terms before it are changed in its light.
    """
    if term.cat == "punct":
        return term
    term = _number_of_a_lane(in_context(term, terms, tokens), terms, tokens)
    if _names_a_turn(term, terms, tokens):
        term = replace(term, cat="verb", value="turn", form="base", data={"way": term.value})
    if _speed(term) and doing(tokens, term.i):
        _as_motion(terms, tokens)
    return term


def _as_motion(terms: list[Term], tokens: list[Token]) -> None:
    """``doing about fifty``: driving."""
    k = next((k for k in range(len(terms) - 1, -1, -1) if terms[k].cat == "verb"), None)
    if k is not None and tokens[terms[k].i].base == "do":
        terms[k] = replace(terms[k], value="move", data={"drives": True})


def _speed(term: Term) -> bool:
    """Whether a term says how fast: "50 mph", "40 in a 30", or a bare number after "doing"."""
    paced = term.cat == "manner" and term.value in {"fast", "slow"}
    return paced or term.cat in {"quantity", "num"}


def _names_a_turn(term: Term, terms: list[Term], tokens: list[Token]) -> bool:
    """Whether a bare side is a turn."""
    if term.cat != "dir" or term.value not in {"left", "right"} or not terms:
        return False
    of = low_at(tokens, term.j) in {"of", "side", "hand", "one"}
    if of or begins(tokens, term.j, *_OF_A_NOUN):
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


def _number_of_a_lane(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """The term as the number of, or in, the lane that is named beside it.

    The number one lane is the one at the centre line.
    """
    if term.cat not in {"label", "place", "num"}:
        return term
    two_lane = term.cat == "label" and tokens[term.j - 1].low == "lane"
    number = number_at(tokens, term.i) if two_lane else None
    if number is not None and terms and _numbers(terms[-1], tokens):
        opening = terms.pop()  # "number two lane": no two-lane road
        data = {"ranked": True, "number": int(number.value)}
        return Term("place", "lane", opening.i, term.j, data=data)
    opening, told = terms[-2:] if len(terms) > 1 else (term, term)
    numbered = told.cat == "num" and 1 <= told.data["number"] <= _MOST_LANES
    if (term.cat, term.value) == ("place", "lane") and numbered and _numbers(opening, tokens):
        del terms[-2:]
        data = {**term.data, "ranked": True, "number": int(told.data["number"])}
        return replace(term, i=opening.i, data=data)
    lane, of = opening, told
    counted = (lane.cat, lane.value, of.value, term.cat) == ("place", "lane", "of", "num")
    if counted and 1 < term.data["number"] <= _MOST_LANES:
        del terms[-2:]  # "the middle lane of three"
        return replace(lane, j=term.j, data={**lane.data, "count": int(term.data["number"])})
    return term


def _numbers(term: Term, tokens: list[Token]) -> bool:
    return tokens[term.i].low in word_list("numbering")
