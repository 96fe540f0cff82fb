"""Who is meant by a role, whose sign or lane it is, and which way they come."""

from collections import Counter

import pytest

from scegen.scenario.vocabulary import Approach, Control, JunctionKind, Maneuver
from scegen.understanding import read


def kinds(text):
    return Counter(("parked " if p.parked else "") + p.kind for p in read(text).participants)


def hazards(text):
    return {h.kind.value for h in read(text).hazards}


def other(text, kind):
    return next(p for p in read(text).participants if p.kind == kind and p.role != "ego")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The ego follows a leading van; the adversarial leading van stops.", {"car": 1, "van": 1}),
        ("The ego overtakes a bus when the adversarial bus swerves.", {"car": 1, "bus": 1}),
        ("The ego follows a bus when the adversarial bus behind it brakes.", {"car": 1, "bus": 2}),
        ("The ego meets a van; the adversarial oncoming van swerves.", {"car": 1, "van": 2}),
        ("The adversarial oncoming lorry swerves towards the ego.", {"car": 1, "truck": 1}),
        ("The adversary, a bus halted ahead, blocks the ego.", {"car": 1, "bus": 1}),
        ("Four vans wait in a queue when a fifth arrives.", {"van": 5}),
        ("Two vans from the left and one from the right wait at a crossroads.", {"van": 3}),
        ("The cyclist crosses. The driver brakes.", {"bicycle": 1, "car": 1}),
        ("The other car came at me.", {"car": 2}),
        ("The other van ran the red light.", {"car": 1, "van": 1}),
        ("The ego moves into the neighbouring lane.", {"car": 1}),
        ("A car brakes and a drunk wanders over the road.", {"car": 1, "pedestrian": 1}),
        ("The neighbours' van reverses past a bus.", {"van": 1, "bus": 1}),
        ("Six vans wait at the lights when a seventh arrives.", {"van": 7}),
        ("A bus lets a cyclist and two vans go by.", {"bus": 1, "bicycle": 1, "van": 2}),
        ("The ego is behind a lorry and the guy behind me overtakes.", {"car": 2, "truck": 1}),
    ],
)
def test_participants(text, expected):
    assert kinds(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("At a junction two cars from the right ignore their stop sign.", {"failure_to_yield"}),
        ("At a junction with yield signs a van ignores its sign.", {"failure_to_yield"}),
        ("An oncoming bus drifts into the ego's lane.", {"oncoming_lane", "swerving"}),
        ("An oncoming bus invades my lane.", {"oncoming_lane"}),
        ("An oncoming bus cuts into the ego's lane.", {"oncoming_lane"}),
        ("An oncoming taxi comes onto our side.", {"oncoming_lane"}),
        ("A taxi strays over the white line.", {"oncoming_lane", "swerving"}),
        ("Car 1 overtakes car 2 and meets car 3 in the oncoming lane.", None),
        ("A car in the next lane drives abruptly into the lane of the bus.", {"cut_in"}),
        ("The ego stops for a man who walks over the zebra crossing.", {"crossing_pedestrian"}),
        ("A girl crosses and a car stops for her.", {"crossing_pedestrian"}),
        ("A cyclist goes straight across the ego's path.", {"crossing_cyclist"}),
        ("A cyclist goes straight along the ego's path.", set()),
        ("A van forces a moped to swerve.", {"swerving"}),
        ("A van in front forces the ego to swerve.", set()),
        ("A bus leaves its stop.", set()),
        ("A car waits at a stop sign and the van behind it does not stop in time.", None),
        ("Two children get off and cross in front of a bus.", {"crossing_pedestrian"}),
        ("A car lets a girl and a cyclist cross.", {"crossing_pedestrian", "crossing_cyclist"}),
        ("A car waits after letting a bus go by.", set()),
        ("The ego follows a bus; behind it a taxi drives too close.", {"tailgating"}),
        ("A bus goes so slowly that overtaking is hard.", {"slow_driving"}),
        ("An oncoming lorry moves over into the ego's path.", {"oncoming_lane"}),
        ("An oncoming lorry stays in its lane as a bus waits.", set()),
        ("At a junction the tram disregards its red light.", {"red_light_running"}),
    ],
)
def test_dangers(text, expected):
    special = {
        "Car 1 overtakes car 2 and meets car 3 in the oncoming lane.": {
            "overtaking",
            "oncoming_lane",
        },
        "A car waits at a stop sign and the van behind it does not stop in time.": {
            "delayed_braking"
        },
    }
    assert hazards(text) == (special[text] if expected is None else expected)


@pytest.mark.parametrize(
    ("text", "kind", "approaches"),
    [
        ("The ego overtakes a van while a bus comes towards them.", "bus", {"opposite"}),
        ("A bus approaches the ego from behind.", "bus", {"behind"}),
        ("The ego is struck from behind by a bus.", "bus", {"behind"}),
        ("At a junction the ego is hit from the left by a bus.", "bus", {"left"}),
        ("At a Y-junction a bus on the left-hand branch waits for the ego.", "bus", {"left"}),
        ("A cyclist darts across from the right in front of the ego.", "bicycle", {"right"}),
        ("The ego backs out of a parking space; a bus comes from the right.", "bus", {"right"}),
        (
            "The ego waits at a junction; a bus from the other direction signals a turn.",
            "bus",
            {"opposite"},
        ),
    ],
)
def test_where_they_come_from(text, kind, approaches):
    assert other(text, kind).approaches == {Approach(a) for a in approaches}


@pytest.mark.parametrize(
    ("text", "maneuvers"),
    [
        ("At a junction a bus signals a right turn but carries straight on.", {"straight"}),
        ("At a junction a bus indicates left, but goes straight on.", {"straight"}),
        ("At a junction a bus signals and makes a right turn.", {"right"}),
        ("At a junction a bus sails straight through.", {"straight"}),
        ("A bus moves into the next lane.", {"lane_change"}),
        ("At a junction a bus cuts in and turns right.", {"right"}),
    ],
)
def test_ways(text, maneuvers):
    assert other(f"The ego waits. {text}", "bus").maneuvers == {Maneuver(m) for m in maneuvers}


def test_signs_belong_to_roads_and_lamps_to_vehicles():
    assert read("A car waits at its stop sign.").junction.control is Control.STOP
    assert read("A car runs its red light.").junction.control is Control.SIGNALS
    assert read("A car waits with its lights on.").junction.control is Control.UNCONTROLLED


def test_outside_a_junction_the_road_is_straight():
    text = "A cyclist crosses in front of a car, away from any junction."
    assert read(text).junction.kind is JunctionKind.STRAIGHT


def test_different_arms_leave_out_only_the_same_arm():
    scenario = read("Three cars approach a crossroads from different arms.")
    elsewhere = {Approach.LEFT, Approach.RIGHT, Approach.OPPOSITE}
    assert [p.approaches for p in scenario.participants] == [set(), elsewhere, elsewhere]
    assert [r.approaches for r in scenario.relations] == [elsewhere]
    assert not scenario.unsupported
