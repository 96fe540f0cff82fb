"""Numbers that a parameter of an OpenSCENARIO file decides: ``$name``, ``${expression}``.

An expression goes through the same functions as a column of numbers: it answers to numpy's
arithmetic, and writes down what was done to it. What is written keeps to version 1.1 of the
standard (``+ - * /``, ``pow``, ``sqrt``), which has no ``max``.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin

DECIMALS = 6
"""Of the numbers in an expression; esmini keeps as many of its value."""
_SUM, _PRODUCT, _ATOM = 1, 2, 3
"""How firmly the parts of a text hold together."""


@dataclass(frozen=True, slots=True)
class Expression(NDArrayOperatorsMixin):
    """A value by its text; ``low`` and ``high`` bound what it can be.

    The bounds hold where every parameter keeps to its own. They tell which side of a maximum
    always wins, so that it need not be written.
    """

    text: str
    low: float
    high: float
    firmness: int = _ATOM

    @classmethod
    def parameter(cls, name: str, low: float, high: float) -> Expression:
        """The parameter ``name``, which lies within ``[low, high]``."""
        return cls(f"${name}", low, high)

    @property
    def written(self) -> str:
        """As the value of an attribute: one parameter by its name, everything else in braces."""
        plain = self.text.startswith("$") and self.text[1:].replace("_", "").isalnum()
        return self.text if plain else f"${{{self.text}}}"

    def __array_ufunc__(
        self, ufunc: np.ufunc, method: str, *inputs: object, **options: object
    ) -> Expression:
        """Arithmetic with numbers and other expressions; NotImplemented for all else."""
        made = _MADE.get(ufunc)
        if made is None or method != "__call__" or options:
            return cast("Expression", NotImplemented)
        return made(*(_expression(item) for item in inputs))


Number = float | Expression
"""A number of a file: itself, or what a parameter makes of it."""


def written(value: Number) -> float | str:
    """A number as the library that writes the XML takes it."""
    return value.written if isinstance(value, Expression) else value


def _expression(item: object) -> Expression:
    if isinstance(item, Expression):
        return item
    number = float(item)  # type: ignore[arg-type]
    text = f"{number:.{DECIMALS}f}".rstrip("0").rstrip(".")
    return Expression(text if number >= 0.0 else f"({text})", number, number)


def _inner(part: Expression, firmness: int) -> str:
    return part.text if part.firmness >= firmness else f"({part.text})"


def _is(part: Expression, number: float) -> bool:
    return part.low == part.high == number and "$" not in part.text


def _add(a: Expression, b: Expression) -> Expression:
    if _is(a, 0.0) or _is(b, 0.0):
        return b if _is(a, 0.0) else a
    text = f"{_inner(a, _SUM)} + {_inner(b, _SUM)}"
    return Expression(text, a.low + b.low, a.high + b.high, _SUM)


def _subtract(a: Expression, b: Expression) -> Expression:
    if _is(b, 0.0):
        return a
    text = f"{_inner(a, _SUM)} - {_inner(b, _PRODUCT)}"
    return Expression(text, a.low - b.high, a.high - b.low, _SUM)


def _multiply(a: Expression, b: Expression) -> Expression:
    if _is(a, 1.0) or _is(b, 1.0):
        return b if _is(a, 1.0) else a
    low, high = _corners(a, b, lambda x, y: x * y)
    return Expression(f"{_inner(a, _PRODUCT)} * {_inner(b, _PRODUCT)}", low, high, _PRODUCT)


def _divide(a: Expression, b: Expression) -> Expression:
    if b.low <= 0.0 <= b.high:
        msg = f"{b.text} can be 0, nothing can be divided by it"
        raise ZeroDivisionError(msg)
    low, high = _corners(a, b, lambda x, y: x / y)
    return Expression(f"{_inner(a, _PRODUCT)} / {_inner(b, _ATOM)}", low, high, _PRODUCT)


def _power(a: Expression, b: Expression) -> Expression:
    if b.low != b.high or a.low < 0.0:
        msg = f"pow({a.text}, {b.text}): only powers of what cannot be negative are bounded"
        raise ValueError(msg)
    low, high = sorted((a.low**b.low, a.high**b.low))
    return Expression(f"pow({a.text}, {b.text})", low, high)


def _maximum(a: Expression, b: Expression) -> Expression:
    if a.low >= b.high or b.low >= a.high:
        return a if a.low >= b.high else b
    return _either(a, b, "+", max)


def _minimum(a: Expression, b: Expression) -> Expression:
    if a.high <= b.low or b.high <= a.low:
        return a if a.high <= b.low else b
    return _either(a, b, "-", min)


def _either(
    a: Expression, b: Expression, sign: str, of: Callable[[float, float], float]
) -> Expression:
    """The greater (``+``) or the lesser (``-``) of two: half of their sum and their distance."""
    apart = f"sqrt(pow({_inner(a, _SUM)} - {_inner(b, _PRODUCT)}, 2))"
    text = f"({_inner(a, _SUM)} + {_inner(b, _SUM)} {sign} {apart}) / 2"
    return Expression(text, of(a.low, b.low), of(a.high, b.high), _PRODUCT)


def _corners(
    a: Expression, b: Expression, of: Callable[[float, float], float]
) -> tuple[float, float]:
    values = [of(x, y) for x in (a.low, a.high) for y in (b.low, b.high)]
    return min(values), max(values)


_MADE: dict[Any, Callable[..., Expression]] = {
    np.add: _add,
    np.subtract: _subtract,
    np.multiply: _multiply,
    np.divide: _divide,
    np.power: _power,
    np.maximum: _maximum,
    np.minimum: _minimum,
}
