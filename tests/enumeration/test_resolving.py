"""Who causes and suffers a danger, and to which side an act goes, in each scenario."""

from __future__ import annotations

import pytest

from scegen.enumeration import enumerate_scenarios
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.vocabulary import HazardKind

EGO = {"id": "ego", "role": "ego"}


def resolved(functional):
    """(by, to) of the first danger, in every scenario."""
    return {(s.hazards[0].by, s.hazards[0].to) for s in enumerate_scenarios(functional).scenarios}


def test_who_brakes_endangers_the_next_behind_it(describe):
    car = {"id": "car", "approaches": ["ahead"]}
    van = {"id": "van", "kind": "van", "approaches": ["behind"]}
    functional = describe("straight", 2, [EGO, car, van], [{"kind": "hard_braking", "by": ["car"]}])
    assert resolved(functional) == {(("car",), ("ego",))}
    functional = describe("straight", 2, [EGO, car, van], [{"kind": "hard_braking", "by": ["ego"]}])
    assert resolved(functional) == {(("ego",), ("van",))}


def test_the_last_of_three_who_brakes_endangers_none_of_those_ahead(describe):
    lead = {"id": "lead", "approaches": ["ahead"]}
    last = {"id": "last", "approaches": ["behind"]}
    braking = {"kind": "hard_braking", "by": ["last"]}
    assert resolved(describe("straight", 2, [EGO, lead, last], [braking])) == {(("last",), ())}


@pytest.mark.parametrize("comes", [False, True])
def test_who_brakes_endangers_nobody_in_front_of_it(describe, comes):
    """Neither who is ahead nor who has just come there out of the next lane."""
    car = {"id": "car", "approaches": ["adjacent" if comes else "ahead"]}
    into = {"id": "c", "participant": "car", "kind": "change_lane", "into": "ego"}
    functional = describe(
        "straight", 2, [EGO, car], [{"kind": "hard_braking", "by": ["ego"]}],
        more={"acts": [into]} if comes else {},
    )  # fmt: skip
    assert resolved(functional) == {(("ego",), ())}


@pytest.mark.parametrize(("acts", "sufferer"), [([], "car"), (["change_lane"], "ego")])
def test_who_changes_lanes_gets_away_from_one_who_stops(describe, acts, sufferer):
    van = {"id": "van", "kind": "van", "approaches": ["ahead"]}
    car = {"id": "car", "approaches": ["ahead"], "maneuvers": ["lane_change"]}
    order = {"participant": "van", "reference": "car", "approaches": ["ahead"]}
    done = [{"id": "c", "participant": "car", "kind": kind} for kind in acts]
    functional = describe(
        "straight", 2, [EGO, van, car], [{"kind": "stopping", "by": ["van"]}],
        more={"relations": [order], "acts": done},
    )  # fmt: skip
    assert resolved(functional) == {(("van",), (sufferer,))}


def test_nobody_named_who_brakes_is_whom_somebody_tailgates(describe):
    car = {"id": "car", "approaches": ["behind"]}
    hazards = [
        {"kind": "hard_braking", "to": ["car"]},
        {"kind": "tailgating", "by": ["car"], "to": ["ego"]},
    ]
    assert resolved(describe("straight", 2, [EGO, car], hazards)) == {(("ego",), ("car",))}


def test_who_fails_to_yield_to_nobody_named_does_so_to_whom_it_meets(describe):
    """An ego that does: of two others, the one whose way meets its way."""
    others = [
        {"id": "near", "entries": [1], "maneuvers": ["straight"]},
        {"id": "far", "entries": [2], "maneuvers": ["straight"]},
    ]
    ego = EGO | {"entries": [0], "maneuvers": ["straight"]}
    functional = describe(
        "four_way", 4, [ego, *others], [{"kind": "failure_to_yield", "by": ["ego"]}]
    )
    assert resolved(functional) == {(("ego",), ("near",))}


def test_a_thing_or_who_is_parked_hides(describe):
    van = {"id": "van", "kind": "van", "parked": True, "maneuvers": ["stay"]}
    child = {"id": "child", "kind": "pedestrian"}
    functional = describe("straight", 2, [EGO, van, child], [{"kind": "occlusion"}])
    assert resolved(functional) == {(("van",), ("ego",))}
    more = {"objects": [{"id": "hedge", "kind": "hedge", "hides": ["child"]}]}
    functional = describe("straight", 2, [EGO, child], [{"kind": "occlusion"}], more=more)
    assert resolved(functional) == {(("hedge",), ("ego",))}


