"""Order, limits, names, parameters, certificates, and input that is refused."""

from __future__ import annotations

import re
import subprocess
import sys
from math import comb

import pytest

from scegen.enumeration import (
    count_scenarios,
    enumerate_scenarios,
    iterate_scenarios,
    plain_crossing,
)
from scegen.errors import InfeasibleError, InputError, NoScenarioError
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalSet
from scegen.scenario.vocabulary import Maneuver, Reduction

EGO = {"id": "ego", "role": "ego"}
OPEN = ("four_way", 4, [EGO | {"maneuvers": ["left", "straight"]}, {"id": "a"}, {"id": "b"}])


def order(scenario):
    drives = scenario.drives
    return [d.entry for d in drives], [d.move for d in drives]


@pytest.mark.parametrize("reduction", [Reduction.NONE, Reduction.EXACT])
def test_sorted_by_entries_then_moves(describe, reduction):
    for functional in (describe(*OPEN), plain_crossing((0, 1, 2, 3, 0, 1), 4)):
        listed = enumerate_scenarios(functional, reduction=reduction).scenarios
        assert [s.index for s in listed] == list(range(len(listed)))
        assert [order(s) for s in listed] == sorted(order(s) for s in listed)


def test_patterns_are_sorted(describe):
    listed = enumerate_scenarios(describe(*OPEN), reduction=Reduction.PATTERN).scenarios
    assert [s.pattern for s in listed] == sorted({s.pattern for s in listed})


@pytest.mark.parametrize("reduction", Reduction)
def test_with_a_limit_a_selection_is_listed(describe, reduction):
    functional = describe(*OPEN)
    full = enumerate_scenarios(functional, reduction=reduction)
    number = len(full.scenarios) // 2
    listed = enumerate_scenarios(functional, reduction=reduction, limit=number)
    assert len({s.assignments for s in listed.scenarios}) == number
    assert not listed.certificate.complete
    assert listed.certificate.count == full.certificate.count == len(full.scenarios)
    assert f"Listed are {number:,} of {len(full.scenarios):,}" in listed.notes[-1]
    assert [order(s) for s in listed.scenarios] == sorted(order(s) for s in listed.scenarios)
    assert tuple(iterate_scenarios(functional, reduction=reduction)) == full.scenarios
    assert tuple(iterate_scenarios(functional, reduction=reduction, limit=4)) == full.scenarios[:4]
    assert enumerate_scenarios(functional, reduction=reduction, limit=10_000) == full


def test_a_selection_shows_every_way_and_every_pair_of_ways(describe):
    """Drawn by chance from 15 billion: of ten different cars, any two in all their ways."""
    cars = [EGO, *({"id": f"car_{i}", "speed_mps": i} for i in range(1, 10))]
    found = enumerate_scenarios(describe("four_way", 4, cars), limit=2_000)
    assert found.certificate.count > 10**10
    drives = [s.drives for s in found.scenarios]
    ways = [{(d.entry, d.move) for d in column} for column in zip(*drives, strict=True)]
    assert all(len(way) == 12 for way in ways)
    for one, other in ((0, 1), (3, 9)):
        pairs = {tuple((d.entry, d.move) for d in (row[one], row[other])) for row in drives}
        assert len(pairs) == 12 * 12


def test_ten_cars_with_everything_open_are_counted_by_burnside(describe):
    """The ego has three ways, up to turns; the others choose a multiset of nine among twelve."""
    cars = [EGO, *({"id": f"car_{i}"} for i in range(9))]
    counted = count_scenarios(describe("four_way", 4, cars))
    assert counted.total == 12**10
    assert counted.count == 3 * comb(12 + 9 - 1, 9)


def test_three_of_ten_turn_left_whoever_they_are(describe):
    names = ["ego", *(f"car_{i}" for i in range(9))]
    cars = [EGO, *({"id": name} for name in names[1:])]
    group = {"members": names, "number": 3, "maneuvers": ["left"]}
    functional = describe("four_way", 4, cars, more={"groups": [group]})
    counted = count_scenarios(functional)
    # Each has 4 ways to turn left and 8 others.
    assert counted.total == comb(10, 3) * 4**3 * 8**7
    ego_does, ego_does_not = comb(4 + 1, 2) * comb(8 + 6, 7), comb(4 + 2, 3) * comb(8 + 5, 6)
    assert counted.count == 1 * ego_does + 2 * ego_does_not
    for scenario in enumerate_scenarios(functional, limit=40).scenarios:
        assert sum(drive.turn is Maneuver.LEFT for drive in scenario.drives) == 3


