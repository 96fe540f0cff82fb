"""An ego driven from outside, in our own simulation and in esmini's library, judged afterwards."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from reference_simulator import Steps

from scegen.closed_loop import (
    CarefulDriver,
    OwnSimulation,
    PlayerSimulation,
    State,
    drive,
    esmini_library,
    judged,
)
from scegen.closed_loop.player import LIBRARY_VARIABLE
from scegen.criticality.careful_driver import careful_driver_verdict
from scegen.errors import InputError, MissingToolError
from scegen.motion import build_paths, simulate
from scegen.motion.trigger_steps import STEP_S
from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, EgoMode, Options
from scegen.pipeline.source import resolve_source
from scegen.road import build_network
from scegen.road.geometry import Pose
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load

TEXTS = {
    "red light": "At a four-way intersection the ego drives straight on and a truck from the right "
    "runs the red light; they collide.",
    "pedestrian": "A pedestrian steps out from behind a parked van and is hit by the ego.",
}
needs_library = pytest.mark.skipif(esmini_library() is None, reason="no esmini library")


@pytest.fixture(scope="module", params=sorted(TEXTS))
def made(request, tmp_path_factory):
    """The folder of a scenario whose ego is left to the outside, and its numbers."""
    folder = tmp_path_factory.mktemp("loop") / "out"
    options = Options(ego=EgoMode.EXTERNAL, depth=CheckDepth.NONE)
    generate(resolve_source(TEXTS[request.param]), folder, options)
    (scenario,) = (folder / "scenarios").iterdir()
    return scenario, load(scenario / "concrete.yaml", ConcreteScenario)


@pytest.fixture(scope="module")
def traces(made):
    concrete = made[1]
    return simulate(concrete, build_paths(concrete, build_network(concrete.road)))


@pytest.fixture(scope="module")
def as_planned(made, traces):
    """A driver that does what the scenario has the ego do."""
    ego = traces[made[1].ego.id]

    def driver(time_s, dt_s, states):
        step = round(time_s / dt_s) + 1
        series = (ego.x_m, ego.y_m, ego.heading_rad, ego.speed_mps)
        return State(*(float(values[step]) for values in series))

    return driver


def test_an_ego_that_does_as_planned_changes_nothing(made, traces, as_planned):
    concrete = made[1]
    for movement in drive(OwnSimulation(concrete), as_planned, concrete.duration_s):
        if movement.entity in traces:
            trace = traces[movement.entity]
            assert np.abs(movement.point - (trace.x_m + 1j * trace.y_m)).max() < 1e-9
            assert movement.speed_mps == pytest.approx(trace.speed_mps)


def test_others_move_as_in_the_reference_whatever_the_ego_does(made, traces):
    """It goes half as fast, beside its way, and stands in between."""
    concrete = made[1]
    ego = traces[concrete.ego.id]

    def driver(time_s, dt_s, states):
        step = min(round(time_s / dt_s) + 1, 30) // 2 + max(round(time_s / dt_s) - 60, 0) // 2
        return State(ego.x_m[step], ego.y_m[step] + 1.0, ego.heading_rad[step], ego.speed_mps[step])

    moved = {m.entity: m for m in drive(OwnSimulation(concrete), driver, concrete.duration_s)}
    paths = build_paths(concrete, build_network(concrete.road))
    steps = Steps(concrete, paths, dt_s=STEP_S, outside=concrete.ego.id)
    for number in range(len(moved[concrete.ego.id].time_s)):
        for name, (pose, speed_mps) in steps.placed().items():
            point, speed = moved[name].point[number], moved[name].speed_mps[number]
            assert point == pytest.approx(complex(pose.x_m, pose.y_m), abs=1e-9)
            assert speed == pytest.approx(speed_mps, abs=1e-9)
        state = driver(steps.time_s, STEP_S, None)
        pose = Pose(state.x_m, state.y_m, state.heading_rad)
        steps.put(concrete.ego.id, pose, state.speed_mps)
        steps.advance()


def test_an_ego_that_stands_sets_nothing_off(made):
    """Triggers look at the ego that is there, not at the planned one."""
    concrete = made[1]
    start = OwnSimulation(concrete).states[concrete.ego.id]

    def stands(time_s, dt_s, states):
        return replace(start, speed_mps=0.0)

    moved = drive(OwnSimulation(concrete), stands, concrete.duration_s)
    ego = next(m for m in moved if m.entity == concrete.ego.id)
    assert np.ptp(ego.point.real) == np.ptp(ego.point.imag) == 0.0
    dangers, hazards = judged(concrete, moved)
    assert all(danger.contact_s is None for danger in dangers)
    assert not all(hazard.happened for hazard in hazards)


def test_the_careful_driver_does_what_its_verdict_says(made):
    """Step by step it brakes for whom, and when, the verdict on the whole scenario says."""
    concrete = made[1]
    verdict = careful_driver_verdict(
        concrete, build_paths(concrete, build_network(concrete.road, concrete.name))
    )
    driver = CarefulDriver(concrete)
    dangers, _ = judged(concrete, drive(OwnSimulation(concrete), driver, concrete.duration_s))
    assert driver.danger == verdict.danger
    assert driver.brakes_s == pytest.approx(verdict.brakes_s, abs=0.15)
    touched = {danger.other for danger in dangers if danger.contact_s is not None}
    assert touched == set(verdict.contact) | set(verdict.secondary)


def test_scripted_contact_is_judged_as_such(made, as_planned):
    concrete = made[1]
    moved = drive(OwnSimulation(concrete), as_planned, concrete.duration_s)
    dangers, hazards = judged(concrete, moved)
    assert any(danger.contact_s is not None and danger.distance_m == 0.0 for danger in dangers)
    assert all(hazard.happened for hazard in hazards)


@pytest.mark.esmini
@needs_library
def test_esmini_moves_the_others_as_we_do(made, as_planned):
    scenario, concrete = made
    player = PlayerSimulation(scenario / "scenario.xosc", concrete.ego.id)
    theirs = {m.entity: m for m in drive(player, as_planned, concrete.duration_s)}
    for ours in drive(OwnSimulation(concrete), as_planned, concrete.duration_s):
        other = theirs.pop(ours.entity)
        # A trigger that looks at the ego's place fires one step earlier there.
        a_step_m = STEP_S * float(np.ptp(ours.speed_mps)) + 1e-3
        assert np.abs(ours.point - other.point).max() < a_step_m
        assert ours.speed_mps[-1] == pytest.approx(other.speed_mps[-1], abs=1e-6)
    assert not theirs


@pytest.mark.esmini
@needs_library
def test_the_careful_driver_drives_in_esmini(made):
    scenario, concrete = made
    seen = []
    for simulation in (
        OwnSimulation(concrete),
        PlayerSimulation(scenario / "scenario.xosc", concrete.ego.id),
    ):
        driver = CarefulDriver(concrete)
        dangers, _ = judged(concrete, drive(simulation, driver, concrete.duration_s))
        seen.append((driver, {d.other for d in dangers if d.contact_s is not None}))
    (ours, touched), (theirs, touched_there) = seen
    assert (ours.danger, touched) == (theirs.danger, touched_there)
    assert ours.brakes_s == pytest.approx(theirs.brakes_s, abs=2 * STEP_S)


@pytest.mark.esmini
@needs_library
def test_what_esmini_does_not_take_is_told(made, tmp_path):
    scenario, _ = made
    with pytest.raises(InputError, match="no entity"):
        PlayerSimulation(scenario / "scenario.xosc", "nobody")
    with pytest.raises(InputError, match="does not play"):
        PlayerSimulation(tmp_path / "none.xosc", "ego")


def test_a_library_that_is_not_there_is_told(made, monkeypatch, tmp_path):
    monkeypatch.setenv(LIBRARY_VARIABLE, str(tmp_path / "none.so"))
    assert esmini_library() is None
    with pytest.raises(MissingToolError, match="library") as told:
        PlayerSimulation(made[0] / "scenario.xosc", "ego")
    assert LIBRARY_VARIABLE in told.value.render()
    monkeypatch.delenv(LIBRARY_VARIABLE)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert esmini_library() is None
