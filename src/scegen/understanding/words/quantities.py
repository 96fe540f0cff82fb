"""Numbers with their units: ``70 km/h``, ``30 to 50 mph``, ``over 20 m``, ``1.2 s``, ``0.4 g``."""

from __future__ import annotations

from dataclasses import dataclass

from scegen.scenario.model import Interval
from scegen.understanding.lexicon import load
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.tokens import Token
from scegen.units import UNITS

_RANGE_WORDS = frozenset({"to", "and", "or"})
_ABOVE = frozenset({"over", "above", "exceeding", "least", "beyond"})
_BELOW = frozenset({"under", "below", "most"})
_FEWER = frozenset({"less", "fewer", "slower", "lower", "shorter"})
_ABOUT = frozenset({"about", "around", "approximately", "roughly", "nearly", "almost", "some",
                    "approx", "circa", "ca"})  # fmt: skip
_LONGEST_UNIT = 4
_SPREAD = 0.1
"""How far "about" reaches to either side, and how far "over" reaches, as a share."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """A measured value in the text.

    Attributes:
        dimension: ``speed``, ``length``, ``time``, ``acceleration``, ``percentage``, or ``clock``.
        value: range in SI units (and percent), vague words ("about", "over") taken into account.
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

    @property
    def exact(self) -> Interval:
        """The range of the numbers themselves."""
        low, high = min(p.low for p in self.parts), max(p.high for p in self.parts)
        return Interval(low=low, high=high)


def _unit_at(tokens: list[Token], i: int) -> tuple[str, str, int] | None:
    """Dimension and name of the unit that begins at token ``i``, and its length in tokens."""
    units = load().units
    for length in range(min(_LONGEST_UNIT, len(tokens) - i), 0, -1):
        window = tokens[i : i + length]
        if window[-1].kind == "punct":
            continue
        options = [tuple(t.low for t in window)]
        options.append(tuple(t.forms[-1][0] for t in window))
        for spelling in options:
            if spelling in units:
                return *units[spelling], length
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
    unit = _unit_at(tokens, j)
    if unit is not None:
        dimension, name, length = unit
        end = j + length
        if end < len(tokens) and tokens[end].low in _RANGE_WORDS:
            second = _second_number(tokens, end + 1)
            if second is not None and second[1] == dimension:
                both = [_si(first.value, dimension, name), second[0]]
                return _build(tokens, i, second[2], both, dimension)
        return _build(tokens, i, end, [_si(first.value, dimension, name)], dimension)
    joiner = j < len(tokens) and tokens[j].low in _RANGE_WORDS
    second = _second_number(tokens, j + 1 if joiner else j)
    if second is not None and (joiner or tokens[i].kind == "number"):
        value, dimension, end, name = second
        return _build(tokens, i, end, [_si(first.value, dimension, name), value], dimension)
    return None


def _second_number(tokens: list[Token], j: int) -> tuple[float, str, int, str] | None:
    """Value, dimension, end and unit of the upper bound of a range."""
    if j >= len(tokens):
        return None
    number = number_at(tokens, j)
    if number is None or j + number.length >= len(tokens):
        return None
    unit = _unit_at(tokens, j + number.length)
    if unit is None:
        return None
    dimension, name, length = unit
    value = _si(number.value, dimension, name)
    return value, dimension, j + number.length + length, name


def _si(value: float, dimension: str, unit: str) -> float:
    return value * UNITS.get(dimension, {}).get(unit, 1.0)


def _build(tokens: list[Token], i: int, j: int, values: list[float], dimension: str) -> Quantity:
    low, high = min(values), max(values)
    parts = tuple(Interval(low=v, high=v) for v in values)
    value, note = Interval(low=low, high=high), None
    before = [t.low for t in tokens[max(0, i - 2) : i]]
    last = before[-1] if before else ""
    than = last == "than"
    if len(values) > 1:
        pass
    elif last in _ABOVE or (than and not _FEWER & {*before}):
        note = f"'{last}' is read as up to 20 % more"
        value = Interval(low=low, high=high * (1 + 2 * _SPREAD))
    elif last in _BELOW or than or before == ["up", "to"]:
        note = f"'{last}' is read as up to 20 % less"
        value = Interval(low=low * (1 - 2 * _SPREAD), high=high)
    elif last in _ABOUT:
        note = f"'{last}' is read as 10 % to either side"
        value = Interval(low=low * (1 - _SPREAD), high=high * (1 + _SPREAD))
    return Quantity(dimension, value, i, j, note, parts)


def after_a_measure(tokens: list[Token], i: int) -> bool:
    """``0.5 m to the left``, ``50 % on the right``: whether such a number ends before a token.

    Args:
        tokens: the tokens of the text.
        i: index of the token.
    """
    for k in range(max(0, i - _LONGEST_UNIT - 1), i):
        found = quantity_at(tokens, k)
        if found is not None and found.j == i:
            return found.dimension in {"length", "percentage"}
    return False
