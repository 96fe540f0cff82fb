"""What is presumed of who suffers a danger gives way; what is stated does not."""

from __future__ import annotations

import pytest

from scegen.enumeration import enumerate_scenarios
from scegen.errors import NoScenarioError
from scegen.scenario.functional import FunctionalScenario

EGO = {"id": "ego", "role": "ego", "maneuvers": ["straight"]}
ONCOMING = {"id": "truck", "kind": "truck", "approaches": ["opposite"], "maneuvers": ["straight"]}
WALKER = {"id": "child", "kind": "pedestrian", "maneuvers": ["cross"]}
LATE = {"kind": "delayed_braking", "by": ["truck"], "to": ["ego"]}
UNSAID = {"kind": "delayed_braking", "by": ["truck"]}


def test_what_is_presumed_gives_way(describe):
    found = enumerate_scenarios(describe("straight", 2, [EGO, ONCOMING, WALKER], [UNSAID]))
    assert found.scenarios
    assert found.functional.hazards[0].to == ()
    assert found.notes[0].startswith("delayed_braking: whom it concerns is not said")


def test_what_is_stated_does_not(describe):
    functional = describe("straight", 2, [EGO, ONCOMING, WALKER], [LATE])
    with pytest.raises(NoScenarioError, match=r"delayed_braking \(by truck; to ego\)"):
        enumerate_scenarios(functional)


def test_what_is_presumed_and_fits_stays(describe):
    """One who overtakes is on the side of the oncoming truck."""
    ego = EGO | {"maneuvers": ["overtake"]}
    found = enumerate_scenarios(describe("straight", 2, [ego, ONCOMING, WALKER], [UNSAID]))
    assert {s.hazards[0].to for s in found.scenarios} == {("ego",)}
    assert found.notes == ()


def test_other_contradictions_are_told_as_they_were(describe):
    """Nobody else being presumed does not help here: the refusal is about what is said."""
    functional = describe(
        "four_way", 4, [EGO | {"entries": [0]}, ONCOMING | {"entries": [1]}], [UNSAID]
    )
    with pytest.raises(NoScenarioError) as refused:
        enumerate_scenarios(functional)
    assert "truck comes from opposite" in str(refused.value)


def test_the_only_other_one_is_presumed_until_nothing_fits_it(describe):
    """One who turns left is overtaken from behind; nobody comes the other way."""
    turning = {"id": "ego", "role": "ego", "maneuvers": ["left"]}
    car = {"id": "car", "approaches": ["behind"], "maneuvers": ["overtake"]}
    left = {"kind": "unprotected_left_turn", "by": ["ego"]}
    named = describe("four_way", 4, [turning, car], [left | {"to": ["car"]}])
    with pytest.raises(NoScenarioError):
        enumerate_scenarios(named)
    found = enumerate_scenarios(describe("four_way", 4, [turning, car], [left]))
    assert found.functional.hazards[0].to == ()
    assert {s.hazards[0].to for s in found.scenarios} == {("car",)}


def test_straight_on_at_a_y_is_the_way_that_bends_least(describe):
    functional = describe("y", 3, [EGO])
    assert {d.turn.value for s in enumerate_scenarios(functional).scenarios for d in s.drives} == {
        "right"
    }


def test_who_waits_at_its_line_is_not_met_by_whom_it_does_not_touch():
    functional = FunctionalScenario.model_validate(
        {
            "description": "made for a test",
            "junction": {"kind": "four_way", "arms": 4},
            "participants": [
                {"id": "ego", "role": "ego", "maneuvers": ["stay"]},
                {"id": "truck", "kind": "truck", "approaches": ["left"], "maneuvers": ["straight"]},
            ],
            "outcome": {"kind": "avoided", "between": ["ego", "truck"]},
        }
    )
    assert enumerate_scenarios(functional).scenarios


@pytest.mark.parametrize(
    ("own", "theirs", "where"), [("right", "left", "right"), ("straight", "right", "opposite")]
)
def test_ways_that_are_told_and_do_not_meet_are_kept_where_nobody_touches(own, theirs, where):
    functional = FunctionalScenario.model_validate(
        {
            "description": "made for a test",
            "junction": {"kind": "four_way", "arms": 4},
            "participants": [
                {"id": "ego", "role": "ego", "maneuvers": [own]},
                {"id": "bus", "kind": "bus", "approaches": [where], "maneuvers": [theirs]},
            ],
            "outcome": {"kind": "avoided", "between": ["ego", "bus"]},
        }
    )
    assert enumerate_scenarios(functional).scenarios
