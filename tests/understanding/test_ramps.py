"""Who merges comes by a ramp or in a lane that ends; who takes the exit leaves by one."""

import pytest

from scegen.understanding.reader import read


def others(text):
    found = read(text)
    return found, [p for p in found.participants if p.role != "ego"]


@pytest.mark.parametrize(
    ("text", "auxiliary", "maneuver"),
    [
        (
            "A truck merges from the on-ramp in front of the ego on the motorway.",
            "on_ramp",
            "merge",
        ),
        ("On a motorway a van joins from the slip road ahead of the ego.", "on_ramp", "merge"),
        ("A car merges onto the motorway right in front of the ego.", "on_ramp", "merge"),
        ("A bus in the acceleration lane merges in front of the ego.", "on_ramp", "merge"),
        ("A van in the lane that ends merges in front of the ego.", "lane_drop", "merge"),
        ("The right lane ends and a car merges in front of the ego.", "lane_drop", "merge"),
        ("The car ahead of the ego leaves the motorway.", "off_ramp", "exit"),
        ("On a motorway the van ahead takes the exit.", "off_ramp", "exit"),
        ("A truck in front of the ego leaves by the exit ramp.", "off_ramp", "exit"),
    ],
)
def test_another_uses_the_lane(text, auxiliary, maneuver):
    found, (other,) = others(text)
    assert found.junction.auxiliary == auxiliary
    assert other.maneuvers == {maneuver}
    if maneuver == "merge":
        assert other.approaches == {"adjacent", "right"}


@pytest.mark.parametrize(
    ("text", "auxiliary", "maneuver"),
    [
        ("The ego joins the motorway from the on-ramp behind a truck.", "on_ramp", "merge"),
        ("The ego has to merge from a slip road.", "on_ramp", "merge"),
        ("The ego leaves the motorway at the next exit.", "off_ramp", "exit"),
    ],
)
def test_the_ego_uses_it(text, auxiliary, maneuver):
    found = read(text)
    assert found.junction.auxiliary == auxiliary
    assert found.ego.maneuvers == {maneuver}


def test_traffic_that_the_ego_joins_is_on_its_other_side():
    text = "The ego joins the motorway from the on-ramp in front of a truck in the right lane."
    _, (truck,) = others(text)
    assert truck.approaches == {"adjacent", "left"}


def test_where_traffic_keeps_left_the_ramp_is_on_the_left():
    _, (car,) = others("In the UK, a car merges from the slip road in front of the ego.")
    assert car.approaches == {"adjacent", "left"}


@pytest.mark.parametrize(
    "text",
    [
        "A red car stops dead on the slip road and the ego brakes behind it.",
        "The ego takes the second exit of the roundabout.",
        "The ego has to merge to the right because its lane ends.",
        "A car leaves the car park by its exit and hits the ego.",
        "On a motorway a car changes into the ego's lane.",
    ],
)
def test_no_ramp_is_made_up(text):
    assert read(text).junction.auxiliary is None


def test_a_ramp_that_nobody_uses_is_said_not_to_be_built():
    found = read("A red car stops dead on the slip road and the ego brakes behind it.")
    assert [u.text for u in found.unsupported if "ramp" in u.instead] == ["slip road"]


def test_two_lanes_of_a_highway_are_one_each_way_unless_cars_are_side_by_side():
    assert read("On a two-lane highway the ego follows a bus.").junction.lanes == (1, 1)
    text = "On a two-lane highway a car cuts in from the next lane in front of the ego."
    assert read(text).junction.lanes == (2, 2)
    assert read("On a two-lane motorway the ego follows a bus.").junction.lanes == (2, 2)


def test_who_merges_beyond_the_lane_next_to_the_egos_is_not_beside_it():
    text = "The ego drives in the {} lane of a three-lane motorway. A van merges from the on-ramp."
    _, (beyond,) = others(text.format("middle"))
    assert not beyond.approaches
    _, (beside,) = others(text.format("right"))
    assert beside.approaches == {"right", "adjacent"}


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("The ego takes the exit while a van enters from the on-ramp.", "takes"),
        ("A van merges from the on-ramp before the ego and then leaves by the exit.", "leaves"),
        ("A van merges from the on-ramp; the ego passes the next on-ramp.", "on-ramp"),
        ("In a bend a van merges from the on-ramp in front of the ego.", "from the on-ramp"),
    ],
)
def test_a_ramp_that_is_not_built_is_told(text, words):
    assert words in [u.text for u in read(text).unsupported]


@pytest.mark.parametrize(
    ("text", "carriageway"),
    [
        ("A truck joins from the ramp in front of the ego.", "divided"),
        ("The ego leaves by the exit behind a van.", "divided"),
        ("The right lane ends and a van in it merges in front of the ego.", "undivided"),
        ("On a one-way street a van joins from the slip road.", "one_way"),
        ("A car joins from the ramp while a van comes towards the ego.", "undivided"),
    ],
)
def test_a_road_with_ramps_has_a_median_unless_something_else_is_said(text, carriageway):
    assert read(text).junction.carriageway == carriageway
