"""Lanes and sides, who is in the ring already, and people who stand or walk along the road."""

from __future__ import annotations

import pytest

from scegen.enumeration import enumerate_scenarios
from scegen.errors import NoScenarioError
from scegen.scenario.logical import ConflictKind, Standing, Walking

EGO = {"id": "ego", "role": "ego"}
WALKER = {"id": "walker", "kind": "pedestrian"}


def assignments(functional, name):
    return [s.assignment(name) for s in enumerate_scenarios(functional).scenarios]


@pytest.mark.parametrize(("side", "lane"), [("left", 1), ("right", 3)])
def test_who_is_beside_the_middle_lane(describe, side, lane):
    car = {"id": "car", "approaches": ["adjacent", side]}
    functional = describe("straight", 2, [EGO | {"lanes": [2]}, car], lanes=[3, 3])
    found = assignments(functional, "car")
    assert {(c.beside, c.beside_on, c.lane, c.rank) for c in found} == {("ego", side, lane, 0)}


def test_two_in_line_beside_one(describe):
    """Both are in the lane beside it, one behind the other: neither is level with the other."""
    beside = {"approaches": ["adjacent", "right"]}
    people = [EGO | {"lanes": [1]}, {"id": "last"} | beside, {"id": "first"} | beside]
    line = {"participant": "last", "reference": "first", "approaches": ["behind"]}
    functional = describe("straight", 2, people, relations=[line], lanes=[2, 2])
    (scenario,) = enumerate_scenarios(functional).scenarios
    last, first = scenario.assignment("last"), scenario.assignment("first")
    assert (last.beside, last.lane) == (first.beside, first.lane) == ("ego", 2)
    assert first.rank < last.rank


def test_beside_where_there_is_no_lane(describe):
    car = {"id": "car", "approaches": ["adjacent", "right"]}
    functional = describe("straight", 2, [EGO | {"lanes": [2]}, car], lanes=[2, 2])
    with pytest.raises(NoScenarioError, match=r"ego is in lane 2.*adjacent"):
        enumerate_scenarios(functional)


def test_ahead_is_in_the_same_lane(describe):
    car = {"id": "car", "approaches": ["ahead"]}
    functional = describe("straight", 2, [EGO | {"lanes": [1]}, car], lanes=[2, 2])
    assert {(c.lane, c.rank) for c in assignments(functional, "car")} == {(1, 0)}


@pytest.mark.parametrize("first", ["fast", "slow"])
def test_who_overtakes_has_somebody_ahead(describe, first):
    oncoming = {"approaches": ["opposite"]}
    fast = {"id": "fast", "maneuvers": ["overtake"]} | oncoming
    people = sorted([fast, {"id": "slow"} | oncoming], key=lambda p: p["id"] != first)
    (scenario,) = enumerate_scenarios(describe("straight", 2, [EGO, *people])).scenarios
    assert scenario.assignment("slow").rank < scenario.assignment("fast").rank


def test_from_the_left_on_an_open_road_is_from_the_lane_there(describe):
    car = {"id": "car", "approaches": ["left"]}
    found = assignments(describe("straight", 2, [EGO, car]), "car")
    assert {(c.beside, c.beside_on) for c in found} == {("ego", "left")}


@pytest.mark.parametrize(
    ("kind", "more", "in_lane"),
    [
        ("collision", {}, True),
        ("near_miss", {}, False),
        ("collision", {"hazards": [{"kind": "swerving", "by": ["ego"], "to": ["van"]}]}, False),
        ("collision", {"acts": [{"id": "a", "participant": "ego", "kind": "swerve"}]}, False),
    ],
)
def test_a_parked_one_that_is_run_into_stands_in_the_lane(describe, kind, more, in_lane):
    van = {"id": "van", "parked": True, "maneuvers": ["stay"]}
    outcome = {"kind": kind, "between": ["ego", "van"]}
    functional = describe(
        "straight", 2, [EGO, van], more.get("hazards", ()), more={**more, "outcome": outcome}
    )
    assert {v.in_lane for v in assignments(functional, "van")} == {in_lane}


def test_circulating(describe):
    functional = describe("roundabout", 4, [EGO, {"id": "car", "circulating": True}])
    assert all(c.circulating for c in assignments(functional, "car"))
    assert not any(e.circulating for e in assignments(functional, "ego"))


def test_one_who_stands_in_the_lane_is_met_from_behind_alone(describe):
    car = {"id": "car", "maneuvers": ["stay"]}
    for scenario in enumerate_scenarios(describe("four_way", 4, [EGO, car])).scenarios:
        ego, stands = scenario.drives
        kinds = [c.kind for c in scenario.conflicts]
        expected = ConflictKind.FOLLOWING if ego.exit == stands.exit else ConflictKind.DIVERGING
        assert kinds == ([expected] if ego.entry == stands.entry else [])


