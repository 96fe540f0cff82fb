"""Terms whose class only the words before them tell: "leaves its stop", "an unprotected left"."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.words.contexts import in_context
from scegen.understanding.words.lane_numbers import number_of_a_lane
from scegen.understanding.words.noun_turns import names_a_turn
from scegen.understanding.words.paces import doing
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token


def retag(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """The term as the words before it would have it.

    Args:
        term: the term.
        terms: the terms before it; some are changed in its light.
        tokens: the tokens of the text.
    """
    if term.cat == "punct":
        return term
    term = number_of_a_lane(in_context(term, terms, tokens), terms, tokens)
    if names_a_turn(term, terms, tokens):
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
    return term.cat in {"quantity", "num"} or (
        term.cat == "manner" and term.value in {"fast", "slow"}
    )
