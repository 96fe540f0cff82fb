"""Tells a description of traffic from other text."""

from __future__ import annotations

from scegen.errors import NotTrafficError
from scegen.scenario.vocabulary import ANIMALS
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_PLACES = frozenset(
    {"junction", "road", "highway", "lane", "crosswalk", "stop_sign", "yield_sign", "ramp",
     "access", "sidewalk", "centerline", "bike_lane", "bus_stop", "shoulder"}
)  # fmt: skip
_DRIVING = frozenset(
    {"overtake", "lane_change", "brake", "hard_brake", "tailgate", "swerve", "cut_off", "park",
     "cut_in", "pull_out", "u_turn", "unpark", "pull_over"}
)  # fmt: skip
_HINTS = frozenset({"pass", "stop", "slow", "accelerate", "speed", "reverse", "collide", "follow",
                    "dash", "breach", "yield", "cross"})  # fmt: skip
_WAYS = frozenset({"turn", "move"})
_ENOUGH = 2
"""So many hints, none of which would do alone, make a story of the road."""
_EXAMPLE = "For example: 'A car turns left at a T-intersection while a pedestrian crosses.'"


def require_traffic(terms: list[Term], tokens: list[Token]) -> None:
    """Refuses text in which nothing belongs to traffic.

    Raises:
        NotTrafficError: if there is neither a participant nor a road.
    """
    if any(_about_traffic(term, tokens) for term in terms):
        return
    if sum(_hints_at_traffic(terms, k, tokens) for k in range(len(terms))) >= _ENOUGH:
        return
    msg = "the text does not describe a traffic situation: it names no road and no vehicle"
    raise NotTrafficError(msg, where="description", hint=_EXAMPLE)


def _about_traffic(term: Term, tokens: list[Token]) -> bool:
    if term.cat == "place":
        return term.value in _PLACES or (term.value == "signal" and term.j - term.i > 1)
    if term.cat == "actor":
        words = {t.low for t in tokens[term.i : term.j]}
        return term.value not in ANIMALS and not words & (
            word_list("relevance_first_person") | word_list("people")
        )
    if term.cat == "verb":
        road = {t.low for t in tokens[term.i : term.j]} & word_list("roads")  # "runs into the road"
        return term.value in _DRIVING or bool(road) or tokens[term.i].forms[-1][0] == "drive"
    return term.cat == "quantity" and term.value == "speed"


def _hints_at_traffic(terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """``the guy behind me``, ``turns left``, ``ran the light``: said of the road, but not only."""
    term = terms[k]
    after = terms[k + 1] if k + 1 < len(terms) else None
    if term.cat == "verb":
        loud = tokens[term.j - 1].forms[-1][0] in word_list("loud")
        sided = term.value in _WAYS and after is not None and after.cat == "dir"
        towards = term.value == "approach" and after is not None and "me" in after.data
        return term.value in _HINTS or sided or loud or towards or "way" in term.data
    if term.cat == "locus":
        return after is not None and "me" in after.data
    if term.cat == "manner":
        return term.value in {"fast", "slow", "wrong_way", "close"}
    lamps = (term.cat, term.value) == ("noted", "lights")
    return lamps or (term.cat == "place" and term.value in {"signal", "path", "middle", "flank"})
