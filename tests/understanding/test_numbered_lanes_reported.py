"""A number of a lane names none where nothing says from which side lanes are counted."""

import pytest

from scegen.understanding import read


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("A truck in lane 4 moves over to the right.", "in lane 4"),
        ("The ego drives in lane 1, a van drives in lane 3.", "in lane 3"),
    ],
)
def test_is_reported(text, words):
    assert words in [remark.text for remark in read(text).unsupported]


def test_the_next_lane_is_beside():
    scenario = read("The ego drives in lane 2 and a van in lane 3 changes into its lane.")
    assert [a.value for a in scenario.participant("van_1").approaches] == ["adjacent"]
    assert scenario.unsupported == ()
