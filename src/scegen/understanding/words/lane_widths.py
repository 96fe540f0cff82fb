"""How wide lanes are, and how long one that ends: "3.25 m lanes", "a merging lane 180 m long"."""

from __future__ import annotations

from collections.abc import Sequence

from scegen.scenario.roadway import AUXILIARY_LENGTHS_M, LANE_WIDTHS_M
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token, low_at


def lane_width_m(terms: Sequence[Term], k: int, tokens: list[Token]) -> float | None:
    """The width of the road's lanes, where a term gives one that can be built.

    Args:
        terms: the terms of the text.
        k: index of the term.
        tokens: its tokens.
    """
    length = _length_m(terms[k], LANE_WIDTHS_M)
    if length is None:
        return None
    near = _before_lanes(terms, k, tokens) or _after_lanes(terms, k, tokens)
    return length if near else None


def auxiliary_length_m(terms: Sequence[Term], k: int, tokens: list[Token]) -> float | None:
    """The length of a ramp's lane, or of one that ends, where a term gives one that can be built.

    Args:
        terms: the terms of the text.
        k: index of the term.
        tokens: its tokens.
    """
    term, length = terms[k], _length_m(terms[k], AUXILIARY_LENGTHS_M)
    if length is None:
        return None
    long = low_at(tokens, term.j) in word_list("long")
    if any("auxiliary" in t.data and t.i == term.j + long for t in terms[k + 1 : k + 3]):
        return length  # "a 180 m acceleration lane"
    lane = next((t for t in reversed(terms[:k]) if t.cat in {"place", "actor"}), None)
    if lane is None or "auxiliary" not in lane.data:
        return None
    between = {t.low for t in tokens[lane.j : term.i]}
    said = long or between & word_list("long") or between == {"of"}
    near = between <= word_list("between_widths") | word_list("long")
    return length if said and near else None


def _length_m(term: Term, limits: tuple[float, float]) -> float | None:
    """The length that a term gives exactly, within limits."""
    if (term.cat, term.value) != ("quantity", "length"):
        return None
    value = term.data["quantity"].exact
    return float(value.low) if limits[0] <= value.low == value.high <= limits[1] else None


def _before_lanes(terms: Sequence[Term], k: int, tokens: list[Token]) -> bool:
    """``3.25 m lanes``, ``3 m wide lanes``."""
    j = terms[k].j
    wide = low_at(tokens, j) in word_list("wide")
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
