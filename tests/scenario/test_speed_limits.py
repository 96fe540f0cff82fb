"""The limit that a description implies."""

import pytest
from told import act, told, who

from scegen.scenario.speed_limits import implied_limit_mps, limit_for_kind_mps
from scegen.scenario.vocabulary import ParticipantKind


def limit_kmh(*speeds, hazards=(), kind="straight", **junction):
    people = [who(name, car, speed=speed / 3.6) for name, car, speed in speeds]
    return round(implied_limit_mps(told(kind, people, hazards, **junction)) * 3.6, 3)


@pytest.mark.parametrize(
    ("speed", "limit"), [(30, 50), (50, 50), (51, 50), (55, 60), (90, 90), (104.6, 110), (180, 130)]
)
def test_who_drives_fast_is_on_a_fast_road(speed, limit):
    assert limit_kmh(("ego", "car", speed)) == limit


def test_the_fastest_decides_and_what_is_said_goes_first():
    both = ("ego", "car", 40), ("x", "truck", 80)
    assert limit_kmh(*both) == 80
    assert limit_kmh(*both, speed_limit_mps=60 / 3.6) == 60


def test_one_who_speeds_or_hurries_says_nothing_of_the_road():
    assert limit_kmh(("ego", "car", 40), ("x", "car", 90), hazards=[("speeding", "x", "ego")]) == 50
    assert limit_kmh(("ego", "car", 40), ("x", "emergency_vehicle", 90)) == 50


def test_a_bend_is_one_that_who_speeds_gets_round():
    speeds = ("x", "car", 90), ("ego", "car", 40)
    assert limit_kmh(*speeds, hazards=[("speeding", "x", "ego")], bend={}) == 70


@pytest.mark.parametrize(
    ("does", "to", "limit"), [("brake", 40, 60), ("brake", 0, 50), ("accelerate", 80, 80)]
)
def test_who_slows_down_or_speeds_up_to_a_speed_is_on_a_road_for_both(does, to, limit):
    people = [who("ego", "car"), who("x", "car")]
    acts = [act("changes", "x", does, target_speed_mps=to / 3.6)]
    assert round(implied_limit_mps(told("straight", people, acts=acts)) * 3.6, 3) == limit


def test_roundabouts_are_slow():
    assert limit_kmh(("ego", "car", 20), kind="roundabout") == 30


def test_a_rider_speeds_earlier_than_a_car():
    assert limit_for_kind_mps(ParticipantKind.BICYCLE, 13.9) == pytest.approx(25 / 3.6)
    assert limit_for_kind_mps(ParticipantKind.BICYCLE, 5.0) == 5.0
    assert limit_for_kind_mps(ParticipantKind.CAR, 13.9) == 13.9
