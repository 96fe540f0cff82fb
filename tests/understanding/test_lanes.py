"""How many lanes a road has in each direction."""

from __future__ import annotations

import pytest

from scegen.understanding.reader import read


@pytest.mark.parametrize(
    ("text", "lanes"),
    [
        ("The ego drives on a three-lane motorway.", 3),
        ("On a two-lane motorway a bus overtakes the ego.", 2),
        ("The ego follows a truck on a two-lane dual carriageway and overtakes it.", 2),
        ("On a three-lane highway, a van changes into the middle lane.", 3),
        ("Two cars drive on a six-lane freeway.", 3),
        ("Two cars meet on a four-lane road.", 2),
        ("The ego drives on a road with two lanes in each direction.", 2),
        ("The ego changes lanes on a three-lane road.", 3),
    ],
)
def test_lanes_in_each_direction(text, lanes):
    assert read(text).junction.lanes == (lanes, lanes)


@pytest.mark.parametrize(
    "text",
    [
        "The ego overtakes a tractor on a country road while a van approaches from the front.",
        "An oncoming motorcycle has to brake because a car is overtaking a lorry.",
        "On a two-lane rural road the ego overtakes a truck.",
    ],
)
def test_overtaking_in_view_of_oncoming_traffic_uses_its_lane(text):
    assert read(text).junction.lanes == (1, 1)


@pytest.mark.parametrize(
    "text",
    [
        "A car overtakes the ego on the left.",
        "A van beside the ego cuts in.",
        "A motorcycle rides level with the ego, 7 m to its right.",
        "The ego changes lanes on a country road.",
    ],
)
def test_lanes_that_nobody_counts_are_open(text):
    assert read(text).junction.lanes == ()
