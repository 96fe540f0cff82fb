"""Numbers with their units: ``70 km/h``, ``30 to 50 mph``, ``over 20 m``, ``1.2 s``, ``0.4 g``."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import product

from scegen.scenario.model import Interval
from scegen.understanding.lexicon import load, word_list
from scegen.understanding.words.numbers import ATOMS, COUNTED, PARTS, Number, number_at, share_at
from scegen.understanding.words.tokens import Token, low_at
from scegen.units import UNITS

OPENS = ATOMS | {"a", "half", "between"}
"""Words with which a quantity may begin."""
_RANGE_WORDS = frozenset({"to", "or"})
_ABOVE = frozenset({"over", "above", "exceeding", "beyond"})
_FEWER = frozenset({"less", "fewer", "slower", "lower", "shorter", "closer", "nearer", "smaller"})
_LONGEST_UNIT = 4
_PAIR = 2
_TEN = 10
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
        joined: whether they are several ("20 and 45 m"), not a range ("between 20 and 45 m").
    """

    dimension: str
    value: Interval
    i: int
    j: int
    note: str | None = None
    parts: tuple[Interval, ...] = ()
    joined: bool = False

    def each(self, count: int) -> list[Quantity]:
        """One of the numbers for each of so many, in order; else the whole for all of them."""
        if not self.joined or len(self.parts) != count:
            return [self] * count
        return self.singly

    @property
    def singly(self) -> list[Quantity]:
        """Its numbers, each by itself."""
        return [replace(self, value=p, parts=(p,), note=None, joined=False) for p in self.parts]

    @property
    def unsigned(self) -> Quantity:
        """The same without the sign of a figure below zero."""
        if self.value.low >= 0:
            return self
        value, *parts = map(_unsigned, (self.value, *self.parts))
        return replace(self, value=value, parts=tuple(parts))

    @property
    def exact(self) -> Interval:
        """The range of the numbers themselves."""
        low, high = min(p.low for p in self.parts), max(p.high for p in self.parts)
        return Interval(low=low, high=high) if len(self.parts) > 1 else self.parts[0]


def _unsigned(value: Interval) -> Interval:
    low, high = sorted((abs(value.low), abs(value.high)))
    return Interval(low=low, high=high)


def _unit_at(tokens: list[Token], i: int) -> tuple[str, str, int] | None:
    """Dimension and name of the unit that begins at token ``i``, and its length in tokens."""
    lexicon = load()
    first = tokens[i] if i < len(tokens) else None
    if first is None or not {first.low, first.base} & lexicon.unit_words:
        return None
    units = lexicon.units
    for length in range(min(_LONGEST_UNIT, len(tokens) - i), 0, -1):
        window = tokens[i : i + length]
        if window[-1].kind == "punct":
            continue
        for spelling in product(*((t.low, t.base) for t in window)):
            if spelling in units:
                return *units[spelling], length
    return None


def quantity_at(tokens: list[Token], i: int) -> Quantity | None:
    """The quantity whose first number stands at token ``i``; of several in a row, all of them."""
    row = _row_at(tokens, i)
    if len(row) == _PAIR and all(t.low != "and" for t in tokens[row[0].j : row[1].i]):
        row = [q for q in row[:1] if number_at(tokens, q.j - 1) is None]  # "in run 3, 50 km/h"
    if len(row) < _PAIR:
        return row[0] if row else None
    low, high = min(q.value.low for q in row), max(q.value.high for q in row)
    value, parts = Interval(low=low, high=high), tuple(q.value for q in row)
    return Quantity(row[0].dimension, value, i, row[-1].j, None, parts, joined=True)


