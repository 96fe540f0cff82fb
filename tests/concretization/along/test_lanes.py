"""Lanes that words, acts and dangers need (the search itself: ``test_wishes``)."""

from __future__ import annotations

import pytest
from roads import AHEAD, LEFT_LANE, RIGHT_LANE, TOWARDS, ego, one, road
from told import act, apart

from scegen.concretization.along.compose import compose_along
from scegen.concretization.along.telling import story_of
from scegen.concretization.concretize import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.errors import MotionInfeasibleError
from scegen.scenario.model import Interval
from scegen.understanding import read


def lanes_of(functional, number=0):
    story = story_of(functional, enumerate_scenarios(functional).scenarios[number])
    return {name: runner.lane for name, runner in story.runners.items()}, story.lane_count


def test_where_nothing_is_said_of_lanes_one_is_built():
    lanes, count = lanes_of(road([ego(50), one("a", "car", AHEAD), one("b", "car", TOWARDS)]))
    assert (lanes, count) == ({"ego": 1, "a": 1, "b": 1}, 1)


def test_as_many_are_built_as_the_sides_need():
    people = [ego(50), one("a", "car", LEFT_LANE), one("b", "car", RIGHT_LANE)]
    lanes, count = lanes_of(road(people))
    assert (lanes, count) == ({"ego": 2, "a": 1, "b": 3}, 3)


def test_sides_are_turned_where_traffic_keeps_left():
    lanes, _ = lanes_of(road([ego(50), one("a", "car", LEFT_LANE)], side="left"))
    assert lanes["a"] == lanes["ego"] + 1


def test_who_changes_towards_the_oncoming_is_beside_them():
    people = [ego(50), one("a", "car", TOWARDS)]
    acts = [act("drifts", "a", "change_lane", side="left", into="ego")]
    hazards = [("oncoming_lane", "a", "ego")]
    lanes, count = lanes_of(road(people, hazards, acts=acts))
    assert (lanes, count) == ({"ego": 1, "a": 1}, 1)
    lanes, _ = lanes_of(road(people, hazards, acts=acts, lanes=3))
    assert lanes["a"] == lanes["ego"] == 1


def test_an_offset_of_two_lanes_is_two_lanes():
    people = [ego(50), one("a", "car", [])]
    said = [apart("a", "ego", "lateral_offset_m", 7.0)]
    lanes, count = lanes_of(road(people, spacings=said))
    assert count == 3
    assert lanes["ego"] - lanes["a"] == 2


def test_who_may_be_anywhere_near_is_where_the_logical_scenario_has_it():
    near = ["ahead", "behind", "adjacent"]
    functional = road([ego(50), one("a", "car", near, speed=50)])
    listed = enumerate_scenarios(functional).scenarios
    for number, logical in enumerate(listed):
        lanes, _ = lanes_of(functional, number)
        beside = any(drive.beside for drive in logical.drives)
        assert (lanes["a"] != lanes["ego"]) == beside


def test_lanes_that_contradict_each_other_are_refused_by_their_words():
    people = [ego(50), one("a", "car", LEFT_LANE), one("b", "car", RIGHT_LANE)]
    logical = enumerate_scenarios(road(people)).scenarios[0]
    with pytest.raises(MotionInfeasibleError, match="is in the lane beside ego"):
        story_of(road(people, lanes=2), logical)


def test_who_is_to_be_off_the_road_is_refused():
    functional = road(
        [ego(50), one("a", "car", AHEAD)], spacings=[apart("a", "ego", "lateral_gap_m", 40.0)]
    )
    logical = enumerate_scenarios(functional).scenarios[0]
    with pytest.raises(MotionInfeasibleError, match="off the road"):
        compose_along(functional, logical, seed=0)


def test_nobody_goes_further_aside_than_the_road():
    functional = read("The lead car swerves 3 m to the left.")
    (act,) = functional.acts
    wide = act.model_copy(update={"lateral_m": Interval(low=20.0, high=20.0)})
    functional = functional.model_copy(update={"acts": (wide,)})
    with pytest.raises(MotionInfeasibleError, match="20 m aside, off the road"):
        concretize(functional, enumerate_scenarios(functional).scenarios[0])
