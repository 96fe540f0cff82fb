"""An unprotected left turn is one across oncoming traffic."""

from __future__ import annotations

import pytest

from scegen.scenario.vocabulary import HazardKind
from scegen.understanding.reader import read


@pytest.mark.parametrize(
    "text",
    [
        "The ego goes straight through the intersection; the car from the right turns left in "
        "front of the ego.",
        "A van coming from the left turns left across the path of the ego at the crossroads.",
    ],
)
def test_from_the_side_it_is_a_failure_to_yield(text):
    assert [h.kind for h in read(text).hazards] == [HazardKind.FAILURE_TO_YIELD]


def test_from_the_front_it_is_an_unprotected_left_turn():
    text = "The ego goes straight on; an oncoming van turns left in front of it at the crossroads."
    assert HazardKind.UNPROTECTED_LEFT_TURN in {h.kind for h in read(text).hazards}


def test_whom_it_threatens_keeps_its_ways_open_where_that_is_a_guess():
    """Three others come to the crossroads; which of them is in danger is not said."""
    scenario = read("Four cars meet at a four-way junction, one making an unprotected left turn.")
    assert [len(p.maneuvers) for p in scenario.participants] == [1, 0, 0, 0]


def test_what_follows_is_nobodys_in_particular():
    """The tailgating leads to it: that does not say who of the two brakes."""
    scenario = read("A van follows a bus too closely, leading to a sudden braking event.")
    braking = next(h for h in scenario.hazards if h.kind is HazardKind.HARD_BRAKING)
    assert braking.by == ()
