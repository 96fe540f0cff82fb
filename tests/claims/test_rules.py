"""Rules of the road: kept where nobody is said to break them, and missed where they are not."""

import pytest
from saying import made, missed, person, said

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.motion.rules.giving_way import must_give_way
from scegen.motion.rules.stopping import must_stop

STOPS = ["stop", "all_way_stop"]


def crossing(control, **fields):
    """The ego and a car from the left at a crossing."""
    people = person("ego", maneuvers=["straight"]), person("car", approaches=["left"])
    return said("four_way", *people, junction={"control": control, "lanes": [1] * 4}, **fields)


def laid(functional, index=0):
    """One of its scenarios as first laid, before any search."""
    return concretize(functional, enumerate_scenarios(functional).scenarios[index], seed=0)


def without_program(concrete, name):
    """The same where somebody keeps its speed."""
    people = [
        p.model_copy(update={"speed_program": ()}) if p.id == name else p
        for p in concrete.participants
    ]
    return concrete.model_copy(update={"participants": tuple(people)})


@pytest.mark.parametrize("control", STOPS)
@pytest.mark.parametrize("index", [0, 2])
def test_whoever_has_a_stop_sign_stands_at_its_line(control, index):
    functional = crossing(control)
    concrete = laid(functional, index)
    stopping = must_stop(functional, concrete.logical)
    assert stopping
    assert not {i for i in missed(functional, concrete) if i.startswith("rule.stop")}
    for name in stopping:
        assert f"rule.stop.{name}" in missed(functional, without_program(concrete, name))


@pytest.mark.parametrize("control", STOPS)
def test_the_danger_is_raised_with_everybody_stopping(control):
    raised = made(crossing(control))
    stops = [claim for claim in raised.proof.claims if claim.id.startswith("rule.stop")]
    assert stops
    assert all(claim.holds for claim in stops)
    assert raised.proof.in_band


def test_who_fails_to_yield_is_the_only_one_without_a_stop():
    hazard = {"kind": "failure_to_yield", "by": ["car"], "to": ["ego"]}
    functional = crossing("all_way_stop", hazards=[hazard])
    assert must_stop(functional, laid(functional).logical) == {"ego"}
    raised = made(functional)
    assert not raised.proof.missed
    assert "rule.stop.car" not in {claim.id for claim in raised.proof.claims}


def test_nobody_stops_for_a_sign_on_another_arm():
    functional = crossing("stop")
    for scenario in enumerate_scenarios(functional).scenarios:
        minor = {d.participant for d in scenario.drives if d.entry in {1, 3}}
        assert must_stop(functional, scenario) == minor


def yielding(control, **fields):
    """The ego on the main road, and a car that comes from its right at a crossing."""
    people = person("ego", maneuvers=["straight"]), person("car", approaches=["right"])
    return said("four_way", *people, junction={"control": control, "lanes": [1] * 4}, **fields)


@pytest.mark.parametrize("control", ["priority_to_right", "yield", "all_way_stop"])
def test_who_has_to_gives_way_as_laid_and_as_raised(control):
    functional = yielding(control)
    for index in range(len(enumerate_scenarios(functional).scenarios)):
        concrete = laid(functional, index)
        duties = must_give_way(functional, concrete.logical)
        ids = {f"rule.way.{d.yields}.{d.other}" for d in duties}
        assert not ids & missed(functional, concrete)
    raised = made(functional)
    assert raised.proof.in_band
    assert not raised.proof.missed


def test_who_comes_too_soon_takes_the_way():
    functional = yielding("priority_to_right")
    concrete = laid(functional)
    (duty,) = must_give_way(functional, concrete.logical)
    claim = f"rule.way.{duty.yields}.{duty.other}"
    late = concrete.participant(duty.yields)
    taken = set()
    for metres in (-30.0, -20.0, -10.0, 10.0, 20.0, 30.0):
        start = late.motion.start_m + metres
        moved = late.model_copy(
            update={"motion": late.motion.model_copy(update={"start_m": start})}
        )
        people = [moved if p is late else p for p in concrete.participants]
        other = concrete.model_copy(update={"participants": tuple(people)})
        taken.add(claim in missed(functional, other))
    assert taken == {True, False}


@pytest.mark.parametrize(
    "fields",
    [
        {"hazards": [{"kind": "failure_to_yield", "by": ["ego"], "to": ["car"]}]},
        {"outcome": {"kind": "collision", "between": ["ego", "car"]}},
        {"acts": [{"id": "a", "participant": "ego", "kind": "accelerate"}]},
        {
            "spacings": [
                {
                    "participant": "car",
                    "reference": "ego",
                    "measure": "gap_m",
                    "value": 30,
                    "at": "start",
                }
            ]
        },
    ],
)
def test_what_is_said_of_two_wins_over_right_of_way(fields):
    functional = yielding("priority_to_right", **fields)
    logical = enumerate_scenarios(functional).scenarios[0]
    assert must_give_way(functional, logical) == ()


def test_where_lights_are_off_they_show_nothing_and_the_right_goes_first():
    functional = crossing("signals_off")
    concrete = laid(functional)
    assert {d.rule for d in must_give_way(functional, concrete.logical)} == {
        d.rule for d in must_give_way(crossing("uncontrolled"), concrete.logical)
    }
    assert not missed(functional, concrete)
    dark = {"rule.light.ego", "rule.light.car"}
    working = concrete.signals.model_copy(update={"working": True})
    assert dark <= missed(functional, concrete.model_copy(update={"signals": working}))
    assert dark <= missed(functional, concrete.model_copy(update={"signals": None}))


def test_dark_lights_do_not_count_as_green():
    functional = crossing("signals")
    concrete = laid(functional)
    dark = concrete.signals.model_copy(update={"working": False})
    assert not missed(functional, concrete)
    assert missed(functional, concrete.model_copy(update={"signals": dark}))
