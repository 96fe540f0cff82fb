"""How wide lanes are, and how long one that ends: "3.25 m lanes", "a merging lane 180 m long"."""

from __future__ import annotations

from collections.abc import Sequence

from scegen.scenario.roadway import AUXILIARY_LENGTHS_M, LANE_WIDTHS_M
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token, low_at


def size_of_lanes(terms: Sequence[Term], k: int, tokens: list[Token]) -> tuple[str, float] | None:
    """``lane_width_m``, or ``auxiliary_length_m`` (of a ramp's lane, or of one that ends).

    None where a term gives neither that can be built.
    """
    lanes = [t for t in terms if _is_lane(t) or _names_it(t, tokens)]
    ending = [t for t in terms if "auxiliary" in t.data]
    for field, named, limits, how in (
        ("lane_width_m", lanes, LANE_WIDTHS_M, "wide"),
        ("auxiliary_length_m", ending, AUXILIARY_LENGTHS_M, "long"),
    ):
        length = _length_m(terms[k], limits)
        if length is not None and _told_of(named, terms[k], tokens, how):
            return field, length
    return None


def _length_m(term: Term, limits: tuple[float, float]) -> float | None:
    """The length that a term gives exactly, within limits."""
    if (term.cat, term.value) != ("quantity", "length"):
        return None
    value = term.data["quantity"].exact
    return float(value.low) if limits[0] <= value.low == value.high <= limits[1] else None


def _told_of(lanes: list[Term], length: Term, tokens: list[Token], how: str) -> bool:
    """``3 m wide lanes``, ``lanes narrowed to 2.6 m``, ``a merging lane of 180 m``."""
    words = word_list(how)
    if any(lane.i == length.j + (low_at(tokens, length.j) in words) for lane in lanes):
        return True
    lane = next((t for t in reversed(lanes) if t.j <= length.i), None)
    if lane is None:
        return False
    begin = lane.j - (tokens[lane.j - 1].low in words)  # "lane width"
    between = {t.low for t in tokens[begin : length.i]}
    after = {t.low for t in tokens[length.j : length.j + 2]}
    told = not words.isdisjoint(between | after) or between == {"of"}
    return told and between <= word_list("between_widths") | words


def _names_it(term: Term, tokens: list[Token]) -> bool:
    """``lane width``."""
    words = [t.low for t in tokens[term.i : term.j]]
    return words[:1] == ["lane"] and words[-1] in word_list("wide")


def _is_lane(term: Term) -> bool:
    """A lane as any other of the road."""
    return (term.cat, term.value) == ("place", "lane") and not {"ranked", "dir"} & {*term.data}