def test_a_limit_must_list_something():
    with pytest.raises(InputError, match="limit"):
        enumerate_scenarios(plain_crossing(), limit=0)


def test_equal_input_gives_equal_bytes_in_another_process():
    program = (
        "from scegen.enumeration import *\n"
        "print(enumerate_scenarios(plain_crossing((0, 1, 2, 0), 4)).model_dump_json())"
    )
    runs = {
        subprocess.run(
            [sys.executable, "-c", program],
            capture_output=True,
            check=True,
            env={"PYTHONHASHSEED": s},
        ).stdout
        for s in ("1", "2")
    }
    assert len(runs) == 1
    assert LogicalSet.model_validate_json(runs.pop()).certificate.count == 3 * 9 * 3


def test_streams_what_is_too_much_to_hold():
    stream = iterate_scenarios(plain_crossing((0, 1, 2, 3, 4) * 2, 5), reduction=Reduction.NONE)
    first = next(stream)
    assert (first.index, first.pattern) == (0, (1,) * 10)
    stream.close()


def test_slugs(describe):
    every = [
        *enumerate_scenarios(describe(*OPEN)).scenarios,
        *enumerate_scenarios(plain_crossing((0, 1, 2, 3, 4) * 2, 5), limit=50).scenarios,
    ]
    assert all(re.fullmatch(r"[a-z0-9-]{1,40}", s.slug) for s in every)
    assert enumerate_scenarios(describe(*OPEN)).scenarios[0].slug == "0straight-0right-0right"
    ring = describe("roundabout", 4, [EGO | {"maneuvers": ["exit_3"]}], driving_side="left")
    assert enumerate_scenarios(ring).scenarios[0].slug == "0exit3"
    ten = next(iterate_scenarios(plain_crossing((0, 1, 2, 0, 1), 3)))
    assert ten.slug == "moves-1x5"


def parameters(functional, index=0):
    found = enumerate_scenarios(functional).scenarios[index].parameters
    return {p.name: (p.low, p.default, p.high) for p in found}


def test_speeds(describe):
    functional = describe(
        "four_way",
        4,
        [
            EGO,
            {"id": "fast"},
            {"id": "slow"},
            {"id": "said", "speed_mps": {"low": 3, "high": 5}},
            {"id": "bike", "kind": "bicycle"},
            {"id": "ped", "kind": "pedestrian"},
        ],
        [{"kind": "speeding", "by": ["fast"]}, {"kind": "slow_driving", "by": ["slow"]}],
        speed_limit_mps=10,
    )
    found = parameters(functional)
    assert found["ego.speed_mps"] == (6, 8, 10)
    assert found["fast.speed_mps"] == (11, 12.5, 15)
    assert found["slow.speed_mps"] == (2, 3.5, 5)
    assert found["said.speed_mps"] == (3, 4, 5)
    assert found["bike.speed_mps"] == (3, 5, 8)
    assert found["ped.speed_mps"] == (0.8, 1.4, 2.5)


@pytest.mark.parametrize(("kind", "limit"), [("four_way", 50 / 3.6), ("roundabout", 30 / 3.6)])
def test_usual_limits(describe, kind, limit):
    assert parameters(describe(kind, 4, [EGO]))["ego.speed_mps"][2] == pytest.approx(limit, 1e-3)


def test_offsets_for_those_who_meet_the_ego(describe):
    crossing = describe("four_way", 4, [
        EGO | {"entries": [0], "maneuvers": ["straight"]},
        {"id": "meets", "entries": [1], "maneuvers": ["straight"]},
        {"id": "passes", "entries": [2], "maneuvers": ["straight"]},
        {"id": "parked", "parked": True},
    ])  # fmt: skip
    found = parameters(crossing)
    assert found["meets.arrival_offset_s"] == (-2, 0, 2)
    assert "passes.arrival_offset_s" not in found
    assert not [name for name in found if name.startswith("parked")]


