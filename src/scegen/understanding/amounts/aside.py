"""Distances to the side: to which side, and from whose line."""

from __future__ import annotations

from scegen.scenario.model import Interval
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Side
from scegen.understanding.amounts.teller import Teller
from scegen.understanding.draft import Basis
from scegen.understanding.frames import Measured, words
from scegen.understanding.happenings import Amount, Apart

_SIDE_REACH = 14
_TOWARDS_THE_EDGE_M = Interval(low=0.3, high=0.9)
"""On one side of a lane, and still in it (lanes of 3 to 3.75 m, bodies of up to 2 m)."""


class Aside(Teller):
    """Reads how far to which side somebody is."""

    def within_the_lane(self) -> None:
        """``on the right-hand side of the lane``: off its middle, how far nobody says."""
        for clause in self._text.scenes:
            for place in [p for p in clause.places() if p.kind == "within_lane"]:
                sign = -1 if "right" in place.dirs else 1
                low, high = sorted(
                    sign * m for m in (_TOWARDS_THE_EDGE_M.low, _TOWARDS_THE_EDGE_M.high)
                )
                basis = Basis(place.i, place.j, "on one side of the lane and still in it")
                amount = Amount(Interval(low=low, high=high), basis)
                for who in [e for e in clause.actors if e.is_vehicle and not e.parked]:
                    apart = Apart(Measure.LATERAL_OFFSET_M, who, who, amount)
                    self._happenings.spacings.append(apart)

    def off_its_lane(self, number: Measured) -> bool:
        """``the ego stays 0.3 m left of its lane centre``: from where it should be itself."""
        who = self._text.subject_before(number.i)
        around = f"{number.around.before}{number.around.after}"
        said = any(f" {p} " in around for p in words()["lane_centre"])
        if not said or not any(e.ego or self._context.oncoming(e) for e in who):
            return False
        apart = Apart(Measure.LATERAL_OFFSET_M, who[0], who[0], self.signed(number))
        self._happenings.spacings.append(apart)
        return True

    def signed(self, number: Measured) -> Amount:
        """To the left is positive, to the right negative; the left where no side is said."""
        start, end = self._text.bounds(number.i)
        right, basis = self._toward(number, start, end)
        value = number.quantity.exact
        if right is None:
            reason = "the side is not said; the left is taken"
            return Amount(value, Basis(number.i, number.j, reason))
        return (
            Amount(Interval(low=-value.high, high=-value.low), basis)
            if right
            else Amount(value, basis)
        )

    def _toward(self, number: Measured, start: int, end: int) -> tuple[bool | None, Basis]:
        """Whether the side named next to a number is the right one, and the words for both."""
        tokens = self._text.tokens
        for k in range(number.j, min(number.j + 8, end)):
            if tokens[k].low in {"left", "right"}:
                return tokens[k].low == "right", Basis(number.i, k + 1)
            if tokens[k].kind in {"number", "punct"}:
                break
        for k in range(number.i - 1, max(start, number.i - _SIDE_REACH) - 1, -1):
            if tokens[k].low in {"left", "right"}:
                return tokens[k].low == "right", Basis(number.i, number.j)
        return None, Basis(number.i, number.j)

    def half(self, number: Measured) -> Side | None:
        """``the left 50 %``, ``the right half of its front (50 % overlap)``."""
        start, end = self._text.bounds(number.i)
        right, _ = self._toward(number, start, end)
        return None if right is None else Side.RIGHT if right else Side.LEFT
