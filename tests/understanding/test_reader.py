import pytest

from scegen.errors import InfeasibleError, InputError, NotTrafficError
from scegen.scenario.evidence import EvidenceSource
from scegen.scenario.vocabulary import (
    Approach,
    Control,
    HazardKind,
    JunctionKind,
    Maneuver,
    ParticipantKind,
    Role,
)
from scegen.understanding import MAX_CHARACTERS, read


def hazards(scenario):
    return {h.kind: (h.by, h.to) for h in scenario.hazards}


def kinds(scenario):
    return sorted(p.kind.value for p in scenario.participants)


@pytest.mark.parametrize(
    ("text", "kind", "arms"),
    [
        ("Two vans meet at a T-junction.", JunctionKind.T, 3),
        ("Two vans meet at a three-way intersection.", JunctionKind.T, 3),
        ("Two vans meet at a Y-shaped junction.", JunctionKind.Y, 3),
        ("Two vans meet at a crossroads.", JunctionKind.FOUR_WAY, 4),
        ("Two vans meet at an intersection.", JunctionKind.FOUR_WAY, 4),
        ("Two vans meet at a six-way intersection.", JunctionKind.MULTI_WAY, 6),
        ("Two vans enter a roundabout with 5 exits.", JunctionKind.ROUNDABOUT, 5),
        ("Two vans meet at an intersection where roads cross at acute angles.", "skewed", 4),
        ("Two vans drive on a straight road.", JunctionKind.STRAIGHT, 2),
        ("A van turns left.", JunctionKind.FOUR_WAY, 4),
    ],
)
def test_junctions(text, kind, arms):
    junction = read(text).junction
    assert (junction.kind, junction.arms) == (kind, arms)


@pytest.mark.parametrize(
    ("text", "control"),
    [
        ("A bus waits at an intersection with traffic lights.", Control.SIGNALS),
        ("A bus passes a stop sign at a crossroads.", Control.STOP),
        ("A bus arrives at an all-way stop.", Control.ALL_WAY_STOP),
        ("A bus reaches an intersection with a yield sign.", Control.YIELD),
        ("A bus crosses an intersection without traffic lights.", Control.UNCONTROLLED),
        ("A bus reaches a crossroads with priority to the right.", Control.PRIORITY_TO_RIGHT),
    ],
)
def test_control(text, control):
    assert read(text).junction.control is control


def test_one_and_the_other_are_members_of_the_group():
    scenario = read("Two trucks reach a crossroads. One turns left while the other goes straight.")
    assert [p.maneuvers for p in scenario.participants] == [{Maneuver.LEFT}, {Maneuver.STRAIGHT}]


def test_a_further_one_is_somebody_new():
    scenario = read("A car brakes hard while another car follows it and a third car overtakes.")
    assert kinds(scenario) == ["car"] * 3


def test_traffic_takes_in_the_one_that_is_named_later():
    scenario = read("The ego yields to oncoming traffic when an oncoming motorcycle swerves.")
    assert kinds(scenario) == ["car", "car", "motorcycle"]
    assert scenario.participant("motorcycle_1").approaches == {Approach.OPPOSITE}


def test_clauses_keep_to_their_subject():
    scenario = read(
        "The ego turns right at an intersection while a bus that is oncoming turns left."
    )
    assert scenario.ego.maneuvers == {Maneuver.RIGHT}
    assert scenario.participant("bus_1").maneuvers == {Maneuver.LEFT}


def test_object_control():
    scenario = read("A truck brakes, forcing the van to turn right at the junction.")
    assert scenario.participant("van_1").maneuvers == {Maneuver.RIGHT}
    assert scenario.participant("truck_1").maneuvers == frozenset()


def test_alternatives_make_a_set():
    scenario = read("The ego either goes straight or makes a left turn at a crossroads.")
    assert scenario.ego.maneuvers == {Maneuver.STRAIGHT, Maneuver.LEFT}


def test_the_passive_turns_the_roles_round():
    scenario = read("A van is tailgated by a lorry on a country road.")
    assert hazards(scenario) == {HazardKind.TAILGATING: (("truck_1",), ("van_1",))}
    assert scenario.ego.id == "van_1"
    assert scenario.participant("truck_1").approaches == {Approach.BEHIND}


def test_compass_headings_become_positions():
    scenario = read("Vehicle 1 was travelling northbound. Vehicle 2 was heading west.")
    assert scenario.ego.id == "car_1"
    assert scenario.participant("car_2").approaches == {Approach.RIGHT}


def test_relations_between_others():
    scenario = read("The ego follows a bus. A van is driving behind a lorry.")
    relation = scenario.relations[0]
    assert {relation.participant, relation.reference} == {"van_1", "truck_1"}


def test_somebody_on_foot_alone_gets_an_ego():
    scenario = read("A pedestrian crosses the road.")
    assert scenario.ego.kind is ParticipantKind.CAR
    role = next(e for e in scenario.evidence if e.field == "participants.ego.role")
    assert role.source is EvidenceSource.INFERRED
    (hazard,) = scenario.hazards
    assert (hazard.kind, hazard.by) == (HazardKind.CROSSING_PEDESTRIAN, ("pedestrian_1",))