def _row_at(tokens: list[Token], i: int, most: int = _TEN) -> list[Quantity]:
    """``70, 60 and 50 km/h``, ``70 km/h and about 50 km/h``, ``70/60/50 km/h``.

    No more than ten; times only with one unit: not "for 1.5 s and 4 s later".
    """
    one, number = _one_at(tokens, i), number_at(tokens, i)
    if one is None and (number is None or _names_a_lane(tokens, i, number)):
        return []
    j = one.j if one is not None else i + (number.length if number is not None else 0)
    k = j + (low_at(tokens, j) == ",")
    k += low_at(tokens, k) == "and"
    slash = k == j and one is None
    while low_at(tokens, k) in word_list("about"):
        k += 1
    timed = one is not None and one.dimension == "time"
    goes_on = slash or (k > j and not timed)
    rest = _row_at(tokens, k, most - 1) if goes_on and most > 1 and k < len(tokens) else []
    if slash:
        rest = [part for q in rest for part in q.singly]
    if one is None and rest:
        one = as_written(tokens, i, j, rest[-1])
    alike = one is not None and all(q.dimension == one.dimension for q in rest)
    return [q for q in (one, *(rest if alike else [])) if q is not None]


def _names_a_lane(tokens: list[Token], i: int, number: Number) -> bool:
    """``in lane 2 65 ft ahead``."""
    return low_at(tokens, i - 1) == "lane" and number.value < _TEN


def _one_at(tokens: list[Token], i: int) -> Quantity | None:
    if tokens[i].kind != "number" and tokens[i].low not in OPENS:
        return None
    spelled = tokens[i].kind != "number"
    share = share_at(tokens, i) if spelled else None
    if share is not None:
        return _build(tokens, i, i + share.length, [share.value], "percentage")
    opened = tokens[i].low == "between" and i + 1 < len(tokens)
    first = (_fraction(tokens, i) if spelled else None) or number_at(tokens, i + opened)
    if first is None:
        return None
    j = i + opened + first.length
    unit = _unit_at(tokens, j)
    more = unit is not None and _and_a_half(tokens, j + unit[2])  # "a metre and a half"
    end = j + (unit[2] if unit is not None else 0) + 3 * more
    joined = low_at(tokens, end) in _RANGE_WORDS or (opened and low_at(tokens, end) == "and")
    beside = unit is None and not (spelled or _names_a_lane(tokens, i, first))
    mark = _tolerance_mark(tokens, end)
    second = None
    if joined or beside or mark is not None:
        falls = unit if (low_at(tokens, i - 1), low_at(tokens, end)) == ("from", "to") else None
        second = _second_number(tokens, end + joined if mark is None else mark, falls)
    dimension, name = unit[:2] if unit is not None else second[1::2] if second else ("", "")
    value = _si(first.value + 0.5 * more, dimension, name)
    if second is not None and second[1] in {dimension, *(["percentage"] if mark else [])}:
        other = second[0] if second[1] == dimension else value * second[0] / 100  # "± 5 %"
        values = [value, other] if mark is None else [value - other, value + other]
        return _build(tokens, i, second[2], values, dimension)
    return None if opened or unit is None else _build(tokens, i, end, [value], dimension)


def _fraction(tokens: list[Token], i: int) -> Number | None:
    """``half a second``, ``half metre``, ``a quarter of a g``, ``a metre``."""
    lows = [t.low for t in tokens[i : i + 4]]
    if lows[0] == "half" and lows[1:2] in (["a"], ["an"]):
        return Number(0.5, 2)
    if lows[0] == "half":
        return Number(0.5, 1) if _unit_at(tokens, i + 1) is not None else None
    whole, part = COUNTED.get(lows[0]), PARTS.get(lows[1]) if len(lows) == 4 else None
    if whole is not None and part is not None and lows[2:] in (["of", "a"], ["of", "an"]):
        return Number(whole / part, 4)
    unit = _unit_at(tokens, i + 1) if lows[0] == "a" and len(lows) > 1 else None
    named = unit is not None and unit[0] == "length" and len(lows[1]) > 2
    led = low_at(tokens, i - 1)
    timed = not word_list("order").isdisjoint(lows[2:3]) or led == "within"
    timed = timed or (led in word_list("so_long") and low_at(tokens, i + 2) in {",", ".", ";", ""})
    named = named or (lows[1:2] == ["second"] and (timed or _and_a_half(tokens, i + 2)))
    if led in {"into", "in", "from"} or (led == "of" and low_at(tokens, i - 2) == "out"):
        return None  # "out of a yard"
    return Number(1.0, 1) if named else None  # "a second" may be another one


