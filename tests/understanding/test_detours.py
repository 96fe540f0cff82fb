"""Ways round what stands in the lane, by the other half of the road."""

import pytest

from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding import read


def ego(text):
    return next(set(p.maneuvers) for p in read(text).participants if p.role == "ego")


@pytest.mark.parametrize(
    "text",
    [
        "The ego squeezes round a parked lorry while a car comes towards it.",
        "Half over the centre line to clear a skip, the ego sees a bus coming the other way.",
        "Roadworks push the ego across the centre line just as a truck comes round the bend.",
        "With a taxi parked on its side, the ego is in the oncoming lane when a cyclist appears.",
        "A parked van obliges our car to go over onto the other side; an oncoming driver hoots.",
        "My way past the parked cars is blocked by an oncoming lorry that refuses to pull in.",
        "The ego waits behind a stopped coach, then noses over the centre line and sees a van.",
    ],
)
def test_a_way_round_is_overtaking(text):
    assert ego(text) == {Maneuver.OVERTAKE}


@pytest.mark.parametrize(
    "text",
    [
        "The ego drives along a road when a truck crosses the centre line.",
        "A bus comes round the bend towards the ego, and a van is parked on the left.",
        "An oncoming motorcyclist edges round a parked van into the lane of the ego.",
    ],
)
def test_others_on_the_wrong_side_leave_the_ego_in_its_lane(text):
    assert ego(text) == {Maneuver.STRAIGHT}


def test_what_is_parked_does_not_drive():
    text = "A lorry is parked in the lane of the ego. It has to use the opposite lane."
    assert ego(text) == {Maneuver.OVERTAKE}


def test_an_unlisted_thing_hides_somebody_at_its_side():
    text = "A car drives down a street. From behind a poster rack at the right kerb a boy runs out."
    scenario = read(text)
    boy = next(p for p in scenario.participants if p.kind == "pedestrian")
    assert boy.approaches == {"right"}
    assert HazardKind.OCCLUSION in {h.kind for h in scenario.hazards}


@pytest.mark.parametrize(
    ("text", "maneuver"),
    [
        ("Right turn for the ego at a crossroads while a cyclist comes from the left.", "right"),
        ("In the middle of its left turn the ego meets a pedestrian on the crosswalk.", "left"),
        ("Evasive lane change by the ego because of a slow leader.", "lane_change"),
    ],
)
def test_doings_named_by_a_noun(text, maneuver):
    assert ego(text) == {maneuver}
