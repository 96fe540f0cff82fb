"""Several participants in one sentence: names, shares, sequences, who is who."""

import pytest

from scegen.errors import InfeasibleError
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, ParticipantKind
from scegen.understanding import read


def maneuvers(text):
    return [set(p.maneuvers) for p in read(text).participants]


def kinds(text):
    return sorted(p.kind.value for p in read(text).participants)


@pytest.mark.parametrize(
    "text",
    [
        "Cars A and B were travelling north and east respectively at a crossroads.",
        "Vehicles 1 and 2 were travelling north and east, respectively, towards a crossroads.",
        "Two cars drive north and east towards a crossroads.",
        "Two cars approach a crossroads from the south and the west.",
    ],
)
def test_headings_are_shared_out(text):
    first, second = read(text).participants
    assert first.role == "ego"
    assert second.approaches == {Approach.LEFT}


def test_speeds_are_shared_out_only_if_the_text_says_so():
    shared = read("Cars A and B drive at 36 and 72 km/h, respectively.").participants
    assert [p.speed_mps.low for p in shared] == [pytest.approx(10), pytest.approx(20)]
    assert [p.speed_mps.high for p in shared] == [pytest.approx(10), pytest.approx(20)]
    ranged = read("Cars A and B drive between 36 and 72 km/h.").participants
    assert {(round(p.speed_mps.low), round(p.speed_mps.high)) for p in ranged} == {(10, 20)}


def test_turns_are_shared_out():
    shared = [{Maneuver.STRAIGHT}, {Maneuver.LEFT}]
    assert maneuvers("A truck and a van go straight and turn left, respectively.") == shared
    assert maneuvers("Two vans at a T-junction turn left and right.") == [
        {Maneuver.LEFT},
        {Maneuver.RIGHT},
    ]


def test_a_list_of_names_makes_no_further_vehicles():
    assert kinds("Vehicles 1, 2 and 3 wait at a crossroads. V2 turns left.") == ["car"] * 3
    assert kinds("Both vehicles entered the crossroads; V1 was northbound.") == ["car"] * 2


@pytest.mark.parametrize(
    "text",
    [
        "Unit 1, a lorry, was southbound.",
        "Unit 1 (a lorry) was southbound.",
    ],
)
def test_an_apposition_tells_the_kind(text):
    assert kinds(text) == ["truck"]


def test_members_of_a_total_get_their_kind():
    assert kinds("Five vehicles, including one bus and two vans, meet at a roundabout.") == [
        "bus",
        "car",
        "car",
        "van",
        "van",
    ]
    assert kinds("Four vehicles at a crossroads: two cars, a bus and a van.") == [
        "bus",
        "car",
        "car",
        "van",
    ]


def test_one_car_beside_a_group_that_goes_its_way_is_somebody_else():
    assert len(kinds("Three cars go straight on and one car turns left.")) == 4
    assert len(kinds("Three cars meet at a crossroads and one car turns left.")) == 3


@pytest.mark.parametrize(
    ("text", "second"),
    [
        ("Two vans meet at a T-junction. The first turns left, the second turns right.", 1),
        ("A bus and a van meet at a T-junction. The former turns left, the latter turns right.", 1),
        ("Two vans meet at a T-junction. One turns left and the other one turns right.", 1),
    ],
)
def test_ordinals(text, second):
    found = maneuvers(text)
    assert found[0] == {Maneuver.LEFT}
    assert found[second] == {Maneuver.RIGHT}
    assert len(found) == 2


def test_it_is_not_the_one_that_it_places():
    scenario = read("The ego brakes and the van behind it swerves.")
    assert scenario.participant("van_1").approaches == {Approach.BEHIND}


def test_neither_means_both_do_not():
    for text in (
        "Two vans meet at a crossroads and neither yields.",
        "Neither the bus nor the van yields at a crossroads.",
    ):
        scenario = read(text)
        (hazard,) = scenario.hazards
        assert hazard.kind is HazardKind.FAILURE_TO_YIELD
        assert len(hazard.by) == 2


def test_turns_one_after_the_other_are_no_contradiction():
    text = "The ego turns right at the first junction and then turns left at the second one."
    scenario = read(text)
    assert scenario.ego.maneuvers == {Maneuver.RIGHT}
    assert len(scenario.participants) == 1
    left_out = next(u for u in scenario.unsupported if u.text == "turns left")
    assert "later turn" in left_out.instead
    with pytest.raises(InfeasibleError, match="'turns left'"):
        read("The ego turns right at the junction and turns left at the junction.")


@pytest.mark.parametrize(
    "text",
    [
        "V2 entered the lane in front of V1.",
        "V2 pulled into the lane ahead of V1.",
        "A van moves into the ego's lane.",
        "A van pulls into our lane.",
        "A bus overtakes the ego and swings in front of it.",
    ],
)
def test_entering_the_lane_in_front_is_cutting_in(text):
    assert HazardKind.CUT_IN in {h.kind for h in read(text).hazards}


def test_the_lane_of_an_oncoming_vehicle_is_no_cut_in():
    kinds_found = {h.kind for h in read("An oncoming van moves into the ego's lane.").hazards}
    assert kinds_found == {HazardKind.ONCOMING_LANE}


def test_whoever_waits_behind_something_and_comes_out_was_hidden():
    hidden = read("A boy waits behind a parked van and then runs across the road.")
    assert HazardKind.OCCLUSION in {h.kind for h in hidden.hazards}
    seen = read("A boy waits behind a parked van.")
    assert HazardKind.OCCLUSION not in {h.kind for h in seen.hazards}


def test_positions_without_an_observer_imply_one():
    scenario = read("The car ahead brakes hard.")
    assert [p.kind for p in scenario.participants] == [ParticipantKind.CAR] * 2
    evidence = next(e for e in scenario.evidence if e.field == "participants.ego.role")
    assert "not named" in (evidence.reason or "")


def test_whom_a_hazard_threatens_is_left_open_where_it_is_not_said():
    scenario = read("The ego follows a van on a road. The van brakes hard.")
    (hazard,) = scenario.hazards
    assert hazard.to == ()
    stated = read("A van tailgates the ego.")
    assert not any(e.field.endswith(".to") for e in stated.evidence)
