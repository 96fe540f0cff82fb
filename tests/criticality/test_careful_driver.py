"""The careful driver: reacts to what can be seen, in time, and brakes as UN R157 says."""

from math import pi

import numpy as np
import pytest
from criticality_geometry import line, through
from criticality_scenarios import participant, phase, scenario

from scegen.criticality.careful_driver import (
    DECELERATION_G,
    DELAY_S,
    JERK_MPS3,
    RISK_EVALUATION_S,
    Outcome,
    careful_driver_verdict,
)
from scegen.motion.model import Path
from scegen.scenario.bodies import BODIES
from scegen.scenario.concrete import AtTime, Travelled

SPEED = 12.0
EGO_WAY = line(0.0, 0.0, 0.0, 400.0)
FRONT_M = BODIES["car"].front_m
LATE_S = RISK_EVALUATION_S + DELAY_S
A_MPS2 = DECELERATION_G * 9.81


def standing(x, y, heading=0.0) -> Path:
    return Path(np.array([0.0]), np.array([x]), np.array([y]), np.array([heading]), ())


def stopping_m(speed, deceleration=A_MPS2):
    """Way from the onset of braking to standstill, by integration."""
    way, t, dt = 0.0, 0.0, 1e-4
    while speed > 0.0:
        t += dt
        speed -= min(deceleration, JERK_MPS3 * t) * dt
        way += max(speed, 0.0) * dt
    return way


def walker(start_s, *, x=60.0, y=-6.0, speed=1.5):
    """One who steps off at a time and crosses the ego's way at x."""
    program = [phase(AtTime(time_s=start_s), speed, 20.0)]
    return participant("walker", "pedestrian", 0.0, program), line(x, y, pi / 2, 12.0)


def judged(*people_and_ways, **more):
    people = [participant("ego", speed=SPEED), *(p for p, _ in people_and_ways)]
    paths = {"ego": EGO_WAY} | {p.id: way for p, way in people_and_ways}
    return careful_driver_verdict(scenario(*people), paths, **more)


def test_figures_of_the_regulation():
    assert pytest.approx(1.15) == LATE_S
    assert pytest.approx(7.593, abs=1e-3) == A_MPS2
    assert pytest.approx(12.65, abs=0.01) == JERK_MPS3


def test_an_obstacle_in_plain_sight_is_avoided_with_the_distance_of_the_model():
    front = 80.0
    wreck = participant("wreck", parked=True)
    found = judged((wreck, standing(front + BODIES["car"].rear_m, 0.0)))
    assert (found.outcome, found.contact_as_driven) == (Outcome.AVOIDABLE, ("wreck",))
    assert found.danger == "wreck"
    assert found.brakes_s == pytest.approx(found.perceived_s + LATE_S)
    rest = front - FRONT_M - found.brakes_s * SPEED - stopping_m(SPEED)
    assert found.distance_m == pytest.approx(rest, abs=0.15)
    # The driver may wait as long as the remaining distance lasts at full speed.
    assert found.spare_s == pytest.approx(rest / SPEED, abs=0.1)


def test_who_steps_out_too_late_is_hit_and_how_much_earlier_would_do():
    early, late = judged(walker(1.0, y=-5.0)), judged(walker(3.5, y=-2.4, speed=2.0))
    assert early.outcome is Outcome.AVOIDABLE
    assert (late.outcome, late.contact) == (Outcome.UNAVOIDABLE, ("walker",))
    assert late.perceived_s >= 3.5
    assert late.brakes_s == pytest.approx(late.perceived_s + LATE_S)
    assert late.spare_s is not None
    assert late.spare_s < 0.0
    assert late.distance_m == 0.0
    assert 0.0 < late.contact_speed_mps <= SPEED


def test_ice_makes_it_unavoidable():
    wreck = participant("wreck", parked=True), standing(60.0, 0.0)
    assert judged(wreck).outcome is Outcome.AVOIDABLE
    icy = judged(wreck, friction=0.15)
    # Looks further ahead, because stopping takes longer, but the way is too short.
    assert icy.perceived_s == 0.0
    assert icy.outcome is Outcome.UNAVOIDABLE


