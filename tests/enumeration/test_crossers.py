"""Pedestrians, crossing cyclists, parked vehicles."""

from __future__ import annotations

import pytest

from scegen.enumeration import count_scenarios, enumerate_scenarios
from scegen.errors import NoScenarioError
from scegen.scenario.logical import ConflictKind, Crossing
from scegen.scenario.vocabulary import Reduction, Side

EGO = {"id": "ego", "role": "ego", "entries": [0], "maneuvers": ["straight"]}
PED = {"id": "ped", "kind": "pedestrian"}


def crossings(functional, name="ped"):
    found = enumerate_scenarios(functional, reduction=Reduction.NONE).scenarios
    return {(s.assignment(name).arm, s.assignment(name).start.value) for s in found}


def test_by_default_before_the_ego(describe):
    assert crossings(describe("four_way", 4, [EGO, PED])) == {
        (0, "right"), (0, "left"), (2, "right"), (2, "left")
    }  # fmt: skip


def test_from_the_right_of_the_ego(describe):
    """On the arm by which the ego leaves, its right is the left of those who come in."""
    functional = describe("four_way", 4, [EGO, PED | {"approaches": ["right"]}])
    assert crossings(functional) == {(0, "right"), (2, "left")}


def test_from_ahead_leaves_the_side_open(describe):
    functional = describe("four_way", 4, [EGO, PED | {"approaches": ["opposite"]}])
    assert len(crossings(functional)) == 4


def test_from_the_left_or_ahead_leaves_it_open_too(describe):
    functional = describe("four_way", 4, [EGO, PED | {"approaches": ["left", "ahead"]}])
    assert len(crossings(functional)) == 4


def test_from_the_pavement_opposite_on_the_left_is_from_the_left(describe):
    functional = describe("four_way", 4, [EGO, PED | {"approaches": ["left", "opposite"]}])
    assert crossings(functional) == {(0, "left"), (2, "right")}


def test_who_turns_round_sees_its_arm_as_it_came(describe):
    turning = EGO | {"maneuvers": ["u_turn"]}
    functional = describe("four_way", 4, [turning, PED | {"approaches": ["right"]}])
    assert crossings(functional) == {(0, "right")}


def test_before_the_one_who_suffers(describe):
    car = {"id": "car", "approaches": ["left"], "maneuvers": ["right"]}
    hazard = {"kind": "crossing_pedestrian", "by": ["ped"], "to": ["car"]}
    assert {arm for arm, _ in crossings(describe("four_way", 4, [EGO, car, PED], [hazard]))} == {
        3, 0
    }  # fmt: skip


def test_who_fails_to_yield_to_it_drives_there(describe):
    car = {"id": "car", "approaches": ["left"], "maneuvers": ["straight"]}
    hazard = {"kind": "failure_to_yield", "by": ["car"], "to": ["ped"]}
    assert {arm for arm, _ in crossings(describe("four_way", 4, [EGO, car, PED], [hazard]))} == {
        3, 1
    }  # fmt: skip


def test_arms_said(describe):
    functional = describe("four_way", 4, [EGO, PED | {"entries": [1]}])
    assert crossings(functional) == {(1, "right"), (1, "left")}


def test_a_cyclist_may_cross(describe):
    cyclist = {"id": "ped", "kind": "bicycle", "maneuvers": ["cross"]}
    scenario = enumerate_scenarios(describe("four_way", 4, [EGO, cyclist])).scenarios[0]
    assert isinstance(scenario.assignment("ped"), Crossing)
    assert [(c.first, c.second, c.kind) for c in scenario.conflicts] == [
        ("ego", "ped", ConflictKind.CROSSING)
    ]


def test_two_alike_are_not_told_apart(describe):
    functional = describe("four_way", 4, [EGO, PED, PED | {"id": "ped_2"}])
    certificate = count_scenarios(functional)
    assert (certificate.total, certificate.count) == (16, 10)


def test_in_exact_the_crossers_turn_along(describe):
    functional = describe("four_way", 4, [EGO | {"entries": []}, PED])
    certificate = count_scenarios(functional)
    assert (certificate.total, certificate.count) == (16, 4)


