"""Who drives where nobody is called the ego, whom one overtakes, and words of two meanings."""

import pytest

from scegen.scenario.acts import ActKind
from scegen.scenario.vocabulary import (
    Approach,
    HazardKind,
    Maneuver,
    ParticipantKind,
    Role,
)
from scegen.understanding import read


def _kinds(text):
    return sorted(p.kind.value for p in read(text).participants)


def _ego(scenario):
    return next(p for p in scenario.participants if p.role is Role.EGO)


@pytest.mark.parametrize(
    ("text", "speed_kmh"),
    [
        ("The lead creeps at 10 km/h and the ego closes in from behind.", 10),
        ("The lead creeps forward at 3 km/h in front of the ego.", 3),
        ("Lead creeps at 10 km/h, ego follows at 30 km/h.", 10),
        ("The slow lead creeps at 8 km/h while the ego overtakes it.", 8),
        ("The leader creeps at 10 km/h and the ego overtakes it.", 10),
    ],
)
def test_the_lead_creeps(text, speed_kmh):
    scenario = read(text)
    assert _kinds(text) == ["car", "car"]
    lead = next(p for p in scenario.participants if p.role is Role.OTHER)
    assert lead.approaches == {Approach.AHEAD}
    assert lead.speed_mps.low == pytest.approx(speed_kmh / 3.6, abs=1e-4)
    assert HazardKind.SLOW_DRIVING in {h.kind for h in scenario.hazards}


def test_one_of_several_creeps():
    assert _kinds("The first car stops, the second creeps at 10 km/h.") == ["car", "car"]
    assert _kinds("The van stops, the other creeps at 5 km/h.") == ["car", "van"]


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("The lead cycles brake in front of the ego.", ["bicycle", "bicycle", "car"]),
        ("The ego follows the lead cycles.", ["bicycle", "bicycle", "car"]),
    ],
)
def test_nouns_of_that_spelling_stay_nouns(text, kinds):
    assert _kinds(text) == kinds


@pytest.mark.parametrize(
    "text",
    [
        "Tram stop: a child runs across the road in front of a waiting bus.",
        "A child runs out in front of a waiting bus.",
        "A pedestrian crosses the road in front of a stationary bus.",
        "A woman crosses behind a stopped bus.",
        "A dog runs across the road in front of a bus that stands there.",
    ],
)
def test_who_stands_is_not_the_ego(text):
    scenario = read(text)
    ego = _ego(scenario)
    assert ego.kind is ParticipantKind.CAR
    assert ego.maneuvers == {Maneuver.STRAIGHT}
    bus = next(p for p in scenario.participants if p.kind is ParticipantKind.BUS)
    assert bus.role is Role.OTHER
    assert bus.parked or bus.maneuvers == {Maneuver.STAY}


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("The stationary car is hit from behind by a truck.", "truck"),
        ("The stationary car is hidden behind a bend; a truck approaches.", "truck"),
        ("A van overtakes the stationary car on a motorway.", "van"),
        ("A bus crashes into a stationary lorry.", "bus"),
        ("A waiting bus pulls out as a van approaches.", "van"),
    ],
)
def test_the_ego_is_one_that_drives(text, kind):
    assert _ego(read(text)).kind.value == kind


def test_if_all_stand_one_of_them_is_the_ego():
    assert _kinds("Five buses stand at a junction with five approaches.") == ["bus"] * 5


def test_whose_case_is_told_is_the_ego_although_it_stands():
    text = "The insured vehicle was stationary when it was hit in the rear by a van."
    assert _ego(read(text)).kind is ParticipantKind.CAR


@pytest.mark.parametrize(
    ("text", "overtaken", "oncoming"),
    [
        (
            "A cyclist rides along the right edge of the road at 15 km/h, the ego overtakes with "
            "1 m of clearance while an oncoming car approaches.",
            ["bicycle_1"],
            ["car_1"],
        ),
        (
            "A tractor drives at 20 km/h on a country road; the ego overtakes although an oncoming "
            "van is near.",
            ["truck_1"],
            ["van_1"],
        ),
        (
            "An oncoming car approaches and a van drives at 40 km/h, the ego overtakes.",
            ["van_1"],
            ["car_1"],
        ),
        (
            "A van drives at 40 km/h and a truck comes the other way; the ego overtakes.",
            ["van_1"],
            ["truck_1"],
        ),
        (
            "Two cyclists ride at 18 km/h on a country road, the ego overtakes.",
            ["bicycle_1", "bicycle_2"],
            [],
        ),
    ],
)
def test_who_goes_the_same_way_is_overtaken(text, overtaken, oncoming):
    scenario = read(text)
    at = {p.id: p.approaches for p in scenario.participants}
    assert [h.to for h in scenario.hazards if h.kind is HazardKind.OVERTAKING] == [tuple(overtaken)]
    assert all(at[name] == {Approach.AHEAD} for name in overtaken)
    assert all(at[name] == {Approach.OPPOSITE} for name in oncoming)


