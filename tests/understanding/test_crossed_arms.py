"""Which road of a junction somebody crosses, and from which side of who turns into it."""

from __future__ import annotations

import pytest

from scegen.scenario.vocabulary import Approach, CrossedArm, HazardKind, Maneuver
from scegen.understanding.reader import read


def walker(text):
    scenario = read(text)
    (found,) = (p for p in scenario.participants if p.kind in {"pedestrian", "bicycle"})
    return found, scenario


@pytest.mark.parametrize(
    ("text", "arm"),
    [
        ("The ego turns left. A jogger crosses the street it turns into.", "exit"),
        ("The ego turns right and hits a boy who is crossing the road it is turning into.", "exit"),
        ("The ego turns left. A woman walks across the road into which the ego turns.", "exit"),
        ("Turning right, the ego meets a man crossing the road that it enters.", "exit"),
        ("The ego turns right into a side street. A child runs across the side street.", "exit"),
        ("The ego turns left. A cyclist crosses the exit from the left at 15 km/h.", "exit"),
        ("The ego turns left. An adult crosses the road that the ego comes from.", "entry"),
        ("The ego turns right. A child crosses the road it is leaving, from the left.", "entry"),
        ("The ego turns left. A cyclist crosses the road it is about to enter.", "exit"),
        ("The ego turns left and hits a man on the crosswalk of the road it turns into.", "exit"),
        ("We turn right into a side road and a cyclist rides across its mouth.", "exit"),
        ("The ego turns left into a driveway and hits a woman crossing it from the right.", "exit"),
        ("The ego turns right and stops for a man on the crosswalk of the exit.", "exit"),
        ("The ego turns left into a street that is being crossed by a jogger.", "exit"),
        ("We turn right into a side road across which a boy runs from the left.", "exit"),
        ("The ego turns left. A woman crosses the road which is entered by the ego.", "exit"),
        ("The ego turns right. A child crosses the road from the left.", None),
    ],
)
def test_the_arm(text, arm):
    found, _ = walker(text)
    assert found.crosses == arm
    assert Maneuver.CROSS in found.maneuvers


@pytest.mark.parametrize(
    ("turn", "way", "side"),
    [
        ("left", "in the direction in which the ego was driving before it turned", "left"),
        ("left", "against the direction the ego came in", "right"),
        ("right", "the way the ego was heading before the turn", "right"),
        ("right", "opposite to the ego's original direction", "left"),
        ("right", "in the ego's original direction of travel", "right"),
    ],
)
def test_a_way_told_by_the_ego_before_its_turn(turn, way, side):
    text = f"The ego turns {turn}. A pedestrian crosses the road that it turns into, walking {way}."
    found, scenario = walker(text)
    assert found.approaches == {Approach(side)}
    assert found.crosses is CrossedArm.EXIT
    assert not scenario.unsupported


def test_a_side_that_is_said_comes_first():
    found, scenario = walker(
        "The ego turns right. A pedestrian crosses the road it enters, walking the way the ego was "
        "heading before it turned, from the ego's left."
    )
    assert found.approaches == {Approach.LEFT}
    assert len(scenario.participants) == 2


def test_whose_eyes_see_the_side_is_no_event():
    found, scenario = walker(
        "The ego turns left. A jogger crosses the road it turns into, so from the right as the ego "
        "sees it after the turn, at 8 km/h."
    )
    assert found.approaches == {Approach.RIGHT}
    assert found.speed_mps.low == pytest.approx(8 / 3.6)
    assert not scenario.unsupported


def test_a_clause_that_says_who_turns_where_is_still_read():
    found, scenario = walker("A child crosses the road into which a lorry turns left.")
    assert scenario.ego.kind == "truck"
    assert scenario.ego.maneuvers == {Maneuver.LEFT}
    assert found.crosses is CrossedArm.EXIT


def test_nobody_stops_is_no_breach_without_a_rule():
    _, scenario = walker("The ego turns left and hits a man crossing its exit. Nobody stops.")
    assert [h.kind for h in scenario.hazards] == [HazardKind.CROSSING_PEDESTRIAN]


def test_who_crosses_the_road_of_another_meets_that_one():
    found, scenario = walker(
        "The ego follows a truck. The truck turns right and brakes for a pedestrian who crosses "
        "the road that the truck turns into."
    )
    assert found.crosses is CrossedArm.EXIT
    assert [h.to for h in scenario.hazards] == [("truck_1",)]
