"""A guess about who suffers a danger gives way; what is stated does not."""

from __future__ import annotations

import pytest

from scegen.enumeration import enumerate_scenarios
from scegen.errors import NoScenarioError
from scegen.scenario.functional import Evidence, FunctionalScenario

EGO = {"id": "ego", "role": "ego", "maneuvers": ["straight"]}
ONCOMING = {"id": "truck", "kind": "truck", "approaches": ["opposite"], "maneuvers": ["straight"]}
WALKER = {"id": "child", "kind": "pedestrian", "maneuvers": ["cross"]}
LATE = {"kind": "delayed_braking", "by": ["truck"], "to": ["ego"]}


def guessed(functional: FunctionalScenario) -> FunctionalScenario:
    guess = Evidence(
        field="hazards.delayed_braking.to", source="inferred", reason="the ego is taken"
    )
    return functional.model_copy(update={"evidence": (guess,)})


def test_a_guess_gives_way(describe):
    functional = guessed(describe("straight", 2, [EGO, ONCOMING, WALKER], [LATE]))
    found = enumerate_scenarios(functional)
    assert found.scenarios
    assert found.functional.hazards[0].by == ("truck",)
    assert found.functional.hazards[0].to == ()
    told = [e.reason for e in found.functional.evidence if e.field == "hazards.delayed_braking.to"]
    assert told == ["that truck threatens ego was a guess, and no scenario has it so: left open"]
    assert found.notes[0].startswith("delayed_braking: that truck threatens ego was a guess")


def test_what_is_stated_does_not(describe):
    functional = describe("straight", 2, [EGO, ONCOMING, WALKER], [LATE])
    with pytest.raises(NoScenarioError, match=r"delayed_braking \(by truck; to ego\)"):
        enumerate_scenarios(functional)


def test_a_guess_that_fits_stays(describe):
    """One who overtakes is on the side of the oncoming truck: the guess holds."""
    ego = EGO | {"maneuvers": ["overtake"]}
    functional = guessed(describe("straight", 2, [ego, ONCOMING, WALKER], [LATE]))
    found = enumerate_scenarios(functional)
    assert found.functional.hazards[0].to == ("ego",)
    assert found.notes == ()


def test_other_contradictions_are_told_as_they_were(describe):
    """Giving up the guess does not help here: the refusal names it as it was said."""
    functional = guessed(
        describe(
            "four_way",
            4,
            [EGO | {"entries": [0]}, ONCOMING | {"entries": [1]}],
            [LATE],
        )
    )
    with pytest.raises(NoScenarioError) as refused:
        enumerate_scenarios(functional)
    assert "to not said" not in str(refused.value)


def test_a_guess_about_the_only_other_one_gives_way(describe):
    """One who turns left is overtaken from behind; nobody comes the other way."""
    turning = {"id": "ego", "role": "ego", "maneuvers": ["left"]}
    car = {"id": "car", "approaches": ["behind"], "maneuvers": ["overtake"]}
    left = {"kind": "unprotected_left_turn", "by": ["ego"], "to": ["car"]}
    functional = describe("four_way", 4, [turning, car], [left])
    with pytest.raises(NoScenarioError):
        enumerate_scenarios(functional)
    guess = Evidence(
        field="hazards.unprotected_left_turn.to", source="inferred", reason="the only other"
    )
    found = enumerate_scenarios(functional.model_copy(update={"evidence": (guess,)}))
    assert found.functional.hazards[0].to == ()
    again = enumerate_scenarios(found.functional)
    assert again.scenarios == found.scenarios


def test_straight_on_at_a_y_is_the_way_that_bends_least(describe):
    functional = describe("y", 3, [EGO])
    assert {d.turn.value for s in enumerate_scenarios(functional).scenarios for d in s.drives} == {
        "right"
    }
