"""esmini shows what the simulator predicts, and the comparison notices when it does not."""

from __future__ import annotations

import re
import shutil
from dataclasses import replace
from itertools import islice

import numpy as np
import pytest

from scegen.checking import CHECKERS, REPLAY, CheckStatus, check_folder
from scegen.checking.environment import esmini
from scegen.checking.esmini.playing import STEP_S, play
from scegen.checking.esmini.recording import Movement, read_recording
from scegen.checking.replay import (
    EVENT_STEPS,
    MAX_M,
    P95_M,
    compare,
    position_errors,
    predict,
)
from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.errors import InfeasibleError
from scegen.export.opendrive import write_opendrive
from scegen.export.openscenario import write_openscenario
from scegen.motion import build_paths
from scegen.motion.model import Trace
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.files import load, to_yaml
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.junction import ARM_COUNTS, Junction
from scegen.scenario.vocabulary import HazardKind, JunctionKind, Maneuver, ParticipantKind, Role

EACH = 4
"""Scenarios of each set of hazards."""


def hazard_sets(kind: JunctionKind):
    """Dangers between the ego, a car and a pedestrian, by junction."""
    cross = Hazard(kind=HazardKind.CROSSING_PEDESTRIAN, by=("walker",), to=("ego",))
    speed = Hazard(kind=HazardKind.SPEEDING, by=("car",))
    brake = Hazard(kind=HazardKind.HARD_BRAKING, by=("car",), to=("ego",))
    cut_in = Hazard(kind=HazardKind.CUT_IN, by=("car",), to=("ego",))
    yield_ = Hazard(kind=HazardKind.FAILURE_TO_YIELD, by=("car",), to=("ego",))
    if kind in {JunctionKind.STRAIGHT, JunctionKind.ROUNDABOUT}:
        return [(cut_in,), (cross, speed), (brake,)]
    return [(yield_,), (cross, speed)]


def functional(kind: JunctionKind, hazards) -> FunctionalScenario:
    arms = ARM_COUNTS[kind][0]
    changes = any(h.kind is HazardKind.CUT_IN for h in hazards)
    maneuvers = {Maneuver.LANE_CHANGE} if changes and kind is JunctionKind.STRAIGHT else set()
    people = [
        Participant(id="ego", role=Role.EGO),
        Participant(id="car", maneuvers=frozenset(maneuvers)),
        Participant(id="truck", kind=ParticipantKind.TRUCK),
    ]
    if any("walker" in h.by for h in hazards):
        walks = frozenset({Maneuver.CROSS})
        people.append(Participant(id="walker", kind=ParticipantKind.PEDESTRIAN, maneuvers=walks))
    return FunctionalScenario(
        description="for tests",
        junction=Junction(
            kind=kind,
            arms=arms,
            lanes=(2,) * arms,
            ring_lanes=2 if kind is JunctionKind.ROUNDABOUT else None,
        ),
        participants=tuple(people),
        hazards=tuple(hazards),
    )


