"""Distances to the side: to which side, and from whose line."""

from __future__ import annotations

from scegen.scenario.model import Interval
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Side
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.chunks import Place
from scegen.understanding.entity import Basis
from scegen.understanding.happenings import Amount, Apart
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.patterns import noun

_REACH, _SIDE_REACH = 8, 14
SIDE_WORDS = {f"{s}{end}": s for s in ("left", "right") for end in ("", "ward", "wards")}
_BRINK = noun(["side", "+brink", "+of_road", "+kerb"])
_TOWARDS_THE_EDGE_M = (0.3, 0.9)
"""On one side of a lane, and still in it (lanes of 3 to 3.75 m, bodies of up to 2 m)."""


def within_the_lane(text: Telling) -> None:
    """``on the right-hand side of the lane``: off its middle, how far nobody says.

    So does "along the right edge of the road".
    """
    for clause in text.scenes:
        for place in [p for p in clause.places() if _within(p, text)]:
            basis = Basis(place.i, place.j, "on one side of the lane and still in it")
            low, high = _TOWARDS_THE_EDGE_M
            amount = _to("right" in place.dirs, Interval(low=low, high=high), basis)
            for who in [e for e in clause.actors if e.is_vehicle and not (e.parked or e.strip)]:
                text.found.spacings.append(Apart(Measure.LATERAL_OFFSET_M, who, who, amount))


def _within(place: Place, text: Telling) -> bool:
    at = place.prep and text.tokens[place.prep.i].low in word_list("on_strips")
    return place.kind == "within_lane" or bool(at and _BRINK(place, text.context))


def off_its_lane(figure: Figure) -> bool:
    """``the ego stays 0.3 m left of its lane centre``: from where it should be itself."""
    text, who = figure.text, figure.subject
    around = f"{figure.words_around.before}{figure.words_around.after}"
    said = any(f" {p} " in around for p in word_list("lane_centre"))
    if not said or not any(e.ego or text.context.oncoming(e) for e in who):
        return False
    text.found.spacings.append(Apart(Measure.LATERAL_OFFSET_M, who[0], who[0], signed(figure)))
    return True


def signed(figure: Figure) -> Amount:
    """To the left is positive, to the right negative; the left where no side is said."""
    side, j = toward(figure)
    reason = "the side is not said; the left is taken" if side is None else None
    return _to(side is Side.RIGHT, figure.quantity.exact, Basis(figure.i, j, reason))


def _to(right: bool, value: Interval, basis: Basis) -> Amount:
    return Amount(Interval(low=-value.high, high=-value.low) if right else value, basis)


def toward(figure: Figure) -> tuple[Side | None, int]:
    """The side that is named next to a number, and where the words for both end.

    ``the left 50 %``, ``the right half of its front (50 % overlap)``.
    """
    tokens, j = figure.text.tokens, figure.j
    for k in range(j, min(j + _REACH, figure.end)):
        if tokens[k].low in SIDE_WORDS:
            return Side(SIDE_WORDS[tokens[k].low]), k + 1
        if tokens[k].kind in {"number", "punct"}:
            break
    before = range(figure.i - 1, max(figure.start, figure.i - _SIDE_REACH) - 1, -1)
    said = (SIDE_WORDS[tokens[k].low] for k in before if tokens[k].low in SIDE_WORDS)
    return next(map(Side, said), None), j