def test_a_pedestrian_who_stands_ahead_is_in_the_egos_lane(describe):
    walker = WALKER | {"approaches": ["ahead"], "maneuvers": ["stay"]}
    for scenario in enumerate_scenarios(describe("straight", 2, [EGO, walker])).scenarios:
        ego, stands = scenario.assignments
        assert isinstance(stands, Standing)
        assert stands.in_lane
        assert (stands.arm, stands.rank, ego.rank) == (ego.entry, 0, 1)
        assert [c.kind for c in scenario.conflicts] == [ConflictKind.FOLLOWING]


def test_a_pedestrian_who_walks_ahead_goes_the_same_way(describe):
    walker = WALKER | {"approaches": ["ahead"], "maneuvers": ["straight"]}
    hit = {"outcome": {"kind": "collision", "between": ["ego", "walker"]}}
    places = set()
    for scenario in enumerate_scenarios(describe("straight", 2, [EGO, walker])).scenarios:
        ego, walks = scenario.assignments
        assert isinstance(walks, Walking)
        assert (walks.arm, walks.side, walks.heading) == (ego.entry, "right", "inward")
        places.add(walks.in_lane)
    assert places == {True, False}
    struck = describe("straight", 2, [EGO, walker], more=hit)
    assert {w.in_lane for w in assignments(struck, "walker")} == {True}


def test_one_who_comes_towards_the_ego_walks_outward(describe):
    walker = WALKER | {"approaches": ["opposite"], "maneuvers": ["straight"]}
    found = assignments(describe("straight", 2, [EGO, walker]), "walker")
    assert {w.heading for w in found} == {"outward"}


def test_who_stands_anywhere_stands_where_the_ego_goes(describe):
    walker = WALKER | {"maneuvers": ["stay"]}
    for scenario in enumerate_scenarios(describe("four_way", 4, [EGO, walker])).scenarios:
        ego, stands = scenario.assignments
        assert (stands.arm, stands.side) in {(ego.entry, "right"), (ego.exit, "left")}


def test_of_two_ahead_the_one_farther_off_is_said_by_its_gap(describe):
    walker = WALKER | {"approaches": ["ahead"], "maneuvers": ["stay"]}
    bus = {"id": "bus", "kind": "bus", "approaches": ["ahead"], "maneuvers": ["stay"]}

    def ranks(walker_m, bus_m):
        gaps = [
            {"participant": name, "reference": "ego", "measure": "gap_m", "value": value}
            for name, value in (("walker", walker_m), ("bus", bus_m))
        ]
        functional = describe("straight", 2, [EGO, walker, bus], more={"spacings": gaps})
        scenario = enumerate_scenarios(functional).scenarios[0]
        return [scenario.assignment(name).rank for name in ("walker", "bus", "ego")]

    assert ranks(40, 60) == [1, 0, 2]
    assert ranks(60, 40) == [0, 1, 2]


def test_what_is_said_of_acts_becomes_parameters(describe):
    functional = describe(
        "straight", 2, [EGO, {"id": "car", "approaches": ["ahead"]}],
        more={
            "acts": [
                {"id": "brake_1", "participant": "car", "kind": "brake",
                 "rate_mps2": {"low": 4, "high": 6}, "target_speed_mps": 5,
                 "when": {"type": "measure", "measure": "gap_m", "participant": "ego",
                          "reference": "car", "value": 20}},
            ],
            "spacings": [{"participant": "ego", "reference": "car", "measure": "headway_s",
                          "value": 1.5, "at": "brake_1"}],
            "outcome": {"kind": "collision", "impact_percent": 25},
        },
    )  # fmt: skip
    found = {
        p.name: (p.low, p.default, p.high, p.reason)
        for p in enumerate_scenarios(functional).scenarios[0].parameters
    }
    assert found["brake_1.rate_mps2"] == (4, 5, 6, "stated")
    assert found["brake_1.target_speed_mps"] == (5, 5, 5, "stated")
    assert found["brake_1.when.gap_m"] == (20, 20, 20, "stated")
    assert found["spacing_0.headway_s"] == (1.5, 1.5, 1.5, "stated")
    assert found["outcome.impact_percent"] == (25, 25, 25, "stated")


@pytest.mark.parametrize("side", ["ahead", "behind"])
@pytest.mark.parametrize("listed", [("near", "far"), ("far", "near")])
@pytest.mark.parametrize("measure", ["gap_m", "headway_s"])
def test_who_is_farther_from_one_is_beyond_who_is_nearer(describe, side, listed, measure):
    people = [EGO, *({"id": name, "approaches": [side]} for name in listed)]
    far = {"near": {"low": 2, "high": 2}, "far": {"low": 5, "high": 5}}
    spacings = [
        {"participant": name, "reference": "ego", "measure": measure, "value": far[name]}
        for name in listed
    ]
    functional = describe("straight", 2, people, more={"spacings": spacings})
    (scenario,) = enumerate_scenarios(functional).scenarios
    ranks = [scenario.assignment(name).rank for name in ("far", "near", "ego")]
    assert ranks == (sorted(ranks) if side == "ahead" else sorted(ranks, reverse=True))
