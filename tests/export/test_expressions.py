"""Expressions: what is written means what numpy would have computed."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.export.expressions import Expression, written

NAMES = {"a": (-5.0, 7.0), "b": (0.5, 30.0), "c": (-40.0, -1.0)}
NUMBERS = st.floats(-50, 50).map(lambda v: round(v, 4))
LEAVES = st.one_of(NUMBERS, st.sampled_from(sorted(NAMES)))


def _trees(inner):
    two = st.tuples(st.sampled_from(("add", "subtract", "multiply", "maximum", "minimum")), inner)
    return st.tuples(two, inner)


TREES = st.recursive(LEAVES, _trees, max_leaves=8)


def value_of(tree, values):
    """The tree with numbers or symbols at its leaves, by numpy's functions."""
    if isinstance(tree, str):
        return values[tree]
    if isinstance(tree, float):
        return tree
    (name, first), second = tree
    return getattr(np, name)(value_of(first, values), value_of(second, values))


def computed(text, values):
    """What a player makes of an attribute."""
    for name, value in values.items():
        text = text.replace(f"${name}", f"({value!r})")
    return eval(text.strip("${}"), {"__builtins__": {}}, {"sqrt": sqrt, "pow": pow})  # noqa: S307


SYMBOLS = {name: Expression.parameter(name, *bounds) for name, bounds in NAMES.items()}


@given(TREES, st.data())
def test_means_what_was_computed(tree, data):
    values = {
        name: data.draw(st.floats(low, high), label=name) for name, (low, high) in NAMES.items()
    }
    made, right = value_of(tree, SYMBOLS), float(value_of(tree, values))
    if not isinstance(made, Expression):
        assert made == right
        return
    size = max(abs(made.low), abs(made.high), 1.0)
    assert computed(made.written, values) == pytest.approx(right, abs=1e-4 * size)
    assert made.low - 1e-4 * size <= right <= made.high + 1e-4 * size


def test_quotients_and_squares():
    a, b = Expression.parameter("a", 2.0, 4.0), Expression.parameter("b", 1.0, 3.0)
    made = (a**2 - b**2) / (2 * b)
    assert made.written == "${(pow($a, 2) - pow($b, 2)) / (2 * $b)}"
    assert computed(made.written, {"a": 3.0, "b": 2.0}) == pytest.approx((9 - 4) / 4)
    assert made.low <= (4 - 9) / 2
    assert made.high >= (16 - 1) / 2
    assert (1.5 - a).written == "${1.5 - $a}"
    assert np.maximum(a, 10.0).written == "${10}"


def test_a_name_alone_and_a_number():
    assert written(Expression.parameter("ego_speed_mps", 1.0, 2.0)) == "$ego_speed_mps"
    assert written(3.25) == 3.25


def test_what_cannot_be_bounded_is_refused():
    a = Expression.parameter("a", -1.0, 1.0)
    with pytest.raises(ZeroDivisionError, match="can be 0"):
        1.0 / a
    with pytest.raises(ValueError, match="powers"):
        a**2
    with pytest.raises(TypeError):
        np.sin(a)
