"""Who waits for green sets off so long after it as is said."""

import pytest
from mutating import changed
from pydantic import ValidationError
from saying import missed
from told import first, raised, told, who

from scegen.understanding import read


def waits(name, delay, *approaches, maneuver="straight"):
    at_light = {"light": "waits", "green_delay_s": delay}
    return who(name, approaches=approaches, maneuvers=[maneuver]) | at_light


def meeting(*people):
    return told("four_way", people, control="signals")


@pytest.mark.parametrize("delay", [0.4, 1.8, 5.0])
def test_it_sets_off_so_long_after_green(delay):
    van = who("van", "van", ["right"], ["straight"])
    found = raised(meeting(waits("ego", delay), van))
    (claim,) = (c for c in found.proof.claims if c.id == "rule.green_delay.ego")
    assert claim.holds
    assert claim.measured == pytest.approx(delay, abs=0.1)


def test_two_set_off_each_in_its_own_time():
    functional = meeting(waits("ego", 0.5), waits("van", 2.5, "opposite"))
    concrete = first(functional)
    assert not {claim for claim in missed(functional, concrete) if "green_delay" in claim}


def test_a_light_that_changes_at_another_time_is_noticed():
    functional = meeting(waits("ego", 1.0), who("van", "van", ["right"], ["straight"]))
    concrete = first(functional)
    assert "rule.green_delay.ego" not in missed(functional, concrete)
    groups = tuple(
        group.model_copy(update={"green_from_s": group.green_from_s - 0.4})
        for group in concrete.signals.groups
    )
    plan = concrete.signals.model_copy(update={"groups": groups})
    sooner = concrete.model_copy(update={"signals": plan})
    assert "rule.green_delay.ego" in missed(functional, sooner)
    program = concrete.ego.speed_program
    never = changed(concrete, "ego", speed_program=program[:1])
    assert "rule.green_delay.ego" in missed(functional, never)


def test_only_who_waits_has_a_delay():
    with pytest.raises(ValidationError, match="light: waits"):
        meeting(who("ego") | {"light": "green", "green_delay_s": 1.0})


@pytest.mark.parametrize(
    ("text", "delays"),
    [
        (
            "The ego waits at the red light of a crossroads and sets off 0.8 s after the light "
            "turns green.",
            {"ego": 0.8},
        ),
        (
            "Half a second after the light has turned green, the ego sets off at a crossroads; a "
            "van from the left runs the red light.",
            {"ego": 0.5},
        ),
        (
            "The oncoming truck waits at the red light of a crossroads and turns left 3 s after "
            "its light has turned green; the ego goes straight on.",
            {"truck_1": 3.0},
        ),
        (
            "At a crossroads with lights a pedestrian starts across the road 1 s after the light "
            "has turned green for the cars.",
            {},
        ),
        ("The ego waits at the red light of a crossroads and sets off at green.", {}),
    ],
)
def test_the_delay_is_read(text, delays):
    people = read(text).participants
    assert {p.id: p.green_delay_s.middle for p in people if p.green_delay_s} == delays
