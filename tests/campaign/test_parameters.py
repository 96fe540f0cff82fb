"""Sweeps say what they set; concretizations spread over ranges, each part of each range once."""

from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scegen.campaign.order import Sweep
from scegen.campaign.parameters import at_point, points, spread
from scegen.claims import claims_of
from scegen.enumeration import enumerate_scenarios
from scegen.errors import InputError
from scegen.understanding import read

FUNCTIONAL = read(
    "The ego drives at 50 km/h, 20 m behind a car, which brakes with 6 m/s2 to 10 km/h."
)
RANGED = read("The ego drives between 30 and 50 km/h at a four-way intersection. A car crosses.")
LOGICAL = enumerate_scenarios(RANGED).scenarios[0]
STATED = enumerate_scenarios(FUNCTIONAL).scenarios[0].parameters
NAMES = [p.name for p in STATED if p.reason == "stated"]


def test_all_combinations_of_all_values():
    sweep = {"b": Sweep(values=(1, 2)), "a": Sweep(values=(3, 4, 5))}
    found = list(points(sweep))
    assert len(found) == 6
    assert len({tuple(sorted(point.items())) for point in found}) == 6
    assert list(points({})) == [{}]


def test_a_swept_speed_is_what_is_said():
    swept = at_point(FUNCTIONAL, {"ego.speed_kph": 36.0})
    assert swept.ego.speed_mps.low == swept.ego.speed_mps.high == pytest.approx(10.0)
    logical = enumerate_scenarios(swept).scenarios[0]
    assert any("36" in c.statement and "ego" in c.statement for c in claims_of(swept, logical))


def test_every_stated_parameter_can_be_swept_by_its_name():
    stated = {p.name: p for p in STATED}
    assert len(NAMES) >= 4
    values = {name: stated[name].default + 1 for name in NAMES}
    swept = enumerate_scenarios(at_point(FUNCTIONAL, values)).scenarios[0]
    found = {p.name: p for p in swept.parameters}
    for name, value in values.items():
        assert found[name].low == found[name].high == pytest.approx(value, abs=1e-3)


@pytest.mark.parametrize("name", ["car_7.speed_kph", "ego.colour", "brake.rate_furlongs", "x"])
def test_what_is_no_parameter_is_told(name):
    with pytest.raises(InputError, match="sweep"):
        at_point(FUNCTIONAL, {name: 1.0})


def test_the_parameters_that_are_named_instead_can_be_swept():
    text = (
        "The ego follows a car at 40 km/h with a headway of 2 s, and it brakes at 5 m/s2 to a stop."
    )
    waits = "When the gap is 20 m, a child runs out and is hit at 25 % of the ego's width."
    for functional in (
        FUNCTIONAL,
        RANGED,
        read(text),
        read(f"The ego drives behind a van. {waits}"),
    ):
        with pytest.raises(InputError) as caught:
            at_point(functional, {"x": 1.0})
        named = caught.value.hint.split(", ")[:-2]
        assert named
        for name in named:
            at_point(functional, {name: 30.0})


@settings(max_examples=15)
@given(st.integers(1, 12), st.integers(0, 2**50))
def test_each_part_of_each_range_comes_once(count, seed):
    logical = LOGICAL
    found = [spread(RANGED, logical, number, count, seed) for number in range(count)]
    for index, whole in enumerate(logical.parameters):
        parts = sorted((one.parameters[index] for _, one in found), key=lambda p: p.low)
        if whole.low == whole.high:
            assert all(part == whole for part in parts)
            continue
        assert parts[0].low == whole.low
        assert parts[-1].high == pytest.approx(whole.high)
        for before, after in pairwise(parts):
            assert after.low == pytest.approx(before.high)
    for functional, one in found:
        speed = next(p for p in one.parameters if p.name == "ego.speed_mps")
        said = functional.ego.speed_mps
        assert (said.low, said.high) == pytest.approx((speed.low, speed.high), abs=1e-3)
