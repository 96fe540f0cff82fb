"""How somebody meets its light, by the words of the text; what nobody meets is reported."""

import pytest

from scegen.scenario.signals import AtLight
from scegen.scenario.vocabulary import Control, HazardKind
from scegen.understanding import read


def lights(text):
    """Everybody's light, by name."""
    return {p.id: p.light for p in read(text).participants if p.light is not None}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("The ego has green and a van from the left crosses on amber.",
         {"ego": "green", "van_1": "amber"}),
        ("The ego's light is green. A truck from the right drives through on yellow.",
         {"ego": "green", "truck_1": "amber"}),
        ("A pedestrian crosses on green while the ego turns right at the lights.",
         {"pedestrian_1": "green"}),
        ("At traffic lights a man crosses at red and the ego has a green light.",
         {"pedestrian_1": "red", "ego": "green"}),
        ("The ego drives towards a traffic light; the light turns red and it brakes.",
         {"ego": "stops"}),
        ("The light at the crossroads changes to amber and the ego stops at the stop line.",
         {"ego": "stops"}),
        ("At a crossroads the ego waits until the light turns green.", {"ego": "waits"}),
        ("When the traffic light turns green the ego sets off. A van comes from the left.",
         {"ego": "waits"}),
        ("The ego sets off as soon as the light turns green. A van comes from the left.",
         {"ego": "waits"}),
        ("A van from the left enters just before the light turns red; the ego goes straight.",
         {"van_1": "amber"}),
        ("The traffic light is green for the ego and a bus from the right drives on.",
         {"ego": "green"}),
    ],
)  # fmt: skip
def test_light_is_read(text, said):
    assert lights(text) == {name: AtLight(light) for name, light in said.items()}
    assert not read(text).unsupported


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("The ego and a van meet at a crossroads. The light turns red.", "turns red"),
        ("A pedestrian crosses on amber at the lights in front of the ego.", "amber"),
    ],
)
def test_what_nobody_meets_is_reported(text, words):
    assert any(words in remark.text for remark in read(text).unsupported)
    assert not lights(text)


def test_who_stops_as_it_turns_red_does_not_run_it():
    read_ = read(
        "At traffic lights the light turns red for the ego before it gets there; it stops."
    )
    assert not read_.hazards
    assert lights(read_.description) == {"ego": AtLight.STOPS}


def test_who_drives_on_after_it_has_turned_red_runs_it():
    read_ = read("A van from the left enters the junction after the light has turned red.")
    assert [h.kind for h in read_.hazards] == [HazardKind.RED_LIGHT_RUNNING]
    assert not lights(read_.description)


def test_flashing_red_is_a_stop_for_everybody():
    read_ = read("At a crossroads with flashing red lights the ego meets a van from the left.")
    assert read_.junction.control is Control.ALL_WAY_STOP
    assert [u.text for u in read_.unsupported] == ["flashing red lights"]


def test_what_the_rules_say_is_not_reported():
    text = "The car from the left runs the red light and hits the ego, which has green."
    assert read(text).unsupported == ()


def test_a_light_by_which_nobody_goes_is_reported():
    scenario = read("The pedestrian light is red; a jogger crosses in front of the ego.")
    assert any("nothing says who goes" in u.instead for u in scenario.unsupported)


def test_who_circulates_is_in_a_roundabout():
    scenario = read("The ego enters while a car already circulating brakes hard.")
    assert scenario.junction.kind == "roundabout"
    assert scenario.participant("car_1").circulating
