"""Who a role means by where it is, what kind a counted junction is, and what is a danger."""

from collections import Counter

import pytest

from scegen.scenario.vocabulary import Approach, Control, JunctionKind, Maneuver
from scegen.understanding import read


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The ego follows a van through town; the adversarial van ahead stops.", {"van": 1}),
        (
            "The ego drives behind a bus; the adversarial bus in front of the ego swerves.",
            {"bus": 1},
        ),
        ("The ego tailgates a lorry. The adversarial lorry ahead brakes.", {"truck": 1}),
        ("The ego follows a bus; the adversarial bus behind swerves.", {"bus": 2}),
        ("The ego follows a van; the adversarial bus ahead stops.", {"van": 1, "bus": 1}),
        ("The ego overtakes a van; the adversarial van ahead stops.", {"van": 2}),
        ("The ego follows a van; the adversarial van ahead of a bus stops.", {"van": 2, "bus": 1}),
    ],
)
def test_a_role_is_the_one_who_is_already_there(text, expected):
    others = Counter(p.kind.value for p in read(text).participants if p.role != "ego")
    assert others == expected


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("A five-arm roundabout where two cars meet.", JunctionKind.ROUNDABOUT),
        ("Two cars enter a four-legged roundabout.", JunctionKind.ROUNDABOUT),
        ("A three-arm roundabout with a bus.", JunctionKind.ROUNDABOUT),
        ("Two vans meet at a three-leg Y-junction.", JunctionKind.Y),
        ("Two vans meet at a three-leg junction.", JunctionKind.T),
        ("Two vans meet at a four-leg junction.", JunctionKind.FOUR_WAY),
        ("Two vans meet at a four-way T-junction.", JunctionKind.T),
    ],
)
def test_arms_are_counted_but_the_noun_says_what_kind_it_is(text, kind):
    assert read(text).junction.kind is kind


def test_a_counted_signalised_junction():
    junction = read("A 4-leg signalised intersection with two cars.").junction
    assert (junction.kind, junction.control) == (JunctionKind.FOUR_WAY, Control.SIGNALS)


def hazards(text):
    return {h.kind.value for h in read(text).hazards}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A van overtakes the ego and cuts back into the ego's lane.", {"overtaking", "cut_in"}),
        ("A van suddenly switches from the outer to the inner lane of a roundabout.", {"cut_in"}),
        ("A van calmly changes from the slow to the fast lane.", set()),
        ("The ego drives through a junction whose left side is hidden by a hedge.", {"occlusion"}),
        ("The ego passes a cycle path shielded by a fence.", set()),
        ("A boy crosses the road in the middle of the block.", {"crossing_pedestrian"}),
        ("A bus blocks the ego.", {"stopping"}),
        ("The ego comes up to a lorry parked in its lane.", {"obstacle"}),
        ("The ego comes up to a lorry parked in the next lane.", set()),
        ("A van in front of the ego accelerates slowly.", {"slow_driving"}),
        ("A van behind the ego accelerates.", {"sudden_acceleration"}),
    ],
)
def test_what_is_a_danger(text, expected):
    assert hazards(text) == expected


SIDES = {Approach.LEFT, Approach.RIGHT}


@pytest.mark.parametrize(
    ("text", "kind", "approaches"),
    [
        ("The ego turns left; a moped hidden behind an oncoming van appears.", "motorcycle",
         {Approach.OPPOSITE}),
        ("At a crossroads the ego waits for an ambulance which crosses on red.",
         "emergency_vehicle", SIDES),
        ("At a crossroads the ego waits for an oncoming ambulance which crosses on red.",
         "emergency_vehicle", {Approach.OPPOSITE}),
        ("The ego goes straight at a T-junction as a van from the side road turns right.",
         "van", SIDES),
        ("The ego turns left at a T-junction as a van from the side road turns right.",
         "van", set()),
    ],
)  # fmt: skip
def test_where_they_come_from(text, kind, approaches):
    who = next(p for p in read(text).participants if p.kind == kind)
    assert who.approaches == approaches


@pytest.mark.parametrize("what", ["right turn", "turning right"])
def test_what_stands_after_a_colon_is_what_the_one_before_it_does(what):
    text = f"Signalised crossroads. Ego: {what}. Other party: oncoming bus, going straight."
    going = {p.role == "ego": p.maneuvers for p in read(text).participants}
    assert going == {True: {Maneuver.RIGHT}, False: {Maneuver.STRAIGHT}}


def test_so_many_who_come_are_not_the_ego_and_another():
    found = read("The ego turns left across oncoming traffic; two cars come from the other side.")
    assert len([p for p in found.participants if p.role != "ego"]) >= 2
    found = read("The ego follows a car; two cars come towards them.")
    assert sorted(p.id for p in found.participants) == ["car_1", "car_2", "car_3", "ego"]
