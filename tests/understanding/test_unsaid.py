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


@pytest.mark.parametrize("verb", ["overtaken", "being followed", "passed", "cut off"])
def test_what_nobody_is_said_to_do_to_somebody_is_told(verb):
    found = read(f"On a country road the ego is {verb}.")
    assert [u.instead for u in found.unsupported] == ["by whom is not said; left out"]
    assert not read(f"On a country road the ego is {verb} by a bus.").unsupported