def _and_a_half(tokens: list[Token], j: int) -> bool:
    return [t.low for t in tokens[j : j + 3]] == ["and", "a", "half"]


def _tolerance_mark(tokens: list[Token], j: int) -> int | None:
    """Where a tolerance begins after ``±``, as in ``50 km/h ± 5 %``; None if none is marked."""
    lows = [t.low for t in tokens[j : j + 3]]
    if lows[:1] == ["±"] or lows[:2] == ["(", "±"]:
        return j + 1 + (lows[0] == "(")
    return j + 3 if lows == ["plus", "or", "minus"] else None


def _second_number(
    tokens: list[Token], j: int, alike: tuple[str, str, int] | None = None
) -> tuple[float, str, int, str] | None:
    """Value, dimension, end and unit of the upper bound of a range; without one, ``alike``."""
    if j >= len(tokens):
        return None
    number = number_at(tokens, j)
    if number is None:
        return None
    unit = _unit_at(tokens, j + number.length) or (alike and (*alike[:2], 0))
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
    value, note = parts[0] if len(parts) == 1 else Interval(low=low, high=high), None
    before, last = low_at(tokens, i - 2), low_at(tokens, i - 1)
    than = last == "than"
    denied = any(
        low_at(tokens, i - k) in {"no", "not", "n't"} for k in (3, 4)
    )  # "no less than 1 m"
    least = last == "least" or (than and denied and before in _FEWER)
    if len(values) > 1:
        pass
    elif least or last == "most" or (before, last) == ("up", "to") or (than and denied):
        note = f"the {'least' if least else 'most'} that is said is taken"
    elif (last in _ABOVE and not _goes_over(tokens, i)) or (than and before not in _FEWER):
        note = f"'{last}' is read as up to 20 % more"
        value = Interval(low=low, high=high * (1 + 2 * _SPREAD))
    elif last in {"under", "below"} or than:
        note = f"'{last}' is read as up to 20 % less"
        value = Interval(low=low * (1 - 2 * _SPREAD), high=high)
    elif last in word_list("about"):
        note = f"'{last}' is read as 10 % to either side"
        value = Interval(low=low * (1 - _SPREAD), high=high * (1 + _SPREAD))
    return Quantity(dimension, value, i, j, note, parts)


def _goes_over(tokens: list[Token], i: int) -> bool:
    """``moves over 30 m ahead``: a word of the verb, not of the number."""
    bases = {base for t in tokens[max(0, i - 2) : i - 1] for base, _ in t.forms}
    return low_at(tokens, i - 1) == "over" and not bases.isdisjoint(word_list("goes_over"))


def as_written(tokens: list[Token], i: int, j: int, other: Quantity) -> Quantity | None:
    """A number without a unit, in the unit of another quantity."""
    units = [u for k in range(other.i, other.j) if (u := _unit_at(tokens, k)) is not None]
    return in_unit(tokens, i, j, other.dimension, units[0][1]) if units else None


def in_unit(tokens: list[Token], i: int, j: int, dimension: str, unit: str) -> Quantity | None:
    """A number without a unit, in a given one."""
    number = number_at(tokens, i)
    if number is None:
        return None
    return _build(tokens, i, j, [_si(number.value, dimension, unit)], dimension)


def ends_a_quantity(tokens: list[Token], i: int) -> Quantity | None:
    """The quantity that ends right before a token, if one does."""
    begins = range(max(0, i - _LONGEST_UNIT - 1), max(0, i))
    found = (quantity_at(tokens, k) for k in begins)
    return next((q for q in found if q is not None and q.j == i), None)


def after_a_measure(tokens: list[Token], i: int) -> bool:
    """``0.5 m to the left``, ``50 % on the right``: whether such a number ends before a token."""
    found = ends_a_quantity(tokens, i)
    return found is not None and found.dimension in {"length", "percentage"}
