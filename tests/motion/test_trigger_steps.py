"""Triggers moved clear of ties change nothing that is played, and leave no tie."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from scegen.concretization import concretize
from scegen.motion import simulate
from scegen.motion import simulate as play
from scegen.motion.model import Path
from scegen.motion.trigger_steps import STEP_S, just_before_step_s, put_between_steps
from scegen.scenario.concrete import (
    ArrivalBelow,
    AtTime,
    DistanceBelow,
    SpeedPhase,
    StoodStill,
    Travelled,
)

SPEED = 10.0


def way(y, length=400.0):
    return Path(np.array([0.0, length]), np.array([0.0, length]), np.array([y, y]), np.zeros(2), ())


PATHS = {"ego": way(0.0), "car_1": way(30.0)}


def scenario(cases, program):
    base = concretize(*cases["left_hand"])
    people = tuple(
        p.model_copy(update={"speed_mps": SPEED, "speed_program": tuple(own)})
        for p, own in zip(base.participants, (program, ()), strict=True)
    )
    return base.model_copy(update={"participants": people, "duration_s": 20.0})


def phase(trigger, speed=5.0):
    return SpeedPhase(trigger=trigger, target_speed_mps=speed, rate_mps2=2.5)


numbers = st.integers(1, 1500).map(lambda n: n / 100)
triggers = st.one_of(
    st.builds(AtTime, time_s=numbers),
    st.builds(Travelled, participant=st.sampled_from(["ego", "car_1"]), distance_m=numbers),
    st.builds(DistanceBelow, participant=st.just("car_1"), distance_m=st.floats(25, 60)),
    st.builds(
        ArrivalBelow,
        participant=st.sampled_from(["ego", "car_1"]),
        place_m=st.integers(50, 150).map(float),
        time_s=numbers,
    ),
    st.builds(StoodStill, participant=st.just("ego"), duration_s=numbers),
)


@pytest.fixture(scope="module")
def base(cases):
    return scenario(cases, ())


@settings(max_examples=60)
@example(program=[phase(ArrivalBelow(participant="ego", place_m=111.0, time_s=5.65), 0.0)])
@example(
    program=[
        phase(DistanceBelow(participant="car_1", distance_m=31.0)),
        phase(ArrivalBelow(participant="ego", place_m=77.0, time_s=7.73), 0.0),
    ]
)
@example(
    program=[
        phase(ArrivalBelow(participant="ego", place_m=50.0, time_s=5.01)),
        phase(ArrivalBelow(participant="ego", place_m=77.0, time_s=7.73)),
        phase(ArrivalBelow(participant="ego", place_m=50.0, time_s=2.28), 0.0),
    ]
)
@given(program=st.lists(st.builds(phase, triggers, st.sampled_from([0.0, 5.0, 12.0])), max_size=4))
def test_what_is_played_stays_the_same(base, program):
    ego = base.participants[0].model_copy(update={"speed_program": tuple(program)})
    concrete = base.model_copy(update={"participants": (ego, base.participants[1])})
    cleared = put_between_steps(concrete, PATHS)
    # Of a tie two simulators make different steps: as it is played where the ties are looked for.
    before, after = (play(c, PATHS, dt_s=STEP_S) for c in (concrete, cleared))
    alike = simulate(cleared, PATHS, dt_s=STEP_S)
    for name in PATHS:
        np.testing.assert_array_equal(before[name].s_m, after[name].s_m)
        np.testing.assert_allclose(after[name].s_m, alike[name].s_m, atol=1e-6)
    assert put_between_steps(cleared, PATHS).participants == cleared.participants


def test_a_tie_ends_up_between_two_steps(cases):
    concrete = scenario(cases, [phase(Travelled(participant="ego", distance_m=50.0))])
    cleared = put_between_steps(concrete, PATHS)
    # 50 m are reached exactly after 100 steps of half a metre.
    assert cleared.participants[0].speed_program[0].trigger.distance_m == 49.75
    change = cleared.provenance[-1]
    assert (change.by, change.before, change.after) == ("rounding", 50.0, 49.75)
    assert put_between_steps(cleared, PATHS) is cleared


def test_later_phases_of_a_waiting_one_are_cleared_too(cases):
    stop = phase(Travelled(participant="ego", distance_m=20.2), 0.0)
    go = phase(StoodStill(participant="ego", duration_s=1.5), 10.0)
    late = phase(Travelled(participant="car_1", distance_m=150.0), 4.0)
    cleared = put_between_steps(scenario(cases, [stop, go, late]), PATHS)
    first, wait, last = (p.trigger for p in cleared.participants[0].speed_program)
    assert (first.distance_m, wait.duration_s, last.distance_m) == (20.2, 1.5, 149.75)


@given(st.floats(0.0, 60.0))
def test_coarse_and_fine_steps_fire_next_to_the_moment(moment):
    trigger = just_before_step_s(moment)
    fires = {dt: np.ceil(trigger / dt - 1e-9) * dt for dt in (STEP_S, STEP_S / 5)}
    assert abs(fires[STEP_S] - moment) <= STEP_S / 2 + 1e-6
    assert fires[STEP_S] == pytest.approx(fires[STEP_S / 5])