def test_who_is_hidden_is_perceived_later():
    seen = judged(walker(1.6, y=-8.0, speed=2.5))
    van = participant("van", "van", parked=True), standing(52.0, -5.8)
    hidden = judged(walker(1.6, y=-8.0, speed=2.5), van)
    assert hidden.danger == "walker"
    assert hidden.perceived_s > seen.perceived_s + 0.2


def test_wandering_in_the_next_lane_is_no_danger_and_cutting_in_is():
    def beside(shift):
        x = np.linspace(40.0, 340.0, 600)
        y = 3.5 - shift * np.clip((x - 100.0) / 60.0, 0.0, 1.0)
        way = through(np.column_stack((x, y)))
        return judged((participant("car", speed=8.0), way))

    assert beside(0.3).danger is None
    cutting = beside(3.5)
    assert cutting.danger == "car"
    begin_s = (100.0 - 40.0) / 8.0
    assert begin_s + 0.5 < cutting.perceived_s < begin_s + 1.0


def test_one_who_only_points_at_the_ego_in_a_bend_is_no_danger():
    """Straight on, it would hit the ego; its way bends off before."""
    angle = np.linspace(0.0, pi, 200)
    bend = np.column_stack((50.0 + 12.0 * np.sin(angle), 27.0 - 12.0 * (1 - np.cos(angle)) + 12.0))
    approach = np.column_stack((np.linspace(20.0, 50.0, 30, endpoint=False), np.full(30, 39.0)))
    way = through(np.vstack((approach, bend)))
    found = judged((participant("car", speed=8.0), way))
    assert found.danger is None
    assert (found.outcome, found.brakes_s, found.spare_s) == (Outcome.AVOIDABLE, None, None)


def test_a_follower_who_does_not_react_is_named_but_does_not_decide():
    wreck = participant("wreck", parked=True), standing(85.0, 0.0)
    slow = [phase(Travelled(participant="tail", distance_m=30.0), 0.0, 8.0)]
    tail = participant("tail", speed=SPEED, program=slow), line(-20.0, 0.0, 0.0, 60.0)
    found = judged(wreck, tail)
    assert found.outcome is Outcome.AVOIDABLE
    assert (found.contact, found.secondary) == ((), ())
    ram = participant("ram", speed=SPEED), line(-12.0, 0.0, 0.0, 300.0)
    people = [participant("ego", speed=SPEED), wreck[0], ram[0]]
    paths = {"ego": EGO_WAY, "wreck": wreck[1], "ram": ram[1]}
    rammed = careful_driver_verdict(scenario(*people, duration_s=10.0), paths)
    assert rammed.outcome is Outcome.AVOIDABLE
    assert rammed.secondary == ("ram",)


def test_one_who_runs_into_the_ego_from_behind_anyway_cannot_be_avoided():
    ram = participant("ram", speed=2 * SPEED), line(-40.0, 0.0, 0.0, 300.0)
    found = judged(ram)
    assert found.danger is None
    assert (found.outcome, found.contact) == (Outcome.UNAVOIDABLE, ("ram",))


def test_triggers_that_look_at_the_ego_are_evaluated_anew():
    """A second walker starts where the ego, which has stopped, never comes."""
    wreck = participant("wreck", parked=True), standing(80.0, 0.0)
    program = [phase(Travelled(participant="ego", distance_m=75.0), 3.0, 20.0)]
    second = participant("second", "pedestrian", 0.0, program), line(78.0, -1.6, pi / 2, 12.0)
    found = judged(wreck, second)
    assert "second" in found.contact_as_driven
    assert found.outcome is Outcome.AVOIDABLE


def test_who_brakes_already_does_not_brake_less():
    wreck = participant("wreck", parked=True), standing(48.0, 0.0)
    braking = [phase(AtTime(time_s=1.0), 0.0, 6.5)]
    people = [participant("ego", speed=SPEED, program=braking), wreck[0]]
    found = careful_driver_verdict(scenario(*people), {"ego": EGO_WAY, "wreck": wreck[1]})
    assert found.contact == ()


def test_twice_the_same():
    assert judged(walker(3.0)) == judged(walker(3.0))
