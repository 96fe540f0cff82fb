"""Lanes that are counted, or pointed back at without the word."""

import pytest

from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding import read


def one(text, role):
    return next(p for p in read(text).participants if (p.role == "ego") == (role == "ego"))


def test_the_next_one_after_a_lane_is_a_lane():
    text = "The ego is half in its lane and half in the next one when a lorry brakes behind it."
    scenario = read(text)
    assert len(scenario.participants) == 2
    assert one(text, "ego").maneuvers == {Maneuver.LANE_CHANGE}


@pytest.mark.parametrize(
    "text",
    [
        "A van two lanes over speeds up beside the ego.",
        "The ego drives on a motorway; a van, two lanes to the left, speeds up.",
    ],
)
def test_counted_lanes_are_beside(text):
    assert one(text, "other").approaches - {Approach.LEFT} == {Approach.ADJACENT}


@pytest.mark.parametrize(
    "text",
    ["The ego moves one lane over behind a bus."],
)
def test_moving_lanes_over_is_a_change_of_lane(text):
    assert one(text, "ego").maneuvers == {Maneuver.LANE_CHANGE}
