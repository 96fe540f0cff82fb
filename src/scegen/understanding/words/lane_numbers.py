"""Lanes told apart by a number: "the number two lane", "the middle lane of three"."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_MOST = 6
"""More lanes than that are no lanes that one tells apart."""


def number_of_a_lane(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """The term as the number of, or in, the lane that is named beside it.

    The number one lane is the one at the centre line.

    Args:
        term: a term.
        terms: the terms before it; those that become part of the lane are taken away.
        tokens: the tokens of the text.
    """
    two_lane = term.cat == "label" and tokens[term.j - 1].low == "lane"
    number = number_at(tokens, term.i) if two_lane else None
    if number is not None and terms and _numbers(terms[-1], tokens):
        opening = terms.pop()  # "number two lane": no two-lane road
        data = {"ranked": True, "number": int(number.value)}
        return Term("place", "lane", opening.i, term.j, data=data)
    if (term.cat, term.value) == ("place", "lane") and _numbered(terms, tokens):
        told = terms.pop()
        opening = terms.pop()
        data = {**term.data, "ranked": True, "number": int(told.data["number"])}
        return replace(term, i=opening.i, data=data)
    lane, of = terms[-2:] if len(terms) > 1 else (term, term)
    counted = (lane.cat, lane.value, of.value, term.cat) == ("place", "lane", "of", "num")
    if counted and 1 < term.data["number"] <= _MOST:
        del terms[-2:]  # "the middle lane of three"
        return replace(lane, j=term.j, data={**lane.data, "count": int(term.data["number"])})
    return term


def _numbered(terms: list[Term], tokens: list[Token]) -> bool:
    if len(terms) < 2 or terms[-1].cat != "num":
        return False
    small = 1 <= terms[-1].data["number"] <= _MOST
    return small and _numbers(terms[-2], tokens)


def _numbers(term: Term, tokens: list[Token]) -> bool:
    return tokens[term.i].low in word_list("numbering")
