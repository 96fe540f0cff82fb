"""Vehicles that nothing ties to others are counted at once, not one by one."""

from __future__ import annotations

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from scegen.enumeration import count_scenarios, counting, enumerate_scenarios
from scegen.enumeration.capacity import Kind, Room, Slot, placements
from scegen.errors import InputError, NoScenarioError
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.vocabulary import ArmsMode, Reduction

WORDS = st.sets(st.sampled_from(["straight", "left", "right", "u_turn", "lane_change"]), max_size=2)
JUNCTIONS = st.sampled_from(
    [("t", 3), ("y", 3), ("four_way", 4), ("skewed", 4), ("multi_way", 5), ("multi_way", 6)]
)


@st.composite
def situations(draw):
    """A few cars, some of them limited to arms, tied by a hazard, or seen by the ego."""
    kind, arms = draw(JUNCTIONS)
    number = draw(st.integers(2, 5))
    cars = [
        {
            "id": f"car_{place}",
            "role": "other" if place else "ego",
            "kind": draw(st.sampled_from(["car", "car", "bus"])),
            "maneuvers": sorted(draw(WORDS)),
            "entries": sorted(draw(st.one_of(st.just(set()), st.sets(st.integers(0, arms - 1))))),
            "approaches": sorted(
                draw(st.sampled_from([(), (), ("left",), ("behind", "opposite")])) if place else ()
            ),
        }
        for place in range(number)
    ]
    hazards = draw(
        st.sampled_from([[], [], [{"kind": "tailgating", "by": ["car_1"], "to": ["car_0"]}]])
    )
    return FunctionalScenario.model_validate(
        {
            "description": "made for a test",
            "junction": {"kind": kind, "arms": arms},
            "participants": cars,
            "hazards": hazards,
        }
    )


@settings(max_examples=60)
@given(situations(), st.sampled_from(Reduction), st.sampled_from(ArmsMode))
def test_the_solver_counts_the_same_one_by_one(functional, reduction, arms):
    try:
        counted = count_scenarios(functional, reduction=reduction, arms=arms)
    except NoScenarioError:
        assume(False)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(counting, "unrelated_of", lambda _: frozenset())
        assert count_scenarios(functional, reduction=reduction, arms=arms) == counted


@settings(max_examples=20)
@given(situations(), st.sampled_from(Reduction), st.sampled_from(ArmsMode))
def test_listing_and_count_agree_and_class_sizes_add_up(functional, reduction, arms):
    try:
        counted = count_scenarios(functional, reduction=reduction, arms=arms)
    except NoScenarioError:
        assume(False)
    assume(counted.count < 3_000)
    listed = enumerate_scenarios(functional, reduction=reduction, arms=arms)
    assert len(listed.scenarios) == counted.count
    assert sum(s.class_size for s in listed.scenarios) == counted.total


@pytest.mark.parametrize("reduction", Reduction)
def test_twenty_cars_all_different_are_counted_at_once(describe, reduction):
    """Each with a speed of its own: the solver, with 10**15 ways, would never come back."""
    others = [{"id": f"car_{i}", "speed_mps": {"low": i, "high": i + 1}} for i in range(1, 20)]
    ego = {"id": "ego", "role": "ego", "maneuvers": ["left"]}
    functional = describe("multi_way", 6, [ego, *others])
    count = count_scenarios(functional, reduction=reduction).count
    assert count > (200 if reduction is Reduction.PATTERN else 10**20)


def test_more_fillings_than_can_be_told_apart_are_refused(monkeypatch):
    monkeypatch.setattr("scegen.enumeration.capacity.MAX_STATES", 10)
    kinds = [Kind(2, 1, tuple(Slot(place, (), 1 + place) for place in range(4)))] * 3
    with pytest.raises(InputError, match="ways to fill"):
        placements(kinds, Room((9,) * 4, ()))