@pytest.mark.parametrize("kind", HazardKind)
def test_of_every_kind_somebody_causes_and_somebody_else_suffers(describe, kind):
    people = [
        EGO,
        {"id": "car"},
        {"id": "bike", "kind": "bicycle", "maneuvers": ["cross"]},
        {"id": "child", "kind": "pedestrian"},
        {"id": "deer", "kind": "large_animal"},
        {"id": "van", "kind": "van", "parked": True, "maneuvers": ["stay"]},
    ]
    functional = describe("four_way", 4, people, [{"kind": kind.value}])
    for by, to in resolved(functional):
        assert by, kind
        assert to, kind
        assert not set(by) & set(to)


def test_a_cut_in_starts_beside_and_goes_to_the_other_side(describe):
    functional = describe(
        "straight", 2, [EGO, {"id": "car"}], [{"kind": "cut_in", "by": ["car"], "to": ["ego"]}],
        more={"acts": [{"id": "change", "participant": "car", "kind": "change_lane"}]},
    )  # fmt: skip
    listed = enumerate_scenarios(functional).scenarios
    found = set()
    for scenario in listed:
        car, act = scenario.assignment("car"), scenario.acts[0]
        found.add((car.beside_on, car.changes_to, act.side, act.into))
    assert found == {("left", "right", "right", "ego"), ("right", "left", "left", "ego")}


def test_the_side_that_an_act_says_is_kept(describe):
    act = {"id": "change", "participant": "car", "kind": "change_lane", "side": "left"}
    functional = describe(
        "straight", 2, [EGO, {"id": "car"}], [{"kind": "cut_in", "by": ["car"], "to": ["ego"]}],
        more={"acts": [act]},
    )  # fmt: skip
    cars = [s.assignment("car") for s in enumerate_scenarios(functional).scenarios]
    assert {(c.beside_on, c.changes_to) for c in cars} == {("right", "left")}


def test_who_leaves_the_lane_may_go_to_either_side(describe):
    car = {"id": "car", "approaches": ["ahead"]}
    act = {"id": "change", "participant": "car", "kind": "change_lane"}
    listed = enumerate_scenarios(describe("straight", 2, [EGO, car], more={"acts": [act]}))
    assert {(s.assignment("car").rank, s.acts[0].side) for s in listed.scenarios} == {
        (0, "left"),
        (0, "right"),
    }


@pytest.mark.parametrize("outcome", ["near_miss", "collision", "avoided"])
def test_an_outcome_is_between_two_whose_paths_meet(describe, outcome):
    functional = describe(
        "four_way", 4, [EGO, {"id": "car"}, {"id": "child", "kind": "pedestrian"}],
        more={"outcome": {"kind": outcome, "between": ["ego", "car"]}},
    )  # fmt: skip
    listed = enumerate_scenarios(functional).scenarios
    assert listed
    for scenario in listed:
        assert any({c.first, c.second} == {"ego", "car"} for c in scenario.conflicts)


def test_a_file_without_description_and_evidence_gives_the_same(describe):
    functional = describe(
        "four_way", 4, [EGO, {"id": "car"}], [{"kind": "failure_to_yield", "by": ["car"]}]
    )
    evidence = [
        {"field": "hazards.failure_to_yield.to", "source": "inferred", "reason": "the ego"},
        {"field": "junction.control", "source": "default", "reason": "not said"},
    ]
    told = FunctionalScenario.model_validate(
        functional.model_dump(mode="json") | {"evidence": evidence, "description": "no yield"}
    )
    bare = told.model_copy(update={"description": "", "evidence": ()})
    assert enumerate_scenarios(told).scenarios == enumerate_scenarios(bare).scenarios


def test_who_is_said_to_wait_for_one_who_crosses_is_whose_way_it_crosses(describe):
    people = [EGO, {"id": "lead", "approaches": ["ahead"]}]
    child = {"id": "child", "kind": "pedestrian", "maneuvers": ["cross"]}
    waits = {"id": "waits", "participant": "lead", "kind": "wait", "into": "child"}
    crossing = {"kind": "crossing_pedestrian", "by": ["child"]}
    said = describe("straight", 2, [*people, child], [crossing], more={"acts": [waits]})
    silent = describe("straight", 2, [*people, child], [crossing])
    for functional, sufferer in ((said, "lead"), (silent, "ego")):
        for scenario in enumerate_scenarios(functional).scenarios:
            assert scenario.hazards[0].to == (sufferer,)
