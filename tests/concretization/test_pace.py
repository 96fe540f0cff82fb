"""How fast somebody usually is: what is said, exactly; else as the logical scenario has it."""

from __future__ import annotations

import pytest
from roads import AHEAD, ego, one, road

from scegen.concretization.tale import pace_of
from scegen.enumeration import enumerate_scenarios


def listed(said):
    return enumerate_scenarios(said).scenarios[0]


@pytest.mark.parametrize("kph", [50.0, 80.0, 33.3])
def test_what_is_said_is_not_rounded(kph):
    said = road([ego(kph), one("lead", "car", AHEAD)])
    pace = pace_of(said, listed(said), "ego")
    assert pace.low == pace.default == pace.high == said.ego.speed_mps.middle


@pytest.mark.parametrize("kind", ["car", "truck", "bicycle"])
def test_a_logical_scenario_without_ranges_has_those_of_a_listed_one(kind):
    said = road([ego(50), one("lead", kind, AHEAD)])
    bare = listed(said).model_copy(update={"parameters": ()})
    assert pace_of(said, bare, "lead") == pace_of(said, listed(said), "lead")


def test_a_range_that_is_narrowed_by_hand_counts():
    said = road([ego(50), one("lead", "car", AHEAD)])
    logical = listed(said)
    narrow = tuple(
        p.model_copy(update={"low": 3.0, "default": 4.0, "high": 5.0}) for p in logical.parameters
    )
    pace = pace_of(said, logical.model_copy(update={"parameters": narrow}), "lead")
    assert (pace.low, pace.default, pace.high) == (3.0, 4.0, 5.0)