def test_offsets_on_the_egos_arm_follow_the_rank(describe):
    functional = describe("straight", 2, [
        EGO, {"id": "front", "approaches": ["ahead"]}, {"id": "tail", "approaches": ["behind"]},
    ])  # fmt: skip
    found = parameters(functional)
    assert found["front.arrival_offset_s"][2] < 0 < found["tail.arrival_offset_s"][0]


# --- refused ------------------------------------------------------------------------------


def cars(number, **all_of_them):
    return [EGO | all_of_them, *({"id": f"car_{i}"} | all_of_them for i in range(1, number))]


def test_too_many_at_one_arm(describe):
    with pytest.raises(InfeasibleError, match="20 vehicles enter at arm 2"):
        enumerate_scenarios(describe("four_way", 4, cars(20, entries=[2])))


def test_too_many_from_one_side(describe):
    left = [{"id": f"car_{i}", "approaches": ["left"]} for i in range(13)]
    with pytest.raises(NoScenarioError, match="at most 12 vehicles"):
        enumerate_scenarios(describe("four_way", 4, [EGO, *left]))


def test_too_many_altogether(describe):
    with pytest.raises(InfeasibleError, match="at most 24 participants"):
        enumerate_scenarios(describe("multi_way", 8, cars(25)))


def test_the_ego_must_drive(describe):
    with pytest.raises(InfeasibleError, match="ego must drive"):
        enumerate_scenarios(describe("four_way", 4, [EGO | {"parked": True}, {"id": "car"}]))


def test_order_in_a_circle(describe):
    functional = describe(
        "four_way",
        4,
        [EGO, {"id": "a", "approaches": ["behind"]}, {"id": "b", "approaches": ["ahead"]}],
        relations=[{"participant": "a", "reference": "b", "approaches": ["ahead"]}],
    )
    with pytest.raises(NoScenarioError) as caught:
        enumerate_scenarios(functional)
    for told in ("a comes from behind", "b comes from ahead", "a comes from ahead, seen from b"):
        assert told in caught.value.message


def test_words_that_cannot_be_used_are_noted(describe):
    functional = describe(
        "four_way",
        4,
        [EGO, {"id": "car"}, {"id": "ped", "kind": "pedestrian"}],
        relations=[{"participant": "car", "reference": "ped", "approaches": ["behind"]}],
    )
    notes = enumerate_scenarios(functional, limit=1).notes
    assert any("seen from ped" in note for note in notes)


# --- plain crossings -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arms", "kind"), [(2, "straight"), (3, "y"), (4, "four_way"), (7, "multi_way")]
)
def test_plain_crossing(arms, kind):
    functional = plain_crossing((0, 1, 1), arms)
    assert isinstance(functional, FunctionalScenario)
    assert functional.junction.kind == kind
    assert [sorted(p.entries) for p in functional.participants] == [[0], [1], [1]]


@pytest.mark.parametrize(
    ("entries", "arms"), [((0, 4), 4), ((-1,), 4), ((), 4), ((0,), 1), ((0,), 9)]
)
def test_plain_crossing_refuses(entries, arms):
    with pytest.raises(InputError):
        plain_crossing(entries, arms)


def test_on_a_motorway_nobody_crawls(describe):
    """Cruising traffic keeps near the limit; a truck no faster than its device lets it."""
    people = [EGO, {"id": "truck", "kind": "truck"}]
    functional = describe("straight", 2, people, speed_limit_mps=130 / 3.6)
    found = parameters(functional)
    assert found["ego.speed_mps"] == (28.889, 36.111, 36.111)
    assert found["truck.speed_mps"] == (20, 25, 25)


@pytest.mark.parametrize("reduction", list(Reduction))
def test_of_a_group_who_changes_lanes_is_no_equal_of_who_may_turn(reduction):
    people = [
        {"id": "ego", "kind": "car", "role": "ego", "maneuvers": ["lane_change"]},
        *({"id": name, "kind": "car"} for name in ("a", "b")),
    ]
    functional = FunctionalScenario.model_validate(
        {
            "description": "none of two turns left",
            "junction": {"kind": "y", "arms": 3},
            "participants": people,
            "groups": [{"members": ["ego", "a"], "number": 0, "maneuvers": ["left"]}],
        }
    )
    listed = enumerate_scenarios(functional, reduction=reduction)
    counted = count_scenarios(functional, reduction=reduction)
    assert len(listed.scenarios) == counted.count
    assert sum(s.class_size for s in listed.scenarios) == counted.total
