"""Where somebody is, and what is measured: no turn, no hazard, nobody new."""

import pytest

from scegen.scenario.vocabulary import Approach, HazardKind, JunctionKind, Maneuver
from scegen.understanding import read


def others(text):
    """Approaches of everybody but the ego."""
    return [set(p.approaches) for p in read(text).participants if p.role != "ego"]


def ego(text):
    return next(set(p.maneuvers) for p in read(text).participants if p.role == "ego")


@pytest.mark.parametrize(
    "text",
    [
        "The target drives in the lane to the left of the host and then cuts in.",
        "A coach travelling in the lane on the right of the ego swerves.",
        "A van keeps to the right of the ego.",
    ],
)
def test_a_lane_beside_somebody_is_no_turn(text):
    scenario = read(text)
    assert scenario.junction.kind is JunctionKind.STRAIGHT
    side = Approach.LEFT if "left" in text else Approach.RIGHT
    assert others(text) == [{Approach.ADJACENT, side}]


def test_an_overtaken_vehicle_comes_the_same_way():
    text = "An oncoming SUV overtakes a tractor and drives straight towards the ego."
    assert others(text) == [{Approach.OPPOSITE}, {Approach.OPPOSITE}]


@pytest.mark.parametrize(
    "text",
    [
        "The ego follows a van on a motorway, speed difference 30 km/h.",
        "Ego speed 80 km/h, closing speed 20 km/h: the ego nears a van ahead.",
    ],
)
def test_a_measured_speed_is_no_speeding(text):
    assert HazardKind.SPEEDING not in {h.kind for h in read(text).hazards}


def test_where_one_is_hit_is_not_where_one_comes_from():
    text = "Vehicle 1 waited at a crossroads. Vehicle 2 came from behind and hit it in the rear."
    assert len(read(text).participants) == 2


@pytest.mark.parametrize(
    ("text", "maneuver"),
    [
        ("The ego keeps to the left lane while a van brakes.", Maneuver.STRAIGHT),
        ("The ego has to merge to the right because its lane ends.", Maneuver.LANE_CHANGE),
        ("The ego continues to the third exit of the roundabout.", Maneuver.EXIT_3),
        ("The ego must stop until two vans have passed and then turns right.", Maneuver.RIGHT),
    ],
)
def test_what_the_ego_does(text, maneuver):
    assert ego(text) == {maneuver}


@pytest.mark.parametrize(
    "text",
    [
        "Pedestrian crossing the street ahead of the turning ego vehicle.",
        "Pedestrian crossing in front of the ego from the left.",
        "A car brakes for the pedestrian crossing the road.",
    ],
)
def test_who_crosses_is_no_crossing(text):
    kinds = {p.kind.value for p in read(text).participants}
    assert kinds == {"car", "pedestrian"}
