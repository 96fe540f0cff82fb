"""A number of a lane says which one it is as far as it is known from where lanes are counted."""

import pytest

from scegen.understanding import read


def lanes(text):
    return {p.id: sorted(p.lanes) for p in read(text).participants if p.lanes}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("On a three-lane motorway the ego in lane 2 follows a van.", {"ego": [2]}),
        ("On a three-lane motorway a van in lane 3 brakes.", {"van_1": [1, 3]}),
        ("The ego drives in the third lane from the right on a motorway.", {"ego": [1]}),
        ("The ego drives in the second lane from the left on a three-lane motorway.", {"ego": [2]}),
        ("A truck in lane 4 moves over to the right.", {"truck_1": [1, 4]}),
        ("On a three-lane motorway the ego leaves lane 3 for the middle lane.", {"ego": [1, 3]}),
        (
            "On a three-lane motorway the ego in lane 1 follows a car in lane 1.",
            {"ego": [1, 3], "car_1": [1, 3]},
        ),
    ],
)  # fmt: skip
def test_is_one_of_those_that_it_can_mean(text, expected):
    assert lanes(text) == expected


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("On a motorway the ego drives in lane 2 behind a van.", "in lane 2"),
        ("The ego drives in lane 1, a van drives in lane 3.", "in lane 3"),
        ("On a three-lane motorway the ego changes from lane 3 to lane 2.", "to lane 2"),
    ],
)
def test_is_reported_where_it_tells_nothing(text, words):
    assert words in [remark.text for remark in read(text).unsupported]


def test_the_next_lane_is_beside():
    scenario = read("The ego drives in lane 2 and a van in lane 3 changes into its lane.")
    assert [a.value for a in scenario.participant("van_1").approaches] == ["adjacent"]
    assert lanes(scenario.description) == {"ego": [2], "van_1": [1, 3]}
    assert scenario.unsupported == ()
