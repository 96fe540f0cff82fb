from __future__ import annotations

import numpy as np
import pytest
from reference_simulator import simulate

from scegen.concretization import concretize
from scegen.motion.model import Path
from scegen.scenario.concrete import (
    ArrivalBelow,
    AtTime,
    ConcreteScenario,
    DistanceBelow,
    SpeedPhase,
    StoodStill,
    Travelled,
)

DT = 0.05


def straight(length=200.0, y=0.0, x0=0.0, heading=0.0):
    direction = np.cos(heading)
    return Path(
        np.array([0.0, length]),
        np.array([x0, x0 + direction * length]),
        np.array([y, y]),
        np.array([heading, heading]),
        (),
    )


def scenario(cases, programs, speeds=(10.0, 10.0), duration=10.0) -> ConcreteScenario:
    base = concretize(*cases["left_hand"])
    people = tuple(
        p.model_copy(update={"speed_mps": v, "speed_program": tuple(program)})
        for p, v, program in zip(base.participants, speeds, programs, strict=True)
    )
    return base.model_copy(update={"participants": people, "duration_s": duration})


def run(cases, program, other=(), duration=10.0, paths=None, **more):
    concrete = scenario(cases, (program, other), duration=duration, **more)
    return simulate(concrete, paths or {"ego": straight(), "car_1": straight(y=50)}, dt_s=DT)


def test_steady_speed_advances_by_speed_times_time(cases):
    trace = run(cases, [])["ego"]
    np.testing.assert_allclose(trace.s_m, 10.0 * trace.time_s, atol=1e-9)
    np.testing.assert_allclose(trace.x_m, trace.s_m, atol=1e-9)
    assert len(trace.time_s) == 201


def test_an_action_changes_the_state_one_step_after_its_condition(cases):
    phase = SpeedPhase(trigger=AtTime(time_s=1.0), target_speed_mps=4.0, rate_mps2=2.0)
    trace = run(cases, [phase])["ego"]
    fired = round(1.0 / DT)
    assert trace.speed_mps[fired] == 10.0
    assert trace.speed_mps[fired + 1] == pytest.approx(10.0 - 2.0 * DT)
    assert trace.speed_mps[-1] == 4.0
    moved = np.diff(trace.s_m)
    np.testing.assert_allclose(moved, trace.speed_mps[1:] * DT, atol=1e-9)


def test_travelled_looks_at_the_one_named(cases):
    phase = SpeedPhase(
        trigger=Travelled(participant="car_1", distance_m=20.0), target_speed_mps=0, rate_mps2=5
    )
    trace = run(cases, [phase], speeds=(10.0, 5.0))["ego"]
    assert trace.speed_mps[round(4.0 / DT)] == 10.0
    assert trace.speed_mps[round(4.0 / DT) + 1] < 10.0


def test_distance_is_that_of_the_reference_points(cases):
    paths = {"ego": straight(), "car_1": straight(x0=100.0, heading=np.pi, y=30.0)}
    phase = SpeedPhase(
        trigger=DistanceBelow(participant="car_1", distance_m=50.0),
        target_speed_mps=0,
        rate_mps2=5,
    )
    trace = run(cases, [phase], paths=paths)["ego"]
    # 100 - 20 t < 40 where sqrt(40^2 + 30^2) = 50
    first = int(np.argmax(trace.speed_mps < 10.0))
    assert trace.time_s[first] == pytest.approx(3.0 + 2 * DT, abs=DT + 1e-9)


def test_arrival_is_straight_distance_over_speed(cases):
    phase = SpeedPhase(
        trigger=ArrivalBelow(participant="car_1", place_m=100.0, time_s=4.0),
        target_speed_mps=0,
        rate_mps2=5,
    )
    trace = run(cases, [phase], speeds=(10.0, 20.0))["ego"]
    first = int(np.argmax(trace.speed_mps < 10.0))
    # 100 - 20 t < 4 * 20 from t = 1 s on; the step that reaches it exactly does not count.
    assert trace.time_s[first] == pytest.approx(1.0 + 2 * DT)


def test_who_stands_or_has_passed_never_arrives(cases):
    trigger = ArrivalBelow(participant="car_1", place_m=0.0, time_s=100.0)
    phase = SpeedPhase(trigger=trigger, target_speed_mps=0, rate_mps2=5)
    assert run(cases, [phase])["ego"].speed_mps.min() == 10.0
    ahead = phase.model_copy(update={"trigger": trigger.model_copy(update={"place_m": 50.0})})
    assert run(cases, [ahead], speeds=(10.0, 0.0))["ego"].speed_mps.min() == 10.0


def test_standing_counts_from_coming_to_rest_and_anew_after_every_move(cases):
    stop = SpeedPhase(trigger=AtTime(time_s=1.0), target_speed_mps=0, rate_mps2=10)
    go = SpeedPhase(
        trigger=StoodStill(participant="ego", duration_s=2.0), target_speed_mps=5, rate_mps2=10
    )
    trace = run(cases, [stop, go, stop, go])["ego"]
    rests = np.flatnonzero(trace.speed_mps == 0.0)
    assert trace.time_s[rests[0]] == pytest.approx(2.0)
    # It stands from 2.0 s to 4.0 s; the next stop is under way a step after it goes again.
    moves = rests[0] + int(np.argmax(trace.speed_mps[rests[0] :] > 0))
    assert trace.time_s[moves] == pytest.approx(4.0 + DT)
    again = moves + int(np.argmax(trace.speed_mps[moves:] == 0.0))
    third = again + int(np.argmax(trace.speed_mps[again:] > 0))
    assert trace.time_s[third] - trace.time_s[again] == pytest.approx(2.0 + DT)


def test_phases_fire_in_order_and_one_per_step(cases):
    late = SpeedPhase(trigger=AtTime(time_s=5.0), target_speed_mps=5.0, rate_mps2=20)
    early = SpeedPhase(trigger=AtTime(time_s=0.0), target_speed_mps=12.0, rate_mps2=20)
    trace = run(cases, [late, early])["ego"]
    assert trace.speed_mps[round(4.9 / DT)] == 10.0
    assert trace.speed_mps[round(5.0 / DT) + 1] == 9.0
    assert trace.speed_mps[round(5.0 / DT) + 2] == 10.0
    assert trace.speed_mps[-1] == 12.0


def test_the_end_of_the_path_is_the_end_of_the_drive(cases):
    again = SpeedPhase(trigger=AtTime(time_s=7.0), target_speed_mps=9.0, rate_mps2=3)
    paths = {"ego": straight(42.0), "car_1": straight(y=50)}
    trace = run(cases, [again], paths=paths)["ego"]
    assert trace.s_m[-1] == 42.0
    assert trace.speed_mps[-1] == 0.0
    assert (trace.s_m <= 42.0).all()