def test_parked_cars_hide_and_stay():
    scenario = read("A boy runs out from between two parked vans in front of a taxi.")
    parked = [p for p in scenario.participants if p.parked]
    assert [p.id for p in parked] == ["parked_van_1", "parked_van_2"]
    assert all(p.maneuvers == {Maneuver.STAY} for p in parked)
    assert hazards(scenario)[HazardKind.OCCLUSION][0] == ("parked_van_1", "parked_van_2")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A taxi speeds through a crossroads.", HazardKind.SPEEDING),
        ("The car ahead of the ego suddenly brakes.", HazardKind.HARD_BRAKING),
        ("A van runs a red light at an intersection.", HazardKind.RED_LIGHT_RUNNING),
        ("A van fails to yield to the bus at a crossroads.", HazardKind.FAILURE_TO_YIELD),
        ("A lorry reverses towards the ego.", HazardKind.REVERSING),
        ("A cyclist crosses the road in front of the ego.", HazardKind.CROSSING_CYCLIST),
        ("A van drifts into the oncoming lane.", HazardKind.ONCOMING_LANE),
        ("The ego skids on an icy road.", HazardKind.LOSS_OF_CONTROL),
        ("A bus abruptly changes lanes in front of the ego.", HazardKind.CUT_IN),
        ("A taxi overtakes the ego.", HazardKind.OVERTAKING),
        ("A hedge blocks the view at a junction where a van waits.", HazardKind.OCCLUSION),
        ("The ego brakes too late behind a van.", HazardKind.DELAYED_BRAKING),
        ("A box lies on the road in front of the ego.", HazardKind.OBSTACLE),
    ],
)
def test_hazards(text, expected):
    assert expected in hazards(read(text))


def test_what_does_not_happen_is_no_hazard():
    assert hazards(read("A van does not overtake the bus on the road.")) == {}
    assert kinds(read("A van is on the road and there are no pedestrians.")) == ["van"]


def test_quantities():
    scenario = read(
        "On a road with a speed limit of 50 km/h a taxi drives at 70 km/h, a bus at 30 to 40 km/h."
    )
    assert scenario.junction.speed_limit_mps == pytest.approx(13.889, abs=1e-3)
    speed = scenario.participant("car_1").speed_mps
    assert speed is not None
    assert speed.low == pytest.approx(19.444, abs=1e-3)


def test_environment_and_driving_side():
    scenario = read("In left-hand traffic, two cars meet on a wet road at night in heavy rain.")
    assert scenario.junction.driving_side == "left"
    assert scenario.environment.weather == "heavy_rain"
    assert scenario.environment.time_of_day == "night"
    assert scenario.environment.road_surface == "wet"


def test_from_all_directions_gives_every_arm_one_vehicle():
    scenario = read("Vehicles arrive at a T-intersection from all directions.")
    assert [sorted(p.entries) for p in scenario.participants] == [[0], [1], [2]]


def test_roundabout_exits():
    scenario = read("In a roundabout with 5 exits the ego takes the second exit.")
    assert scenario.ego.maneuvers == {Maneuver.EXIT_2}


def test_vague_numbers_are_inferred_with_a_reason():
    scenario = read("Several buses approach a crossroads.")
    assert kinds(scenario) == ["bus"] * 3
    evidence = next(e for e in scenario.evidence if e.field == "participants.bus_1.kind")
    assert evidence.source is EvidenceSource.INFERRED
    assert evidence.reason is not None
    assert "several" in evidence.reason


def test_nothing_is_dropped_silently():
    scenario = read("A purplish van with a flurbled spoiler overtakes a red bus.")
    reported = " ".join(u.text for u in scenario.unsupported)
    for word in ("purplish", "flurbled", "spoiler", "red"):
        assert word in reported


def test_an_unknown_verb_keeps_the_clause_together():
    scenario = read("The ego unleashes a left turn at a crossroads.")
    assert scenario.ego.maneuvers == {Maneuver.LEFT}
    assert [u.text for u in scenario.unsupported] == ["unleashes"]


@pytest.mark.parametrize("text", ["", "   \n\t"])
def test_empty_text(text):
    with pytest.raises(InputError):
        read(text)


def test_endless_text():
    with pytest.raises(InputError, match="characters"):
        read("a car " * MAX_CHARACTERS)


@pytest.mark.parametrize(
    "text",
    ["The cat sleeps on the sofa.", "Write me a poem.", "12345", "I like you.", "日本語", "..."],
)
def test_other_subjects(text):
    with pytest.raises(NotTrafficError, match="For example"):
        read(text)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("A roundabout with 1 exit.", "1 exit"),
        ("A roundabout with twelve exits.", "twelve exits"),
        ("A T-intersection with five arms.", "five arms"),
        ("The ego turns left and the ego turns right.", "contradictory maneuvers"),
        ("A hundred buses and 100 trucks meet on a road.", "more than 24"),
    ],
)
def test_what_cannot_be(text, words):
    with pytest.raises(InfeasibleError, match=words):
        read(text)


def test_there_is_one_ego_that_moves():
    for text in ("Two cars meet.", "A parked van.", "Three cyclists at a roundabout."):
        egos = [p for p in read(text).participants if p.role is Role.EGO]
        assert len(egos) == 1
        assert not egos[0].parked
