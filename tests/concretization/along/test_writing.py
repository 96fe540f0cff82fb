"""The files say what the story tells: simulated, everybody is where the story has it."""

from __future__ import annotations

import numpy as np
import pytest
from roads import SCENARIOS

from scegen.concretization.along import compose_along
from scegen.concretization.along.compose import lay
from scegen.concretization.along.telling import story_of
from scegen.enumeration import enumerate_scenarios
from scegen.motion import build_paths, simulate
from scegen.road import build_network

AWAY_M = 0.15


@pytest.mark.parametrize("name", sorted(SCENARIOS))
def test_everybody_is_where_the_story_has_it(name):
    functional = SCENARIOS[name]
    logical = enumerate_scenarios(functional).scenarios[0]
    story = story_of(functional, logical)
    lay(story)
    concrete = compose_along(functional, logical, seed=0)
    paths = build_paths(concrete, build_network(concrete.road))
    traces = simulate(concrete, paths, dt_s=0.01)
    ego = traces["ego"]
    x0, y0, turn = ego.x_m[0], ego.y_m[0], np.exp(-1j * ego.heading_rad[0])
    for runner in story.runners.values():
        if runner.thing:
            continue
        trace = traces[runner.id]
        place = ((trace.x_m - x0) + 1j * (trace.y_m - y0)) * turn
        told = [runner.x_m(t) for t in trace.time_s]
        wide = [runner.y_m(t) - story.ego.y_m(0.0) for t in trace.time_s]
        # Half a step of the players early, with whatever speed is lost meanwhile.
        early = 0.03 * float(np.ptp(trace.speed_mps))
        assert np.abs(place.real - told).max() < AWAY_M + early, runner.id
        assert np.abs(place.imag - wide).max() < AWAY_M, runner.id


@pytest.mark.parametrize("name", sorted(SCENARIOS))
def test_the_files_are_the_same_every_time_and_start_inside_the_road(name):
    functional = SCENARIOS[name]
    logical = enumerate_scenarios(functional).scenarios[0]
    concrete = compose_along(functional, logical, seed=1)
    assert compose_along(functional, logical, seed=1) == concrete
    length = sum(arm.length_m for arm in concrete.road.arms)
    for participant in concrete.participants:
        if participant.motion.type == "drive":
            assert participant.body.rear_m < participant.motion.start_m < length
    spoken = {change.parameter for change in concrete.provenance}
    drivers = [p.id for p in concrete.participants if p.motion.type == "drive"]
    assert {f"{name}.speed_mps" for name in drivers} <= spoken