def scenarios():
    for kind in JunctionKind:
        for seed, hazards in enumerate(hazard_sets(kind)):
            described = functional(kind, hazards)
            listed = enumerate_scenarios(described).scenarios
            spread = listed[:: max(1, len(listed) // (2 * EACH))]
            yield from islice(made(described, spread, seed), EACH)


def made(described, listed, seed):
    for logical in listed:
        try:
            yield concretize(described, logical, seed=seed)
        except InfeasibleError:
            continue


def write(folder, concrete):
    network = build_network(concrete.road, concrete.name)
    paths = build_paths(concrete, network)
    (folder / "road.xodr").write_text(write_opendrive(network))
    (folder / "scenario.xosc").write_bytes(write_openscenario(concrete, paths))
    (folder / "concrete.yaml").write_text(to_yaml(concrete))
    return folder / "scenario.xosc"


def replayed(folder, concrete):
    played = play(write(folder, concrete))
    assert played.code == 0
    return compare(predict(concrete), read_recording(played.recording), played.log)


def arrive(concrete: ConcreteScenario) -> ConcreteScenario:
    """The scenario, played on until everybody has reached the end of the path."""
    return concrete.model_copy(update={"duration_s": concrete.duration_s + 25.0})


@pytest.mark.esmini
@pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")
def test_esmini_agrees_on_all_kinds_of_junctions(tmp_path):
    found, kinds, changes, arrivals = [], set(), 0, 0
    for number, generated in enumerate(scenarios()):
        concrete = arrive(generated) if number % 4 == 0 else generated
        arrivals += concrete is not generated
        agreement = replayed(tmp_path, concrete)
        assert agreement.findings == (), (concrete.road.kind, concrete.name, number)
        found.append(agreement)
        kinds.add(concrete.road.kind)
        changes += any(
            p.motion.lane_changes
            for p in concrete.participants
            if isinstance(p.motion, DriveMotion)
        )
    assert len(found) >= 50
    assert kinds == set(JunctionKind)
    assert (changes >= 5, arrivals >= 10) == (True, True)
    assert sum(a.events for a in found) >= 50
    assert sum(a.contacts for a in found) >= 10
    assert max(a.p95_m for a in found) <= P95_M
    assert max(a.max_m for a in found) <= MAX_M


@pytest.fixture
def concrete(folder):
    return load(folder / "concrete.yaml", ConcreteScenario)


def edited(folder, pattern, replacement):
    file = folder / "scenario.xosc"
    text, count = re.subn(pattern, replacement, file.read_text(), flags=re.DOTALL)
    assert count > 0
    file.write_text(text)
    return check_folder(folder, [REPLAY]).result(REPLAY)


def rules(result):
    return {finding.rule for finding in result.errors}


@pytest.mark.esmini
@pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")
def test_a_good_folder_agrees_and_twice_the_same(folder):
    one, two = (check_folder(folder, [REPLAY]).result(REPLAY) for _ in range(2))
    assert one.status is CheckStatus.PASSED
    assert one == two
    assert "events" in one.detail


@pytest.mark.esmini
@pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")
def test_another_speed_is_noticed(folder):
    result = edited(folder, r'(entityRef="car">.*?AbsoluteTargetSpeed value=")[\d.]+', r"\g<1>3.21")
    assert {"replay.position", "replay.p95"} <= rules(result)


@pytest.mark.esmini
@pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")
def test_an_event_at_another_time_is_noticed(folder):
    result = edited(folder, r'(TraveledDistanceCondition value=")([\d.]+)', r"\g<1>1\g<2>")
    assert "replay.event" in rules(result)


def test_what_cannot_be_compared_is_not_run(folder, monkeypatch):
    assert REPLAY not in CHECKERS
    (folder / "concrete.yaml").rename(folder / "kept")
    assert check_folder(folder, [REPLAY]).result(REPLAY).status is CheckStatus.NOT_RUN
    shutil.move(folder / "kept", folder / "concrete.yaml")
    monkeypatch.setenv("PATH", "")
    result = check_folder(folder, [REPLAY]).result(REPLAY)
    assert (result.status, "not on PATH" in result.detail) == (CheckStatus.NOT_RUN, True)


def as_played(predicted, shift_steps=0):
    """A recording and a log that say what was predicted, events and contacts shifted."""
    movements = [
        Movement(name, t.time_s, t.x_m + 1j * t.y_m, t.speed_mps, t.heading_rad)
        for name, t in predicted.traces.items()
    ]
    shift_s = shift_steps * STEP_S
    lines = [
        f"[{time + shift_s:.3f}] [info] {event} standbyState -> startTransition -> runningState"
        for event, time in predicted.fired_s.items()
    ]
    lines += [
        f"[{time + shift_s:.3f}] [warn] Collision between {' and '.join(sorted(pair))}"
        for pair, time in predicted.contact_s.items()
    ]
    return movements, "\n".join(lines)


@pytest.fixture(scope="module")
def contact():
    """A prediction in which bodies touch."""
    for concrete in scenarios():
        predicted = predict(concrete)
        if predicted.contact_s and predicted.fired_s:
            return predicted
    raise AssertionError("nobody touches anybody")


def test_events_and_contacts_may_be_two_steps_off_and_no_more(contact):
    assert compare(contact, *as_played(contact)).findings == ()
    assert compare(contact, *as_played(contact, EVENT_STEPS)).findings == ()
    late = compare(contact, *as_played(contact, EVENT_STEPS + 1))
    assert {f.rule for f in late.findings} == {"replay.event", "replay.contact"}


def test_contacts_in_one_program_only_are_noticed(contact):
    movements, log = as_played(contact)
    silent = "\n".join(line for line in log.splitlines() if "Collision" not in line)
    assert {f.rule for f in compare(contact, movements, silent).findings} == {"replay.contact"}
    apart = next(pair for pair, m in contact.distance_m.items() if m > 1.0)
    more = log + f"\n[1.000] [warn] Collision between {' and '.join(sorted(apart))}"
    (finding,) = compare(contact, movements, more).findings
    assert finding.rule == "replay.contact"


def test_one_who_is_not_played_is_noticed(contact):
    movements, log = as_played(contact)
    assert "replay.missing" in {f.rule for f in compare(contact, movements[1:], log).findings}


def test_a_body_that_heads_elsewhere_is_noticed(contact):
    movements, log = as_played(contact)
    turned = replace(movements[0], heading_rad=movements[0].heading_rad + np.pi)
    found = {f.rule for f in compare(contact, [turned, *movements[1:]], log).findings}
    assert found == {"replay.heading"}
    whole = replace(movements[0], heading_rad=movements[0].heading_rad + 2 * np.pi)
    assert compare(contact, [whole, *movements[1:]], log).findings == ()


def test_the_step_over_the_end_may_be_left_out_or_taken(contact):
    trace = next(iter(contact.traces.values()))
    steps = 6
    x = np.array([0.0, 0.5, 1.0, 1.5, 1.8, 1.8])
    speed = np.array([10.0, 10.0, 10.0, 10.0, 0.0, 0.0])
    times, zero = np.arange(steps) * STEP_S, np.zeros(steps)
    halted = Trace(trace.participant, trace.body, times, x, x, zero, zero, speed)
    short = np.array([0.0, 0.5, 1.0, 1.5, 1.5, 1.5], dtype=complex)
    taken = np.array([0.0, 0.5, 1.0, 1.5, 2.0, 2.0], dtype=complex)
    beyond = np.array([0.0, 0.5, 1.0, 1.5, 2.0, 2.2], dtype=complex)
    aside = np.array([0.0, 0.5, 1.0, 1.5, 1.8, 1.8 + 0.2j])
    before = np.array([0.0, 0.5, 1.0, 1.3, 1.3, 1.3], dtype=complex)
    assert position_errors(halted, short).max() == 0.0
    assert position_errors(halted, taken).max() == 0.0
    assert position_errors(halted, beyond).max() == pytest.approx(0.2)
    assert position_errors(halted, aside).max() == pytest.approx(0.2)
    assert position_errors(halted, before).max() == pytest.approx(0.2)
