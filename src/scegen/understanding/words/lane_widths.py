"""How wide lanes are: "lanes 2.75 m wide", "3.25 m lanes", "the lane width is 11 ft"."""

from __future__ import annotations

from collections.abc import Sequence

from scegen.scenario.roadway import LANE_WIDTHS_M
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token


def lane_width_m(terms: Sequence[Term], k: int, tokens: list[Token]) -> float | None:
    """The width of the road's lanes, where a term gives one that can be built.

    Args:
        terms: the terms of the text.
        k: index of the term.
        tokens: its tokens.
    """
    term = terms[k]
    if (term.cat, term.value) != ("quantity", "length"):
        return None
    value = term.data["quantity"].exact
    low, high = LANE_WIDTHS_M
    said = low <= value.low == value.high <= high
    if said and (_before_lanes(terms, k, tokens) or _after_lanes(terms, k, tokens)):
        return float(value.low)
    return None


def _before_lanes(terms: Sequence[Term], k: int, tokens: list[Token]) -> bool:
    """``3.25 m lanes``, ``3 m wide lanes``."""
    j = terms[k].j
    wide = j < len(tokens) and tokens[j].low in word_list("wide")
    return any(_is_lane(t) and t.i == j + wide for t in terms[k + 1 : k + 3])


def _after_lanes(terms: Sequence[Term], k: int, tokens: list[Token]) -> bool:
    """``lanes only 2.75 m wide``, ``a lane width of 3 m``, ``lanes narrowed to 2.6 m``."""
    lane = next((t for t in reversed(terms[:k]) if _is_lane(t) or _names_it(t, tokens)), None)
    if lane is None:
        return False
    between = {t.low for t in tokens[lane.j - _names_it(lane, tokens) : terms[k].i]}
    after = {t.low for t in tokens[terms[k].j : terms[k].j + 2]}
    said = (between | after) & word_list("wide")
    return bool(said) and between <= word_list("between_widths") | word_list("wide")


def _names_it(term: Term, tokens: list[Token]) -> bool:
    """``lane width``."""
    words = [t.low for t in tokens[term.i : term.j]]
    return words[0] == "lane" and words[-1] in word_list("wide")


def _is_lane(term: Term) -> bool:
    """A lane as any other of the road."""
    return (term.cat, term.value) == ("place", "lane") and not {"ranked", "dir"} & {*term.data}
