"""Who is beside one that turns, and who comes out of a driveway backwards."""

from __future__ import annotations

import pytest

from scegen.scenario.vocabulary import Approach
from scegen.understanding.reader import read


def other(text):
    scenario = read(text)
    return next(p for p in scenario.participants if p.id != scenario.ego.id)


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("The ego turns right at the crossroads; a motorcycle on its right continues straight.",
         Approach.RIGHT),
        ("The ego is turning left at an intersection and a cyclist on its left goes straight on.",
         Approach.LEFT),
    ],
)  # fmt: skip
def test_a_rider_on_the_side_of_the_turn_is_beside_it(text, side):
    assert other(text).approaches == {Approach.ADJACENT, side}


@pytest.mark.parametrize(
    "text",
    [
        "The ego turns right while a cyclist comes from the right.",
        "The ego goes straight on at the crossroads; a motorcycle on its right turns left.",
    ],
)
def test_a_rider_from_that_side_is_not(text):
    assert other(text).approaches == {Approach.RIGHT}


def test_out_of_a_driveway_backwards():
    found = other("A car backs out of a driveway in front of the ego.")
    assert found.approaches == {Approach.LEFT, Approach.RIGHT}
    assert other("A van ahead of the ego reverses.").approaches == {Approach.AHEAD}
