"""Batch and reference simulator move everybody alike."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from reference_simulator import simulate

from scegen.motion.batch import (
    Phase,
    TriggerKind,
    build_program,
    compile_program,
    repeat,
    simulate_batch,
    stack_traces,
)
from scegen.motion.model import Path
from scegen.scenario.concrete import (
    ArrivalBelow,
    AtTime,
    ConcreteParticipant,
    ConcreteScenario,
    DistanceBelow,
    OnContact,
    SpeedPhase,
    StandingMotion,
    StoodStill,
    Travelled,
)
from scegen.scenario.vocabulary import ParticipantKind, Role

NAMES = ("ego", "red", "blue")
STANDING = StandingMotion(arm=0, side="right", from_junction_m=1.0)


def polyline(x, y, heading, steps, turns):
    """A path of straight pieces whose headings turn a little at every vertex."""
    headings = heading + np.concatenate(([0.0], np.cumsum(turns)))
    xs = x + np.concatenate(([0.0], np.cumsum(steps * np.cos(headings[:-1]))))
    ys = y + np.concatenate(([0.0], np.cumsum(steps * np.sin(headings[:-1]))))
    s = np.concatenate(([0.0], np.cumsum(np.hypot(np.diff(xs), np.diff(ys)))))
    return Path(s, xs, ys, headings, ())


def number(low, high):
    return st.one_of(
        st.floats(low, high, allow_nan=False).map(lambda v: round(v, 3)),
        st.integers(int(np.ceil(low)), int(high)).map(float),
    )


def between(low, high):
    """No round number: where a measure meets it exactly, the last bit decides."""
    return number(low, high).map(lambda v: v + 0.00037)


@st.composite
def paths(draw):
    count = draw(st.sampled_from([0, 3, 30]))
    steps = np.array(draw(st.lists(number(0.2, 5.0), min_size=count, max_size=count)))
    turns = np.array(draw(st.lists(number(-1.5, 1.5), min_size=count, max_size=count)))
    turns *= draw(st.sampled_from([0.0, 1.0]))
    return polyline(draw(number(-20, 20)), draw(number(-20, 20)), draw(number(-3, 3)), steps, turns)


triggers = st.one_of(
    st.builds(AtTime, time_s=number(0, 6)),
    st.builds(Travelled, participant=st.sampled_from(NAMES), distance_m=number(0, 60)),
    st.builds(DistanceBelow, participant=st.sampled_from(NAMES), distance_m=between(1, 40)),
    st.builds(
        ArrivalBelow,
        participant=st.sampled_from(NAMES),
        place_m=number(0, 60),
        time_s=between(1, 6),
    ),
    st.builds(StoodStill, participant=st.sampled_from(NAMES), duration_s=number(1, 4)),
)
programs = st.lists(
    st.builds(
        SpeedPhase,
        trigger=triggers,
        target_speed_mps=number(0, 20),
        rate_mps2=number(0.5, 9),
    ),
    max_size=3,
)


@st.composite
def scenarios(draw):
    participants = tuple(
        ConcreteParticipant(
            id=name,
            kind=ParticipantKind.CAR,
            role=Role.EGO if name == "ego" else Role.OTHER,
            speed_mps=draw(number(0, 20)),
            motion=STANDING,
            speed_program=tuple(draw(programs)),
            on_contact=draw(
                st.none()
                | st.builds(
                    OnContact,
                    participant=st.sampled_from([n for n in NAMES if n != name]),
                    rate_mps2=number(1, 300),
                )
            ),
        )
        for name in NAMES
    )
    # The simulators look at nothing but these.
    concrete = ConcreteScenario.model_construct(
        participants=participants, objects=(), duration_s=draw(st.sampled_from([0.05, 3.0, 8.0]))
    )
    return concrete, {name: draw(paths()) for name in NAMES}


@settings(max_examples=150)
@given(scenarios(), st.sampled_from([0.05, 0.01, 0.1]))
def test_agrees_with_the_reference_simulator(scenario, dt_s):
    concrete, ways = scenario
    expected = simulate(concrete, ways, dt_s=dt_s)
    program, candidate = compile_program(concrete, ways)
    got = simulate_batch(program, candidate, duration_s=concrete.duration_s, dt_s=dt_s)
    for i, name in enumerate(NAMES):
        trace = expected[name]
        np.testing.assert_allclose(got.time_s, trace.time_s, rtol=0, atol=1e-9)
        for field in ("s_m", "x_m", "y_m", "heading_rad", "speed_mps"):
            ours = getattr(got, field)[0, :, i]
            np.testing.assert_allclose(
                # Along the path, as the reference has them: backwards they are below 0.
                np.abs(ours) if field == "speed_mps" else ours,
                getattr(trace, field),
                rtol=0,
                atol=1e-9,
                err_msg=field,
            )
    stacked = stack_traces([expected[name] for name in NAMES], [ways[name] for name in NAMES])
    np.testing.assert_allclose(got.tracks, stacked.tracks, rtol=0, atol=1e-9)


STRAIGHT = polyline(0.0, 0.0, 0.0, np.full(40, 4.0), np.zeros(40))


def one_mover(*phases, speed=10.0, path=STRAIGHT):
    return build_program([path], [speed], [list(phases)])


def test_an_action_changes_the_state_one_step_after_its_condition():
    program, candidate = one_mover(Phase(TriggerKind.TIME, 0, 1.0, 5.0, 2.0))
    traces = simulate_batch(program, candidate, duration_s=4.0, dt_s=0.1)
    assert traces.fired_step[0, 0] == 10
    speed = traces.speed_mps[0, :, 0]
    assert speed[10] == 10.0
    assert speed[11] == pytest.approx(9.8)
    assert speed[-1] == 5.0
    # The new speed moves it, not the old one.
    np.testing.assert_allclose(np.diff(traces.x_m[0, :, 0]), speed[1:] * 0.1, atol=1e-9)


def test_candidates_differ_only_in_their_numbers():
    program, candidate = one_mover(Phase(TriggerKind.TRAVELLED, 0, 20.0, 3.0, 4.0))
    many = repeat(candidate, 3)
    many.speed_mps[1] = 14.0
    many.trigger[2] = 25.0
    traces = simulate_batch(program, many, duration_s=5.0)
    for c in range(3):
        alone = simulate_batch(program, type(many)(*(a[c : c + 1] for a in many)), duration_s=5.0)
        np.testing.assert_array_equal(traces.tracks[c], alone.tracks[0])
    assert len({tuple(traces.s_m[c, :, 0]) for c in range(3)}) == 3


def test_a_start_offset_is_a_shorter_path():
    program, candidate = one_mover(Phase(TriggerKind.TRAVELLED, 0, 20.0, 15.0, 4.0))
    late = repeat(candidate, 1)
    late.start_m[:] = 30.0
    traces = simulate_batch(program, late, duration_s=20.0)
    shorter = polyline(30.0, 0.0, 0.0, np.full(26, 5.0), np.zeros(26))
    program, candidate = one_mover(Phase(TriggerKind.TRAVELLED, 0, 20.0, 15.0, 4.0), path=shorter)
    expected = simulate_batch(program, candidate, duration_s=20.0)
    np.testing.assert_allclose(traces.x_m, expected.x_m, atol=1e-9)
    np.testing.assert_allclose(traces.speed_mps, expected.speed_mps, atol=1e-9)
    np.testing.assert_allclose(traces.s_m, expected.s_m + 30.0, atol=1e-9)
    assert traces.speed_mps[0, -1, 0] == 0.0  # the path has ended


def test_starting_at_the_end_means_standing():
    program, candidate = one_mover()
    candidate.start_m[:] = STRAIGHT.length_m + 5.0
    traces = simulate_batch(program, candidate, duration_s=1.0)
    assert np.all(traces.speed_mps == 0.0)
    assert np.all(traces.x_m == STRAIGHT.x_m[-1])


@pytest.mark.parametrize("value", [0.8, 2.0, 3.5])
def test_arrival_looks_at_straight_distance_and_speed(value):
    bend = polyline(0.0, 0.0, 0.0, np.full(60, 1.0), np.full(60, 0.02))
    phases = [[Phase(TriggerKind.ARRIVAL_BELOW, 1, value, 0.0, 5.0, 50.0)], []]
    program, candidate = build_program([STRAIGHT, bend], [5.0, 8.0], phases)
    traces = simulate_batch(program, candidate, duration_s=7.0)
    point = bend.pose(50.0)
    away = np.hypot(traces.x_m[0, :, 1] - point.x_m, traces.y_m[0, :, 1] - point.y_m)
    assert traces.fired_step[0, 0] == np.flatnonzero(away / 8.0 < value)[0]
    assert traces.speed_mps[0, -1, 0] < 5.0


def test_nobody_arrives_at_what_lies_behind_or_from_standstill():
    phases = [[Phase(TriggerKind.ARRIVAL_BELOW, 1, 9.0, 0.0, 5.0, 10.0)], []]
    program, candidate = build_program([STRAIGHT, STRAIGHT], [5.0, 8.0], phases)
    behind = repeat(candidate, 2)
    behind.start_m[0, 1] = 10.5
    behind.speed_mps[1, 1] = 0.0
    traces = simulate_batch(program, behind, duration_s=5.0)
    assert traces.fired_step.tolist() == [[-1], [-1]]


def test_two_runs_give_the_same_bits():
    program, candidate = one_mover(Phase(TriggerKind.TIME, 0, 0.7, 4.1, 2.3), speed=11.3)
    one = simulate_batch(program, candidate, duration_s=9.0)
    two = simulate_batch(program, candidate, duration_s=9.0)
    assert one.tracks.tobytes() == two.tracks.tobytes()
