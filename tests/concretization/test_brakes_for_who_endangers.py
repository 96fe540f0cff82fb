"""Who brakes at a junction does so for the one that endangers it, where it meets that one."""

import pytest
from saying import KMH, missed
from told import first, told, who

from scegen.understanding import read

SENTENCES = [
    "At a crossroads a car from the right does not yield. The ego at 50 km/h brakes at 7 m/s².",
    "At a crossroads a car from the right does not yield to the ego, which goes straight on and "
    "brakes.",
    "A car runs the red light from the right at 50 km/h. The ego, 50 km/h, brakes just in time.",
    "A learner driver ahead stalls at the green light and does not move; the ego, 15 m behind it "
    "at 30 km/h, stops.",
]


@pytest.mark.parametrize("text", SENTENCES)
def test_it_holds_from_the_first(text):
    functional = read(text)
    assert functional.acts
    assert not missed(functional, first(functional))


def avoids(kind, ego_speed, other, hazard, *, control="uncontrolled", **lights):
    """The ego goes straight on and is endangered, and nobody touches anybody."""
    ego = who("ego", maneuvers=["straight"], speed=ego_speed * KMH) | {"light": lights.get("ego")}
    other |= {"light": lights.get("x")}
    outcome = {"kind": "avoided", "between": ["ego", "x"]}
    return told(kind, [ego, other], [(hazard, "x", "ego")], outcome=outcome, control=control)


LEFT, RIGHT, ON = ["left"], ["right"], ["straight"]
AVOIDED = {
    "turns in before it": avoids(
        "t", 70, who("x", "car", RIGHT, RIGHT), "failure_to_yield", control="yield"
    ),
    "turns across it": avoids("t", 50, who("x", "car", LEFT, LEFT), "failure_to_yield"),
    "comes across it": avoids(
        "four_way",
        50,
        who("x", "car", LEFT, ON, speed=60 * KMH),
        "red_light_running",
        control="signals",
        ego="green",
        x="red",
    ),
}


@pytest.mark.parametrize("name", AVOIDED)
def test_who_is_to_get_away_brakes_and_goes_on(name):
    functional = AVOIDED[name]
    concrete = first(functional)
    assert not missed(functional, concrete)
    before, *program = [phase.target_speed_mps for phase in concrete.ego.speed_program]
    assert before < program[-1] <= concrete.ego.speed_mps  # no faster than who it follows


def test_who_backs_out_of_a_bay_comes_from_beside_at_the_speed_that_is_said():
    text = "A car backs out of a parking space on the right at 6 km/h into the ego's path."
    functional = read(text)
    concrete = first(functional)
    assert concrete.participant("car_1").motion.reversal.side == "right"
    assert not missed(functional, concrete) & {"speed.car_1", "approach.car_1"}


def test_who_takes_anothers_way_does_not_brake_for_it_and_keeps_the_speed_that_is_said():
    text = (
        "At a junction with five arms a car from the right goes straight on at 50 km/h and does "
        "not yield to the ego, which turns left."
    )
    functional = read(text)
    car = next(p for p in first(functional).participants if p.id == "car_1")
    assert car.speed_mps == pytest.approx(50 * KMH, abs=1e-3)
    assert all(phase.target_speed_mps >= car.speed_mps - 1e-3 for phase in car.speed_program)
