"""Speeds and distances with their units: ``70 km/h``, ``30 to 50 mph``, ``over 45 mph``."""

from __future__ import annotations

from dataclasses import dataclass

from scegen.scenario.model import Interval
from scegen.understanding.lexicon import load
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.tokens import Token
from scegen.units import SPEED_UNITS_MPS, speed_mps

_RANGE_WORDS = frozenset({"to", "and", "or"})
_ABOVE = frozenset({"over", "above", "exceeding", "than", "least"})
_BELOW = frozenset({"under", "below", "to", "most"})
_ABOUT = frozenset({"about", "around", "approximately", "roughly", "nearly", "almost", "some"})
_LONGEST_UNIT = 4
_SPREAD = 0.1
"""How far "about" reaches to either side, and how far "over" reaches, as a share."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """A measured value in the text.

    Attributes:
        dimension: ``speed`` or ``other`` (distances and times, which no field holds).
        value: range in m/s for speeds, in the written unit otherwise.
        i: index of the first token.
        j: index after the last token.
        note: how a vague word was read, if there was one.
        parts: the numbers one by one, as they are written.
    """

    dimension: str
    value: Interval
    i: int
    j: int
    note: str | None = None
    parts: tuple[Interval, ...] = ()


def _unit_at(tokens: list[Token], i: int) -> tuple[str, int] | None:
    """The unit that begins at token ``i`` with its length in tokens."""
    units = load().units
    for length in range(min(_LONGEST_UNIT, len(tokens) - i), 0, -1):
        window = tokens[i : i + length]
        if window[-1].kind == "punct":
            continue
        options = [tuple(t.low for t in window)]
        options.append(tuple(t.forms[-1][0] for t in window))
        for spelling in options:
            if spelling in units:
                return units[spelling], length
    return None


def quantity_at(tokens: list[Token], i: int) -> Quantity | None:
    """The quantity whose first number stands at token ``i``.

    Args:
        tokens: all tokens of the text.
        i: index of the token to look at.

    Returns:
        The quantity, or None where no number with a unit stands.
    """
    first = number_at(tokens, i)
    if first is None:
        return None
    j = i + first.length
    numbers = [first.value]
    unit = _unit_at(tokens, j)
    if unit and j + unit[1] < len(tokens) and tokens[j + unit[1]].low in _RANGE_WORDS:
        second = _second_number(tokens, j + unit[1] + 1)
        if second and second[1] == unit[0]:
            return _build(tokens, i, second[2], [*numbers, second[0]], unit[0])
    if unit:
        return _build(tokens, i, j + unit[1], numbers, unit[0])
    joiner = j < len(tokens) and tokens[j].low in _RANGE_WORDS
    second = _second_number(tokens, j + 1 if joiner else j)
    if second and (joiner or tokens[i].kind == "number"):
        return _build(tokens, i, second[2], [*numbers, second[0]], second[1])
    return None


def _second_number(tokens: list[Token], j: int) -> tuple[float, str, int] | None:
    """Number, unit and end of the upper bound of a range."""
    if j >= len(tokens):
        return None
    number = number_at(tokens, j)
    if number is None or j + number.length >= len(tokens):
        return None
    unit = _unit_at(tokens, j + number.length)
    return (number.value, unit[0], j + number.length + unit[1]) if unit else None


def _build(tokens: list[Token], i: int, j: int, numbers: list[float], unit: str) -> Quantity:
    if unit not in SPEED_UNITS_MPS:
        low, high = min(numbers), max(numbers)
        return Quantity("other", Interval(low=low, high=high), i, j)
    values = [speed_mps(value, unit) for value in numbers]
    low, high = min(values), max(values)
    before = tokens[i - 1].low if i else ""
    if len(values) > 1:
        parts = tuple(Interval(low=v, high=v) for v in values)
        return Quantity("speed", Interval(low=low, high=high), i, j, None, parts)
    if before in _ABOVE:
        note = f"'{before}' is read as up to 20 % more"
        return Quantity("speed", Interval(low=low, high=high * (1 + 2 * _SPREAD)), i, j, note)
    if before in _BELOW:
        note = f"'{before}' is read as up to 20 % less"
        return Quantity("speed", Interval(low=low * (1 - 2 * _SPREAD), high=high), i, j, note)
    if before in _ABOUT:
        note = f"'{before}' is read as 10 % to either side"
        spread = Interval(low=low * (1 - _SPREAD), high=high * (1 + _SPREAD))
        return Quantity("speed", spread, i, j, note)
    return Quantity("speed", Interval(low=low, high=high), i, j)
