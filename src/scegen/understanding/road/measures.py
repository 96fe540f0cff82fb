"""Numbers that are said of the road and of nobody on it: its limit, how far one sees, its bends."""

from __future__ import annotations

from collections.abc import Sequence

from scegen.scenario.model import Interval
from scegen.understanding.frames.loader import cues
from scegen.understanding.frames.windows import frame_of, window
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_ROLES = ("limit", "sight", "friction", "radius")
_NUMBERS = {"quantity": "quantity", "num": "number"}
"""Class of a term -> where its number stands."""


def role_of(terms: Sequence[Term], k: int, tokens: list[Token]) -> str:
    """What of the road a number measures, by the words around it alone; empty if nothing."""
    term = terms[k]
    if term.cat not in _NUMBERS or term.data.get(_NUMBERS[term.cat]) is None:
        return ""
    dimension = term.value if term.cat == "quantity" else "number"
    if cues(dimension, *_ROLES).isdisjoint(t.low for t in tokens):
        return ""
    ends = {t.j: t.i for t in terms if t.cat == "quantity"}
    around = window(tokens, term.i, last_of(terms, k).j, ends)
    return frame_of(dimension, value_of(terms, k).low, around, frozenset()).role


def value_of(terms: Sequence[Term], k: int) -> Interval:
    """The number as it is written: a range, or a range of one value."""
    if terms[k].cat == "quantity":
        exact: Interval = terms[k].data["quantity"].exact
        return exact
    ends = [float(t.data["number"]) for t in (terms[k], last_of(terms, k))]
    return Interval(low=min(ends), high=max(ends))


def last_of(terms: Sequence[Term], k: int) -> Term:
    """The last term of a number: ``0.3-0.4``, ``0.3 to 0.4``, ``between 0.3 and 0.4``."""
    between = k > 0 and terms[k - 1].value == "between"
    joined = terms[k + 1 : k + 2]
    steps = (
        2 if joined and (joined[0].value == "to" or (between and joined[0].value == "and")) else 1
    )
    upper = terms[k + steps] if k + steps < len(terms) and terms[k].cat == "num" else None
    return upper if upper is not None and "number" in upper.data else terms[k]