@pytest.mark.parametrize(
    ("turn", "crosses", "approach", "expected"),
    [
        ("left", "exit", [], {(3, "right"), (3, "left")}),
        ("left", "exit", ["right"], {(3, "left")}),
        ("right", "exit", ["left"], {(1, "right")}),
        ("right", "entry", ["left"], {(0, "left")}),
        ("straight", "entry", [], {(0, "right"), (0, "left")}),
    ],
)
def test_the_arm_by_which_whom_it_meets_comes_or_leaves(
    describe, turn, crosses, approach, expected
):
    walker = PED | {"crosses": crosses, "approaches": approach}
    assert crossings(describe("four_way", 4, [EGO | {"maneuvers": [turn]}, walker])) == expected


def test_of_whom_it_meets_the_arm_counts(describe):
    car = {"id": "car", "approaches": ["left"], "maneuvers": ["right"]}
    hazard = {"kind": "crossing_pedestrian", "by": ["ped"], "to": ["car"]}
    found = crossings(describe("four_way", 4, [EGO, car, PED | {"crosses": "exit"}], [hazard]))
    assert {arm for arm, _ in found} == {0}


def test_an_arm_that_it_cannot_be_is_told(describe):
    walker = PED | {"crosses": "exit", "entries": [0]}
    with pytest.raises(NoScenarioError, match="ped crosses the arm by which whom it meets leaves"):
        count_scenarios(describe("four_way", 4, [EGO, walker]))


@pytest.mark.parametrize(
    ("driving_side", "kind", "approaches", "side", "in_lane"),
    [
        ("right", "occlusion", [], Side.RIGHT, False),
        ("left", "occlusion", [], Side.LEFT, False),
        ("right", "obstacle", [], Side.RIGHT, True),
        ("right", "occlusion", ["left"], Side.LEFT, False),
    ],
)
def test_parked(describe, driving_side, kind, approaches, side, in_lane):
    parked = {"id": "parked", "parked": True, "approaches": approaches}
    functional = describe(
        "four_way",
        4,
        [EGO | {"entries": [3]}, parked],
        [{"kind": kind, "by": ["parked"]}],
        driving_side=driving_side,
    )
    (scenario,) = enumerate_scenarios(functional).scenarios
    (standing,) = scenario.standings
    assert (standing.arm, standing.side, standing.in_lane) == (3, side, in_lane)
    assert [c.kind for c in scenario.conflicts] == ([ConflictKind.FOLLOWING] if in_lane else [])


def test_parked_before_the_one_who_suffers(describe):
    functional = describe(
        "four_way",
        4,
        [EGO, {"id": "car", "entries": [1]}, {"id": "parked", "kind": "van", "parked": True}],
        [{"kind": "occlusion", "by": ["parked"], "to": ["car"]}],
    )
    found = enumerate_scenarios(functional).scenarios
    assert {s.assignment("parked").arm for s in found} == {1}


@pytest.mark.parametrize(("kind", "arms"), [("straight", 2), ("four_way", 4)])
@pytest.mark.parametrize("side", ["left", "right"])
def test_who_hides_somebody_is_on_its_side(describe, kind, arms, side):
    van = {"id": "van", "kind": "van", "parked": True}
    functional = describe(
        kind,
        arms,
        [EGO, PED | {"approaches": [side], "entries": [0]}, van],
        [{"kind": "occlusion", "by": ["van"], "to": ["ego"]}],
    )
    found = enumerate_scenarios(functional).scenarios
    assert {s.assignment("van").side for s in found} == {Side(side)}


def test_on_a_plain_road_also_by_the_far_end(describe):
    van = {"id": "van", "kind": "van", "parked": True}
    functional = describe(
        "straight",
        2,
        [EGO, PED | {"approaches": ["left"]}, van],
        [{"kind": "occlusion", "by": ["van"], "to": ["ego"]}],
    )
    found = enumerate_scenarios(functional, reduction=Reduction.NONE).scenarios
    assert {s.assignment("ped").arm for s in found} == {0, 1}
    assert {s.assignment("van").side for s in found} == {Side.LEFT}


@pytest.mark.parametrize(("entries", "arm"), [([1, 2], 1), ([1, 3], 3)])
def test_parked_on_an_arm_said(describe, entries, arm):
    """On the arm of the one whom it hinders if that is allowed, else on the first allowed."""
    parked = {"id": "parked", "parked": True, "entries": entries}
    (scenario,) = enumerate_scenarios(
        describe("four_way", 4, [EGO | {"entries": [3]}, parked])
    ).scenarios
    assert scenario.assignment("parked").arm == arm
