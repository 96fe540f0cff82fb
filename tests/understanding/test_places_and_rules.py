"""What words of place and of rules mean: nobody drives where the text lets it stand, and so on."""

import pytest
from compact_functional import compact

from scegen.scenario.roadway import Strip
from scegen.scenario.signals import AtLight
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding import read


def _who(text, name):
    return read(text).participant(name)


def test_who_stands_on_the_shoulder_and_pulls_out_stands_there_first():
    text = (
        "On a motorway with a hard shoulder a car stands on the hard shoulder and pulls out in "
        "front of the ego at 100 km/h."
    )
    car = _who(text, "parked_car_1")
    assert (car.parked, car.strip, car.speed_mps) == (True, Strip.HARD_SHOULDER, None)
    assert _who(text, "ego").speed_mps.low == pytest.approx(100 / 3.6)


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("A dog runs across the road in front of the ego at 50 km/h.", "animal_1"),
        ("A car pulls out of a parking strip in front of the ego at 45 km/h.", "parked_car_1"),
        ("A car backs out of a driveway in front of the ego at 40 km/h.", "car_1"),
    ],
)
def test_a_speed_after_in_front_of_somebody_is_of_who_drives_so_fast(text, other):
    assert _who(text, other).speed_mps is None
    assert _who(text, "ego").speed_mps is not None


def test_a_hard_shoulder_that_is_not_there_is_not_built():
    assert not read("On a motorway without a hard shoulder the ego follows a van.").junction.strips


@pytest.mark.parametrize(
    ("text", "count", "stays"),
    [
        ("A jam of four cars stands in the right lane of a motorway; the ego comes.", 4, True),
        ("On a motorway a traffic jam of six cars crawls at 8 km/h, the ego comes.", 6, False),
        ("The ego comes upon the tail of a jam of five cars.", 5, True),
    ],
)
def test_a_jam_of_so_many_is_those(text, count, stays):
    others = [p for p in read(text).participants if p.id != "ego"]
    assert len(others) == count
    assert all((p.maneuvers == {Maneuver.STAY}) is stays for p in others)
    assert all(p.approaches == {Approach.AHEAD} for p in others)


@pytest.mark.parametrize(
    ("text", "who", "arms"),
    [
        ("At a stop sign the ego waits until a truck from the right has passed.", "ego", {1, 3}),
        ("At a give-way sign the ego turns right onto the main road.", "ego", {1, 3}),
        ("The ego comes from a side road with a yield sign, a van from the right.", "ego", {2}),
        ("The ego on the main road passes a car that waits at a stop sign.", "car_1", {1, 3}),
        ("A van on the minor road runs the stop sign; the ego has priority.", "van_1", {2}),
    ],
)
def test_who_has_the_sign_comes_where_it_stands(text, who, arms):
    assert _who(text, who).entries == arms


def test_a_stop_at_the_line_is_what_the_rule_asks_for():
    text = "At a junction with stop signs on the minor road, the ego stops at the line and goes on."
    assert compact(read(text)).get("acts", []) == []
    text = "The ego stops at the stop sign and lets a car from the left pass."
    assert compact(read(text))["acts"] == [{"who": "ego", "does": "wait", "into": "car_1"}]


@pytest.mark.parametrize(
    "text",
    [
        "A truck on the right opens its driver's door, and the ego comes at 50 km/h.",
        "A taxi stops at the kerb and its rear left door opens; the ego comes at 30 km/h.",
    ],
)
def test_who_opens_a_door_stands(text):
    scenario = read(text)
    assert len(scenario.participants) == 2
    assert all(p.parked for p in scenario.participants if p.id != "ego")
    assert [a.kind for a in scenario.acts] == ["open_door"]


@pytest.mark.parametrize(
    "text",
    [
        "The ego turns left across oncoming traffic: three cars come at 50 km/h, the ego waits for "
        "a gap.",
    ],
)
def test_traffic_of_so_many_is_those(text):
    scenario = read(text)
    others = [p for p in scenario.participants if p.id != "ego"]
    assert len(others) == 3
    assert all(p.approaches == {Approach.OPPOSITE} for p in others)
    assert {a.into for a in scenario.acts} == {p.id for p in others}


