"""Ten cars of which the first brakes: traffic, not rails, in both simulators and in the files."""

from itertools import pairwise

import numpy as np
import pytest
from saying import KMH, missed, person, said

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.motion import simulate
from scegen.motion.batch.compilation import compile_program
from scegen.motion.batch.simulation import simulate_batch
from scegen.motion.paths import build_paths
from scegen.road import build_network
from scegen.scenario.bodies import BODIES
from scegen.scenario.concrete import DistanceBelow
from scegen.scenario.vocabulary import ParticipantKind

CARS = [f"car_{n}" for n in range(1, 10)]
SPEED = 50
NAMES = [*CARS, "ego"]


def chain(target_kmh=None):
    """The first of ten brakes hard, to a stop or to a speed."""
    behind = [
        {"participant": back, "reference": front, "approaches": ["behind"]}
        for front, back in pairwise(NAMES)
    ]
    amount = (
        {}
        if target_kmh is None
        else {"target_speed_mps": {"low": target_kmh * KMH, "high": target_kmh * KMH}}
    )
    act = {"id": "brake", "participant": "car_1", "kind": "brake", **amount}
    hazard = {"kind": "hard_braking", "by": ["car_1"], "to": ["car_2"]}
    people = [person("ego", speed=SPEED), *(person(name) for name in CARS)]
    return said("straight", *people, relations=behind, acts=[act], hazards=[hazard])


@pytest.fixture(scope="module", params=[None, 20], ids=["to a stop", "to 20 km/h"])
def made(request):
    functional = chain(request.param)
    logical = enumerate_scenarios(functional, limit=5).scenarios[0]
    concrete = concretize(functional, logical, seed=4)
    network = build_network(concrete.road)
    paths = build_paths(concrete, network)
    return functional, concrete, paths, simulate(concrete, paths)


def free_m(traces, front, back):
    body = BODIES[ParticipantKind.CAR]
    apart = np.hypot(traces[front].x_m - traces[back].x_m, traces[front].y_m - traces[back].y_m)
    return apart - body.length_m


def begins_s(trace):
    """When somebody begins to brake."""
    return float(trace.time_s[np.flatnonzero(np.diff(trace.speed_mps) < -1e-3)[0]])


def test_everybody_brakes_a_reaction_time_after_the_one_ahead_and_no_two_alike(made):
    _, concrete, _, traces = made
    delays = np.diff([begins_s(traces[n]) for n in NAMES])
    assert (delays > 0.6).all()
    assert len({round(float(d), 1) for d in delays}) > 3
    rates = [concrete.participant(n).speed_program[0].rate_mps2 for n in NAMES]
    assert rates[0] == max(rates)
    assert len(set(rates)) > 4
    gaps = [free_m(traces, a, b)[0] for a, b in pairwise(NAMES)]
    assert np.ptp(gaps) > 3.0


def test_those_behind_keep_their_distance(made):
    functional, concrete, _, traces = made
    pairs = list(pairwise(NAMES))
    # The second is the one in danger: it brakes as late as it can.
    for front, back in pairs[1:]:
        assert free_m(traces, front, back).min() > 1.5
    slowest = min(float(traces["car_1"].speed_mps.min()), 20 * KMH)
    for front, back in pairs[1:]:
        if traces[back].speed_mps[-1] > 1.0:
            last = free_m(traces, front, back)[-1] / slowest
            assert last > 1.0
    assert not missed(functional, concrete)


def test_it_is_phases_that_look_at_the_one_ahead_and_both_simulators_agree(made):
    _, concrete, paths, traces = made
    for front, back in pairwise(NAMES[1:]):
        (phase,) = concrete.participant(back).speed_program
        assert isinstance(phase.trigger, DistanceBelow)
        assert phase.trigger.participant == front
    program, base = compile_program(concrete, paths)
    batch = simulate_batch(program, base, duration_s=concrete.duration_s)
    for i, participant in enumerate(concrete.participants):
        assert batch.tracks[0, i, 0] == pytest.approx(traces[participant.id].s_m, abs=1e-6)