def test_nobody_who_could_be_overtaken_is_chosen_from_two():
    text = "A van drives at 40 km/h. A bus drives at 50 km/h. The ego overtakes."
    assert [h.to for h in read(text).hazards if h.kind is HazardKind.OVERTAKING] == [()]


@pytest.mark.parametrize(
    ("text", "rate"),
    [
        ("Bus stops with 1.8 m/s².", 1.8),
        ("Bus stops with 1.8 m/s², the ego follows at 50 km/h.", 1.8),
        ("Truck stops with 3 m/s² ahead of the ego.", 3.0),
        ("The ego drives at 50 km/h, bus stops at 2 m/s² in front of it.", 2.0),
    ],
)
def test_a_bus_stops(text, rate):
    scenario = read(text)
    brakes = [a for a in scenario.acts if a.kind is ActKind.BRAKE]
    assert [a.rate_mps2.low for a in brakes] == [pytest.approx(rate)]
    assert scenario.unsupported == ()


@pytest.mark.parametrize(
    "text",
    [
        "Bus stops on both sides of the road; a child runs across.",
        "Bus stops ahead are empty; the ego drives past.",
    ],
)
def test_bus_stops_are_places(text):
    scenario = read(text)
    assert all(p.kind is not ParticipantKind.BUS for p in scenario.participants)
    assert "Bus stops" in {u.text for u in scenario.unsupported}


@pytest.mark.parametrize(
    ("text", "lanes", "drives_in"),
    [
        ("On a road with two lanes in each direction, a car in the left lane brakes in front of "
         "the ego.", (2, 2), {"car_1": 1}),
        ("On a street with three lanes in each direction, a bus in the right lane brakes, the ego "
         "follows.", (3, 3), {"bus_1": 3}),
        ("On a motorway with three lanes, the ego drives in the middle lane of three.", (3, 3),
         {"ego": 2}),
        ("The ego is in the middle lane of three and a truck in the right lane cuts in.", (3, 3),
         {"ego": 2, "truck_1": 3}),
        ("The ego drives in the left lane of four.", (4, 4), {"ego": 1}),
    ],
)  # fmt: skip
def test_lanes_by_number_and_count(text, lanes, drives_in):
    scenario = read(text)
    assert scenario.junction.lanes == lanes
    assert {p.id: min(p.lanes) for p in scenario.participants if p.lanes} == drives_in
    assert "number" not in {u.text for u in scenario.unsupported}


def test_lanes_in_each_direction_spread_nobody():
    text = "On a road with two lanes in each direction, a car in the left lane cuts in."
    assert _kinds(text) in (["car"], ["car", "car"])
    assert len(read("From each direction, a car approaches a crossroads.").participants) == 4


@pytest.mark.parametrize(
    ("text", "strip"),
    [
        ("A bus pulls out of a bus stop in front of the ego.", "bus_stop"),
        ("A car pulls out of a parking bay in front of the ego.", "parking"),
        ("A taxi pulls out of the parking lane in front of the ego.", "parking"),
        ("A delivery van pulls out of a parking space as the ego approaches.", "parking"),
        ("A bus pulls out of a bus bay as the ego approaches at 40 km/h.", "bus_stop"),
    ],
)
def test_who_pulls_out_of_a_strip_stood_there(text, strip):
    other = next(p for p in read(text).participants if p.role is Role.OTHER)
    assert other.strip is not None
    assert other.strip.value == strip
    assert other.parked


@pytest.mark.parametrize(
    "text",
    [
        "A parked taxi on the right pulls away and makes a U-turn as the ego is 35 m short of it.",
        "A car that was stopped on the right shoulder makes a U-turn when the ego is 35 m from it.",
    ],
)
def test_who_turns_back_from_the_kerb_sets_off_for_that(text):
    found = read(text)
    parked = next(p for p in found.participants if p is not found.ego)
    assert (parked.parked, parked.strip, parked.maneuvers) == (True, None, {Maneuver.U_TURN})
    (act,) = (act for act in found.acts if act.when is not None)
    assert (act.kind, act.when.value.middle) == (ActKind.SET_OFF, 35.0)
