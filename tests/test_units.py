"""Speeds become metres per second by exact factors."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.errors import VocabularyError
from scegen.units import SPEED_UNITS_MPS, speed_mps


@pytest.mark.parametrize(
    ("value", "unit", "expected"),
    [
        (36, "km/h", 10.0),
        (1, "mph", 0.44704),
        (5, "m/s", 5.0),
        (1, "knot", 0.514444),
        (10, "ft/s", 3.048),
    ],
)
def test_speeds_become_metres_per_second(value, unit, expected):
    assert math.isclose(speed_mps(value, unit), expected, rel_tol=1e-5)


@pytest.mark.parametrize("unit", ["bananas", "", "kg", "m", ")("])
def test_what_is_no_speed_is_refused(unit):
    with pytest.raises(VocabularyError):
        speed_mps(1, unit)


@given(st.floats(min_value=0, max_value=1e6), st.sampled_from(sorted(SPEED_UNITS_MPS)))
def test_conversion_is_linear(value, unit):
    assert math.isclose(speed_mps(2 * value, unit), 2 * speed_mps(value, unit), abs_tol=1e-9)