def test_who_is_met_as_it_comes_towards_the_ego_faces_it():
    text = "The ego meets a van that comes towards it."
    assert _who(text, "van_1").approaches == {Approach.OPPOSITE}


def test_who_stops_at_its_sign_is_in_nobodys_way():
    text = "A truck on the minor road stops at the stop sign, then sets off in front of the ego."
    scenario = read(text)
    assert not scenario.acts
    assert all(h.kind is not HazardKind.STOPPING for h in scenario.hazards)


def test_who_overtakes_and_turns_does_turn():
    text = "A cyclist is overtaken by a van which turns into a driveway."
    assert _who(text, "van_1").maneuvers == {Maneuver.LEFT, Maneuver.RIGHT}


def test_lights_that_change_as_somebody_comes_or_waits():
    assert _who("The light turns red as the ego approaches.", "ego").light is AtLight.STOPS
    text = "The ego waits at red; when it turns green a cyclist from the right still crosses."
    assert _who(text, "ego").light is AtLight.WAITS


def test_a_reaction_time_counts_from_what_the_other_does():
    text = "The lead car brakes at 5 m/s², the second car brakes after a reaction time of 1 s."
    first, second = read(text).acts
    assert (second.when.act, second.when.since) == (first.id, "begin")


def test_people_who_run_are_faster_than_who_walk():
    runs = _who("A child runs across the road in front of the ego.", "pedestrian_1").speed_mps
    assert runs.low > 2.0
    assert _who("A child walks across the road.", "pedestrian_1").speed_mps is None


def test_exits_and_ramps_that_are_reached_and_entered():
    scenario = read("On the motorway the car ahead cuts across to the right to reach the exit.")
    assert scenario.junction.auxiliary == "off_ramp"
    scenario = read("A van enters the motorway via the slip road, the ego is in the right lane.")
    assert scenario.junction.auxiliary == "on_ramp"


def test_who_does_not_stop_for_people_owes_it_to_them():
    text = "On a straight road the ego does not stop at a crosswalk for a child from the right."
    breach = [h for h in read(text).hazards if h.kind is HazardKind.FAILURE_TO_YIELD]
    assert breach[0].to == ("pedestrian_1",)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("A motorcycle filters between two lanes of stopped cars.", "filters between two lanes"),
        ("A jam of six cars crawls in both lanes of a motorway, the ego comes.", "both lanes"),
        ("A man walks on the pavement and steps into the road in front of the ego.", "walks"),
        ("The ego follows a van past an exit of the motorway.", "exit"),
        ("A taxi stops at the kerb as the ego passes.", "stops"),
        ("The car ahead pulls over to the right and stops.", "pulls over"),
        ("Two passengers get off the bus and cross the road.", "get off"),
        ("A parked car opens the door on the kerb side.", "opens the door on the kerb side"),
        ("A motorcycle splits lanes past the ego.", "splits lanes past the ego"),
        ("An ambulance drives through the rescue lane; the ego stands.", "rescue lane"),
        ("A car changes two lanes to the left in front of the ego.", "changes"),
        ("The van from the right enters the junction and the ego has to brake.", "brake"),
    ],
)
def test_what_is_not_built_is_told(text, words):
    assert words in {u.text for u in read(text).unsupported}


def test_a_stop_that_somebody_waits_at_is_built():
    text = "A woman waits at the bus stop on the right and runs into the road."
    scenario = read(text)
    assert Strip.BUS_STOP in scenario.junction.strips
    assert scenario.participant("pedestrian_1").approaches == {Approach.RIGHT}


def test_a_cyclist_who_crosses_out_of_a_side_street_has_no_arm_to_come_in_by():
    text = "A cyclist shoots out of the side street on the left; the ego, going straight on, "
    cyclist = _who(text + "nearly hits him.", "bicycle_1")
    assert (cyclist.maneuvers, cyclist.entries) == ({Maneuver.CROSS}, frozenset())
