"""Many scenarios: shared parts stay valid, streams stay small, counts need no solver."""

from __future__ import annotations

import io
import sys
import tracemalloc
from itertools import islice

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scegen.cli.listing import stream_json
from scegen.enumeration import (
    count_scenarios,
    enumerate_scenarios,
    iterate_scenarios,
    open_listing,
    plain_crossing,
    programs,
    sharing,
)
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.vocabulary import ArmsMode, Reduction

RICH = {
    "description": "made for a test",
    "junction": {"kind": "four_way", "arms": 4, "control": "priority_to_right"},
    "participants": [
        {"id": "ego", "role": "ego", "maneuvers": ["left", "lane_change"]},
        {"id": "car_1", "approaches": ["ahead", "behind", "opposite"]},
        {"id": "bus", "kind": "bus", "maneuvers": ["stay", "right"]},
        {"id": "walker", "kind": "pedestrian"},
        {"id": "van", "kind": "van", "parked": True},
    ],
    "hazards": [{"kind": "obstacle", "by": ["van"], "to": ["ego"]}],
}


def validated_anew(scenario: LogicalScenario) -> LogicalScenario:
    return LogicalScenario.model_validate(scenario.model_dump(mode="json"))


@pytest.mark.parametrize("reduction", Reduction)
def test_every_kind_of_part_is_valid(reduction):
    functional = FunctionalScenario.model_validate(RICH)
    listed = enumerate_scenarios(functional, reduction=reduction).scenarios
    assert {len(s.assignments) for s in listed} == {5}
    for scenario in listed:
        assert validated_anew(scenario) == scenario
        assert scenario.model_copy(deep=True) == scenario


@settings(max_examples=25)
@given(st.integers(2, 5), st.lists(st.integers(0, 4), min_size=1, max_size=6), st.data())
def test_what_is_constructed_equals_what_is_validated(arms, entries, data):
    functional = plain_crossing([e % arms for e in entries], arms)
    reduction = data.draw(st.sampled_from(list(Reduction)))
    for scenario in islice(iterate_scenarios(functional, reduction=reduction), 60):
        again = validated_anew(scenario)
        assert again == scenario
        assert hash(again) == hash(scenario)
        assert again.model_dump_json() == scenario.model_dump_json()


def test_equal_parts_are_one_object():
    listed = enumerate_scenarios(plain_crossing((0, 1, 2, 3), 4)).scenarios
    for parts in ("assignments", "conflicts", "parameters"):
        every = [part for s in listed for part in getattr(s, parts)]
        assert len({id(p) for p in every}) == len(set(every)) < len(every) / 10


def test_forgetting_parts_changes_nothing(monkeypatch):
    functional = plain_crossing((0, 1, 2, 3), 4)
    kept = enumerate_scenarios(functional)
    monkeypatch.setattr(sharing, "MOST_PAIRS", 7)
    assert enumerate_scenarios(functional) == kept


def test_twenty_cars_at_six_arms_stream_in_constant_memory():
    functional = plain_crossing([i % 6 for i in range(20)], 6)
    stream = iterate_scenarios(functional, arms=ArmsMode.EQUAL)
    tracemalloc.start()
    try:
        held = []
        for _ in range(4):
            for scenario in islice(stream, 2_500):
                last = scenario
            held.append(tracemalloc.get_traced_memory()[0])
    finally:
        tracemalloc.stop()
        stream.close()
    assert last.index == 9_999
    assert held[-1] - held[1] < 2_000_000


def test_all_classes_of_ten_cars_are_written_in_constant_memory(monkeypatch):
    """20,008 scenarios as one JSON document of 100 MB, of which nothing is held."""
    functional = plain_crossing([i % 5 for i in range(10)], 5)
    listing = open_listing(functional, arms=ArmsMode.EQUAL)
    held: list[int] = []
    sink = _Sink(held)
    monkeypatch.setattr(sys, "stdout", sink)
    tracemalloc.start()
    try:
        stream_json(listing)
    finally:
        tracemalloc.stop()
    assert listing.listed == 20_008
    assert listing.certificate().looked_at == 4**10
    assert sink.written > 50_000_000
    quarter = len(held) // 4
    assert max(held[quarter:]) < 12_000_000
    assert held[-1] - held[quarter] < 4_000_000


class _Sink(io.StringIO):
    """Counts and forgets what is written, and notes the memory held now and then."""

    def __init__(self, held: list[int]) -> None:
        super().__init__()
        self.written, self._held, self._calls = 0, held, 0

    def write(self, text: str) -> int:
        self.written += len(text)
        self._calls += 1
        if self._calls % 200 == 0:
            self._held.append(tracemalloc.get_traced_memory()[0])
        return len(text)


def test_a_neutral_junction_is_counted_without_the_solver(monkeypatch):
    def refuse(*arguments):
        raise AssertionError("the solver was asked")

    functional = plain_crossing([i % 6 for i in range(20)], 6)
    counted = count_scenarios(functional, arms=ArmsMode.EQUAL)
    monkeypatch.setattr(programs, "Control", refuse)
    assert count_scenarios(functional, arms=ArmsMode.EQUAL) == counted
    assert counted.total == 5**20
    # Arms 0 and 1 hold four cars, all others three: no rotation, C(8,4)^2 * C(7,3)^4 multisets.
    assert counted.count == 70**2 * 35**4
