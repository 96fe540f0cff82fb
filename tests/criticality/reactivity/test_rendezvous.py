"""Who is held back for the ego is back on its plan when they meet."""

import numpy as np
import pytest
from criticality_scenarios import participant, phase

from scegen.claims.ways import paths_of, ways_of
from scegen.concretization import concretize
from scegen.criticality.reactivity.rendezvous import held_back, joins
from scegen.enumeration import enumerate_scenarios
from scegen.motion import simulate
from scegen.motion.model import Trace
from scegen.pipeline.picking import pick
from scegen.road import build_network
from scegen.scenario.bodies import BODIES
from scegen.scenario.concrete import ArrivalBelow, Travelled
from scegen.scenario.vocabulary import HazardKind, ParticipantKind
from scegen.understanding import read

DT = 0.01
MEETING_S = 7.0


@pytest.fixture(scope="module")
def crossing():
    """A scenario of two who cross, with its ways and movements."""
    functional = read("The ego goes straight at a four-way intersection while a car from the right "
                      "goes straight.")  # fmt: skip
    concrete = concretize(functional, pick(enumerate_scenarios(functional), None)[0], seed=0)
    ways = ways_of(concrete, build_network(concrete.road))
    return concrete, ways, simulate(concrete, paths_of(ways), dt_s=DT)


def steady(speeds, times) -> Trace:
    """A movement with these speeds at these times, in between on a line."""
    time = np.arange(0.0, times[-1], DT)
    speed = np.interp(time, times, speeds)
    s = np.cumsum(speed) * DT
    zero = np.zeros_like(s)
    return Trace("car", BODIES[ParticipantKind.CAR], time, s, s, zero, zero, speed)


def test_joins_are_steady_stretches_before_the_meeting():
    slows = phase(Travelled(participant="car", distance_m=30), 4.0, 3.0)
    speeds_up = phase(Travelled(participant="car", distance_m=50), 10.0, 3.0)
    car = participant("car", speed=10.0, program=[slows, speeds_up])
    trace = steady([10, 10, 4, 4, 10, 10], [0, 3, 5, 8, 10, 20])
    found = joins(car, trace, np.array([3.0, 8.0]), 9.0)
    assert [(j.phase, j.speed_mps) for j in found] == [(0, 10.0), (1, 4.0)]
    assert [j.time_s for j in found] == pytest.approx([2.9, 7.9])
    assert joins(car, trace, np.array([3.0, 8.0]), 4.0) == found[:1]
    assert joins(car, trace, np.array([3.0, 8.0]), 0.3) == []


def test_what_serves_a_danger_is_never_left_out():
    hard = phase(Travelled(participant="car", distance_m=30), 4.0, 3.0)
    car = participant("car", speed=10.0, program=[hard])
    trace = steady([10, 10, 4, 4], [0, 3, 5, 20])
    assert len(joins(car, trace, np.array([3.0]), 15.0)) == 2
    danger = hard.model_copy(update={"hazard": HazardKind.HARD_BRAKING})
    car = car.model_copy(update={"speed_program": (danger,)})
    assert [j.phase for j in joins(car, trace, np.array([3.0]), 15.0)] == [0]


@pytest.mark.parametrize("share", [0.6, 0.3, 0.0])
def test_from_the_join_on_everything_is_as_planned(crossing, share):
    concrete, ways, traces = crossing
    car = concrete.participants[1]
    (join, *_) = joins(car, traces[car.id], np.full(len(car.speed_program), np.inf), MEETING_S)
    tried = held_back(
        concrete,
        ways,
        traces["ego"],
        car.id,
        join,
        share=share,
        meeting_s=MEETING_S + 0.5,
        friction=1.0,
    )
    assert tried is not None
    waiting = tried.participant(car.id)
    assert isinstance(waiting.speed_program[0].trigger, ArrivalBelow)
    assert waiting.speed_program[0].trigger.participant == "ego"
    assert waiting.speed_mps == pytest.approx(share * join.speed_mps, abs=1e-3)
    assert waiting.motion.start_m > car.motion.start_m
    assert {c.by for c in tried.provenance[len(concrete.provenance) :]} == {"reactivity"}
    now = simulate(tried, paths_of(ways_of(tried, build_network(tried.road))), dt_s=DT)[car.id]
    was = traces[car.id]
    later = was.time_s > join.time_s + 0.05
    off = np.hypot(now.x_m - was.x_m, now.y_m - was.y_m)[later]
    # A step or two between condition and action.
    assert off.max() < 3 * DT * join.speed_mps
    np.testing.assert_allclose(now.speed_mps[later][:-5], was.speed_mps[later][:-5], atol=0.05)


def test_no_room_to_wait_is_said(crossing):
    concrete, ways, traces = crossing
    car = concrete.participants[1]
    (join, *_) = joins(car, traces[car.id], np.full(len(car.speed_program), np.inf), MEETING_S)
    early = held_back(
        concrete, ways, traces["ego"], car.id, join, share=0.5, meeting_s=0.0, friction=1.0
    )
    assert early is None
    soon = join.__class__(1.0, join.s_m, join.speed_mps, join.phase)
    assert (
        held_back(concrete, ways, traces["ego"], car.id, soon, share=0.0, meeting_s=7, friction=1.0)
        is None
    )
