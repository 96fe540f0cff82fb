"""What participants do of whom no maneuver is said."""

import pytest

from scegen.scenario.vocabulary import Maneuver
from scegen.understanding import read


@pytest.mark.parametrize(
    ("text", "who", "expected"),
    [
        ("I overtake a slow tractor on a country road.", "truck_1", {Maneuver.STRAIGHT}),
        ("The ego turns left at a junction and yields to an oncoming van.", "van_1", {"straight"}),
        ("The ego meets an oncoming van that turns left at the lights.", "van_1", {"left"}),
        ("The ego waits at a red light and a bus crosses from the right.", "ego", {"stay"}),
        ("A taxi turns left at a junction and a van brakes.", "van_1", set()),
    ],
)
def test_what_follows_without_being_said(text, who, expected):
    assert read(text).participant(who).maneuvers == expected


def test_who_has_the_way_goes_straight_on():
    scenario = read("A van emerged from a driveway in front of a moped.")
    assert scenario.participant("motorcycle_1").maneuvers == {"straight"}


@pytest.mark.parametrize(
    ("done", "whence"),
    [
        ("overtaken", "behind"),
        ("being followed", "behind"),
        ("passed", "behind"),
        ("hit from behind", "behind"),
        ("cut off", "adjacent"),
    ],
)
def test_who_is_not_named_is_a_car_and_that_is_told(done, whence):
    found = read(f"On a country road the ego is {done}.")
    assert found.participant("car_1").approaches == {whence}
    reasons = [e.reason for e in found.evidence if e.field == "participants.car_1.kind"]
    assert reasons == ["the other one is not named; here it is a car"]
    named = read(f"On a country road the ego is {done} by a bus.")
    assert {p.id for p in named.participants} == {"ego", "bus_1"}
