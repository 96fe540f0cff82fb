"""Sets taken apart: ordinals, partitives, others, further ones, people in vehicles."""

from collections import Counter

import pytest

from scegen.scenario.vocabulary import Maneuver
from scegen.understanding import read


def kinds(text):
    return Counter(p.kind.value for p in read(text).participants)


def moves(text):
    return [(p.kind.value, set(p.maneuvers)) for p in read(text).participants]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Five vehicles, three of them lorries, reach a junction.", {"truck": 3, "car": 2}),
        ("Four vehicles, one of which is a bus, reach a junction.", {"bus": 1, "car": 3}),
        ("Vehicle 1 is a pickup and vehicle 2 is a bus; they meet.", {"truck": 1, "bus": 1}),
        ("One car runs a red light while two others turn right.", {"car": 3}),
        ("The ego meets two cars coming from the left and one coming from the right.", {"car": 4}),
        ("Two cars reach a junction, one turning left and one turning right.", {"car": 2}),
        ("A moped overtakes both a van and a lorry.", {"motorcycle": 1, "van": 1, "truck": 1}),
        ("A car brakes; a passenger looks on.", {"car": 2}),
        ("The bus stops and a passenger crosses the road.", {"bus": 1, "pedestrian": 1}),
        ("The guy behind my car honks.", {"car": 2}),
        ("A van driver opens the door of his vehicle near a cyclist.", {"van": 1, "bicycle": 1}),
        ("The claimant was driving along when the third party pulled out.", {"car": 2}),
        ("P1 was crossing the road when V1 turned right.", {"pedestrian": 1, "car": 1}),
        ("Three vehicles meet: a bus goes on, a taxi waits and a van stops.", None),
        ("A long queue of four cars waits behind a bus.", {"car": 5, "bus": 1}),
        ("A road user brakes behind a bus.", {"car": 1, "bus": 1}),
        ("The pedestrian light turns green as a bus brakes.", {"bus": 1, "car": 1}),
        ("A car is parked half on the pavement near a bus.", {"car": 1, "bus": 1}),
        ("A woman backs her van out behind a bus.", {"van": 1, "bus": 1}),
        ("Ahead of us a car loses control and the car following it brakes.", {"car": 3}),
        ("Unit 1, a 2015 Ford F-150, was struck by unit 2, a bus from the left.", None),
    ],
)
def test_counts(text, expected):
    if expected is None:
        assert kinds(text) - Counter({"van": 1}) == {"car": 1, "bus": 1}
    else:
        assert kinds(text) == expected


def test_the_first_and_the_second_go_by_their_order():
    text = (
        "Two vans and a bus reach a junction; the first van turns left, the second goes straight."
    )
    assert moves(text) == [
        ("van", {Maneuver.LEFT}),
        ("van", {Maneuver.STRAIGHT}),
        ("bus", set()),
    ]


def test_a_second_car_that_was_not_named_before_is_new():
    text = "At a crossroads a car turns left. The second car goes straight."
    assert moves(text) == [("car", {Maneuver.LEFT}), ("car", {Maneuver.STRAIGHT})]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("One van goes left, the other right at a junction.", [Maneuver.LEFT, Maneuver.RIGHT]),
        ("A van turns left and a bus right at a junction.", [Maneuver.LEFT, Maneuver.RIGHT]),
        (
            "At a roundabout a taxi takes the second exit and a cyclist the first.",
            [Maneuver.EXIT_2, Maneuver.EXIT_1],
        ),
        (
            "A car takes the first exit of a roundabout and the other the second.",
            [Maneuver.EXIT_1, Maneuver.EXIT_2],
        ),
    ],
)
def test_a_verb_left_out_is_the_one_before(text, expected):
    assert [set(p.maneuvers) for p in read(text).participants] == [{m} for m in expected]


@pytest.mark.parametrize(
    "text",
    [
        "The ego makes either a left or a right turn.",
        "The ego turns either left or right at a junction.",
        "The ego performs a turn at a junction.",
    ],
)
def test_either_way_is_a_set(text):
    assert read(text).ego.maneuvers == {Maneuver.LEFT, Maneuver.RIGHT}


def test_who_is_passed_does_not_come_from_the_side_of_the_passing():
    scenario = read("The ego waits behind a van; a taxi from behind passes both on the right.")
    seen = {p.kind.value: {str(a) for a in p.approaches} for p in scenario.participants}
    assert seen["van"] == {"ahead"}


def test_a_side_left_out_with_its_verb():
    scenario = read("A bus approaches the ego from the left and a taxi from the right.")
    seen = {p.kind.value: {str(a) for a in p.approaches} for p in scenario.participants}
    assert seen["bus"] == {"left"}
    assert {"right"} in [v for k, v in seen.items() if k == "car"]


def test_a_participant_of_a_heading_is_nobody_new():
    text = "Car-to-bicyclist crossing: a bicyclist crosses in front of the test vehicle."
    assert kinds(text) == {"car": 1, "bicycle": 1}
    told = read("Bicyclist crossing from the left: the ego brakes for the bicyclist.")
    assert [set(p.approaches) for p in told.participants if p.kind == "bicycle"] == [{"left"}]


def test_several_are_overtaken():
    scenario = read("A moped overtakes a van and a lorry.")
    (hazard,) = scenario.hazards
    assert set(hazard.to) == {p.id for p in scenario.participants} - set(hazard.by)


def test_the_one_overtaken_does_not_overtake():
    scenario = read("The ego is passed by a bus.")
    assert scenario.ego.maneuvers == {Maneuver.STRAIGHT}
    assert [h.by for h in scenario.hazards] == [("bus_1",)]
