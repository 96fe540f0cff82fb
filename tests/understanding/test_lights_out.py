"""Lights that do not work: what is said of them, and what is not."""

import pytest

from scegen.scenario.vocabulary import Control
from scegen.understanding import read

SITUATION = " A car comes from the right and the ego goes straight at 40 km/h."
JUNCTION = "At a four-way intersection "


@pytest.mark.parametrize(
    "words",
    [
        "the traffic lights are out of order",
        "the traffic lights are switched off",
        "the signals do not work",
        "the traffic light is dark",
        "the lights are flashing amber",
        "the traffic lights flash yellow",
        "the signals have failed",
        "with non-working traffic lights",
        "with switched-off traffic lights",
        "with broken traffic signals",
        "with flashing yellow lights",
    ],
)
def test_lights_that_do_not_work(words):
    scenario = read(f"{JUNCTION}{words}.{SITUATION}")
    assert scenario.junction.control is Control.SIGNALS_OFF
    said = [e.text for e in scenario.evidence if e.field == "junction.control"]
    assert said[0] in words
    assert not [u for u in scenario.unsupported if "dark, not flashing" not in u.instead]
    flashes = "flash" in words
    assert bool(scenario.unsupported) is flashes


@pytest.mark.parametrize(
    ("text", "control"),
    [
        ("At a signalised intersection the lights are out of order.", "signals_off"),
        ("The traffic lights are off and there is a stop sign on the side road.", "stop"),
        ("At an all-way stop the traffic lights are out of order.", "all_way_stop"),
        ("At the traffic lights a broken down truck stands in the lane.", "signals"),
        ("At an intersection with traffic lights the ego is followed by a van.", "signals"),
        ("At an intersection without traffic lights the ego is followed by a van.", "uncontrolled"),
    ],
)
def test_what_holds_beside_them(text, control):
    assert read(text + SITUATION).junction.control is Control(control)


@pytest.mark.parametrize(
    "vehicle", ["A bicycle with lights off", "A tow truck with flashing amber lights"]
)
def test_lights_of_a_vehicle_are_not_those_of_a_junction(vehicle):
    scenario = read(f"{vehicle} stands in the lane ahead of the ego.")
    assert scenario.junction.control is Control.UNCONTROLLED


def test_a_light_that_does_not_work_is_not_run():
    scenario = read("The traffic light does not work. A van from the right runs a red light.")
    assert not scenario.hazards
    assert [u.text for u in scenario.unsupported] == ["runs a red light"]
