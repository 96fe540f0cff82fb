import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.errors import VocabularyError
from scegen.units import length_m, speed_mps, time_s


@pytest.mark.parametrize(
    ("value", "unit", "expected"),
    [
        (36, "km/h", 10.0),
        (36, "kph", 10.0),
        (1, "mph", 0.44704),
        (5, "m/s", 5.0),
        (1, "knot", 0.514444),
        (10, "ft/s", 3.048),
    ],
)
def test_speeds_become_metres_per_second(value, unit, expected):
    assert math.isclose(speed_mps(value, unit), expected, rel_tol=1e-5)


def test_lengths_and_times():
    assert math.isclose(length_m(10, "ft"), 3.048)
    assert math.isclose(length_m(1, "mile"), 1609.344)
    assert math.isclose(time_s(2, "min"), 120.0)


@pytest.mark.parametrize("unit", ["bananas", "", "kg", "m", ")("])
def test_what_is_no_speed_is_refused(unit):
    with pytest.raises(VocabularyError):
        speed_mps(1, unit)


@given(st.floats(min_value=0, max_value=1e6))
def test_conversion_is_linear(value):
    assert math.isclose(speed_mps(2 * value, "mph"), 2 * speed_mps(value, "mph"), abs_tol=1e-9)
