"""Samples, covers and coverage, against plain definitions."""

from __future__ import annotations

from itertools import combinations

import pytest

from scegen.enumeration import enumerate_scenarios, plain_crossing
from scegen.enumeration.choosing import covering
from scegen.enumeration.choosing.coverage import Meeting, coverage, meetings
from scegen.enumeration.choosing.covering import smallest_cover
from scegen.enumeration.choosing.ranking import richest_first
from scegen.enumeration.choosing.sampling import distance, diverse_sample
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.vocabulary import Maneuver

CARS = plain_crossing((0, 1, 2, 3), 4)
MIXED = FunctionalScenario.model_validate(
    {
        "description": "made for a test",
        "junction": {"kind": "t", "arms": 3, "control": "yield"},
        "participants": [
            {"id": "ego", "role": "ego", "entries": [0]},
            {"id": "bus", "kind": "bus", "entries": [0, 1]},
            {"id": "walker", "kind": "pedestrian"},
            {"id": "van", "kind": "van", "parked": True},
        ],
        "hazards": [{"kind": "obstacle", "by": ["van"], "to": ["ego"]}],
    }
)
BOTH = pytest.mark.parametrize("functional", [CARS, MIXED], ids=["cars", "mixed"])


@BOTH
def test_a_distance_is_one(functional):
    few = enumerate_scenarios(functional).scenarios[:6]
    for first, second in combinations(few, 2):
        assert 0 < distance(first, second, functional) <= 2
        assert distance(first, second, functional) == distance(second, first, functional)
    for a, b, c in combinations(few, 3):
        across = distance(a, b, functional) + distance(b, c, functional)
        assert distance(a, c, functional) <= across + 1e-9


def test_the_distance_as_documented():
    """One of four drives differently; of six pairs, those count whose meeting differs."""
    first, second = enumerate_scenarios(CARS).scenarios[:2]
    moved = [a != b for a, b in zip(first.assignments, second.assignments, strict=True)]
    met = [{(c.first, c.second, c.kind, c.yields) for c in s.conflicts} for s in (first, second)]
    differ = {(one, two) for one, two, *_ in met[0] ^ met[1]}
    assert distance(first, second, CARS) == pytest.approx(sum(moved) / 4 + len(differ) / 6)


@BOTH
def test_a_sample_is_greedy_max_min(functional):
    every = list(enumerate_scenarios(functional).scenarios)
    sample = diverse_sample(every, functional, 5)
    assert sample[0] == min(every, key=lambda s: richest_first(s, functional))
    for size in range(1, 5):
        nearest = {
            s.index: min(distance(s, chosen, functional) for chosen in sample[:size])
            for s in every
            if s not in sample[:size]
        }
        assert nearest[sample[size].index] == pytest.approx(max(nearest.values()))
    assert len(set(sample)) == 5
    assert diverse_sample(every, functional, 10_000) == tuple(every)


@BOTH
def test_a_cover_covers_and_nothing_smaller_does(functional):
    every = enumerate_scenarios(functional).scenarios
    cover = smallest_cover(every, functional)
    assert cover.proved
    assert not coverage(functional, every, cover.scenarios).missing
    met = [meetings(functional, s) for s in every]
    wanted = frozenset().union(*met)
    size = len(cover.scenarios) - 1
    assert not any(wanted <= frozenset().union(*fewer) for fewer in combinations(met, size))


def test_a_search_cut_short_covers_but_claims_no_proof(monkeypatch):
    every = enumerate_scenarios(plain_crossing((0, 1, 2, 3, 0, 1), 4)).scenarios
    monkeypatch.setattr(covering, "MOST_CONFLICTS", 3)
    cover = smallest_cover(every, plain_crossing((0, 1, 2, 3, 0, 1), 4))
    assert not cover.proved
    functional = plain_crossing((0, 1, 2, 3, 0, 1), 4)
    assert not coverage(functional, every, cover.scenarios).missing


def test_nothing_that_meets_needs_no_cover():
    functional = plain_crossing((0,), 4)
    cover = smallest_cover(enumerate_scenarios(functional).scenarios, functional)
    assert (cover.scenarios, cover.proved) == ((), True)


def test_meetings_are_told_without_arms():
    """The same left turn across an oncoming car, from each of the four arms."""
    told = set()
    for entry in range(4):
        functional = plain_crossing((entry, (entry + 2) % 4), 4)
        for scenario in enumerate_scenarios(functional).scenarios:
            if {d.turn.value for d in scenario.drives} == {"left", "straight"}:
                told |= meetings(functional, scenario)
    assert told == {Meeting("left", "straight", "opposite", "crossing", "first")}


def test_coverage_counts_scenarios_and_names_what_is_missing():
    every = enumerate_scenarios(CARS).scenarios
    reached = coverage(CARS, every, every[:5])
    for meeting, number in reached.possible.items():
        holding = [s for s in every if meeting in meetings(CARS, s)]
        assert number == len(holding)
        assert reached.chosen[meeting] == len([s for s in holding if s.index < 5])
        assert (meeting in reached.missing) is (reached.chosen[meeting] == 0)
    assert reached.missing


def test_who_is_met_keeps_its_course_where_no_turn_is_said():
    functional = FunctionalScenario.model_validate(
        {
            "description": "made for a test",
            "junction": {"kind": "t", "arms": 3},
            "participants": [
                {"id": "ego", "role": "ego", "entries": [2], "maneuvers": ["left"]},
                {"id": "bus", "kind": "bus", "approaches": ["right"]},
            ],
        }
    )
    every = enumerate_scenarios(functional).scenarios
    turns = {d.turn for s in every for d in s.drives if d.participant == "bus"}
    assert turns == {Maneuver.STRAIGHT, Maneuver.LEFT}
    first = min(every, key=lambda s: richest_first(s, functional))
    assert Maneuver.STRAIGHT in {d.turn for d in first.drives if d.participant == "bus"}


def test_an_ego_of_which_no_turn_is_said_keeps_its_course():
    functional = FunctionalScenario.model_validate(
        {
            "description": "made for a test",
            "junction": {"kind": "t", "arms": 3},
            "participants": [
                {"id": "ego", "role": "ego", "entries": [0, 1]},
                {"id": "bus", "kind": "bus", "approaches": ["left"], "maneuvers": ["left"]},
            ],
        }
    )
    every = enumerate_scenarios(functional).scenarios
    first = min(every, key=lambda s: richest_first(s, functional))
    assert {d.turn for d in first.drives if d.participant == "ego"} == {Maneuver.STRAIGHT}
    assert any(
        d.turn is not Maneuver.STRAIGHT for s in every for d in s.drives if d.participant == "ego"
    )
