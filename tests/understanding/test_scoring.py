from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import Approach, HazardKind, JunctionKind, Maneuver, Role
from scegen.understanding import score

SCENARIO = FunctionalScenario(
    description="made by hand",
    junction=Junction(kind=JunctionKind.T, arms=3),
    participants=(
        Participant(id="ego", role=Role.EGO, maneuvers=frozenset({Maneuver.LEFT})),
        Participant(id="car_1", approaches=frozenset({Approach.LEFT})),
        Participant(id="car_2", approaches=frozenset({Approach.LEFT, Approach.RIGHT})),
        Participant(id="parked_car_1", parked=True, maneuvers=frozenset({Maneuver.STAY})),
    ),
    hazards=(Hazard(kind=HazardKind.SPEEDING, by=("car_1",)),),
)


def holds(**expect):
    return score(expect, SCENARIO).understood


def test_lists_of_acceptable_values():
    assert holds(junction=["t", "y"], arms=[3], control=["uncontrolled"])
    assert not holds(junction=["four_way"])
    assert not holds(arms=[4])


def test_actors_count_by_kind_and_parked():
    assert holds(actors={"car": [3, 3], "parked_car": [1, 6]})
    assert not holds(actors={"car": [3, 3]})
    assert not holds(actors={"car": [4, 4], "parked_car": [1, 1]})
    assert not holds(actors={"car": [3, 3], "parked_car": [1, 1], "bus": [1, 1]})


def test_the_ego_needs_a_maneuver():
    assert holds(ego={"maneuver": ["left", "right"]})
    assert not holds(ego={"maneuver": ["straight"]})


def test_others_are_matched_one_to_one():
    left, either = {"kind": "car", "from": ["left"]}, {"kind": "car", "from": ["left", "right"]}
    assert holds(others=[either, left])
    assert holds(others=[left, either])
    assert not holds(others=[left, left])
    assert not holds(others=[either, either, either])


def test_the_ego_is_no_other_where_it_is_judged():
    turner = {"kind": "car", "maneuver": ["left"]}
    assert holds(others=[turner])
    assert not holds(others=[turner], ego={"maneuver": ["left"]})


def test_hazards_must_and_may():
    assert holds(hazards={"must": ["speeding"], "may": []})
    assert holds(hazards={"must": [], "may": ["speeding"]})
    assert not holds(hazards={"must": [], "may": []})
    assert not holds(hazards={"must": ["speeding", "cut_in"], "may": []})


def test_problems_name_the_field():
    result = score({"arms": [4]}, SCENARIO)
    assert result.fields == {"arms": False}
    assert "arms is 3" in result.problems[0]
