"""The evaluation of many candidates: the worst of the plain series, whatever it skips."""

import importlib
import subprocess
import sys

import numpy as np
import pytest
from criticality_geometry import arc, line, through
from series import encroachments, following_series, impact_speeds, required_series

from scegen.measures import (
    MEASURES,
    Subject,
    Summary,
    build_tables,
    evaluate,
    evaluation,
    measure,
    measure_named,
)
from scegen.measures.bodies import body_of
from scegen.measures.distance import distance_series
from scegen.measures.injury import injury_probability
from scegen.measures.occlusion import occlusion_series
from scegen.measures.time_to_collision import time_to_collision_series
from scegen.motion.batch import Phase, TriggerKind, build_program, repeat, simulate_batch
from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ParticipantKind

BOXES = [BODIES[ParticipantKind(kind)] for kind in ("car", "car", "truck", "pedestrian", "bus")]
DURATION_S = 9.0


@pytest.fixture(scope="module")
def case():
    """A car behind a car, a truck across, a pedestrian across, a bus in a bend between them."""
    cutting_in = through(
        [(x, 3.5 * np.exp(-(((x + 30) / 25) ** 4))) for x in np.arange(-60, 80, 0.5)]
    )
    paths = [
        line(-80, 0, 0, 160),
        cutting_in,
        line(0, -70, np.pi / 2, 140),
        line(30, -8, np.pi / 2, 16),
        arc(25.0, -2.5, 1.5),
    ]
    phases = [
        [Phase(TriggerKind.DISTANCE_BELOW, 2, 30.0, 3.0, 6.0)],
        [Phase(TriggerKind.TIME, 0, 2.0, 2.0, 5.0), Phase(TriggerKind.TIME, 0, 4.0, 12.0, 3.0)],
        [Phase(TriggerKind.TRAVELLED, 0, 30.0, 14.0, 2.0)],
        [Phase(TriggerKind.ARRIVAL_BELOW, 0, 3.0, 2.0, 2.0, 100.0)],
        [],
    ]
    program, candidate = build_program(paths, [14.0, 9.0, 10.0, 0.0, 7.0], phases)
    many = repeat(candidate, 60)
    rng = np.random.default_rng(8)
    many.start_m[:] = rng.uniform(0.0, 12.0, many.start_m.shape) * (np.arange(5) != 3)
    many.speed_mps[:] *= rng.uniform(0.5, 1.5, many.speed_mps.shape)
    many.trigger[:] *= rng.uniform(0.5, 1.5, many.trigger.shape)
    scene = build_tables(paths, BOXES, occlusions=[(0, 3, 4), (0, 2, 4), (0, 3, 1)], friction=0.6)
    traces = simulate_batch(program, many, duration_s=DURATION_S)
    summary = evaluate(program, many, scene, duration_s=DURATION_S)
    return program, many, scene, traces, summary


def until_contact(values, contact, worst):
    """The worst value of a series up to the first contact: (candidate, pair)."""
    out = np.full((values.shape[0], values.shape[2]), np.nan)
    for c in range(values.shape[0]):
        for p in range(values.shape[2]):
            hits = np.flatnonzero(contact[c, :, p])
            part = values[c, : hits[0] + 1 if len(hits) else None, p]
            part = part[~np.isnan(part)]
            out[c, p] = worst(part) if len(part) else np.nan
    return out


def same(got, expected):
    np.testing.assert_allclose(got, expected, rtol=1e-9, atol=1e-9)
    assert np.isfinite(got).any()


def test_measuring_traces_and_evaluating_candidates_is_the_same(case):
    _, _, scene, traces, summary = case
    for name, a, b in zip(Summary._fields, summary, measure(traces, scene), strict=True):
        np.testing.assert_array_equal(a, b, err_msg=name)


def test_two_runs_give_the_same_bits(case):
    program, many, scene, _, summary = case
    again = evaluate(program, many, scene, duration_s=DURATION_S)
    assert all(a.tobytes() == b.tobytes() for a, b in zip(summary, again, strict=True))


def test_distance_and_contact(case):
    _, _, scene, traces, summary = case
    distance = distance_series(traces.tracks, scene.bodies, scene.pairs)
    contact = distance == 0.0
    assert 0.05 < contact.any(axis=1).mean() < 0.95
    same(summary.distance_m, distance.min(axis=1))
    same(summary.closest_s, distance.argmin(axis=1) * 0.05)
    first = np.where(contact.any(axis=1), contact.argmax(axis=1) * 0.05, np.nan)
    same(summary.contact_s, first)
    np.testing.assert_array_equal(contact, distance == 0.0)


def test_time_to_collision(case):
    _, _, scene, traces, summary = case
    contact = distance_series(traces.tracks, scene.bodies, scene.pairs) == 0.0
    series = time_to_collision_series(traces.tracks, scene.bodies, scene.pairs)
    np.testing.assert_array_equal(series == 0.0, contact)
    same(summary.ttc_s, until_contact(series, contact, np.min))


def test_headway_drac_and_braking(case):
    _, _, scene, traces, summary = case
    bodies, pairs = scene.bodies, scene.pairs
    contact = distance_series(traces.tracks, bodies, pairs) == 0.0
    headway, drac = following_series(traces, scene)
    same(summary.headway_s, until_contact(headway, contact, np.min))
    same(summary.drac_mps2, until_contact(drac, contact, np.max))
    for way in range(2):
        worst = until_contact(required_series(traces, scene, way), contact, np.max)
        same(summary.required_mps2[:, :, way], worst)
        available = np.array([body_of(bodies, i).available_mps2 for i in pairs[:, way]])
        same(summary.brake_threat[:, :, way], worst / available)
    assert available.max() <= 0.6 * 9.81


def test_pet_impact_and_injury(case):
    _, _, scene, traces, summary = case
    same(summary.pet_s, encroachments(traces, scene))
    contact = distance_series(traces.tracks, scene.bodies, scene.pairs) == 0.0
    speeds = impact_speeds(traces, scene, contact)
    same(summary.impact_mps, speeds)
    bodies = [[body_of(scene.bodies, i) for i in pair] for pair in scene.pairs]
    shares = np.array([[b.mass_kg, a.mass_kg] for a, b in bodies])
    changes = speeds[:, :, None] * shares / shares.sum(axis=1, keepdims=True)
    same(summary.delta_v_mps, changes)
    for p, pair in enumerate(bodies):
        for way, body in enumerate(pair):
            rows = zip(summary.injury[:, p, way], speeds[:, p], changes[:, p, way], strict=True)
            for injury, speed, change in rows:
                assert injury == pytest.approx(injury_probability(body, speed, change), nan_ok=True)


def test_occlusion(case):
    _, _, scene, traces, summary = case
    hidden = occlusion_series(traces.tracks, scene.bodies, scene.occlusions)
    assert hidden.any()
    for c in range(hidden.shape[0]):
        for q in range(hidden.shape[2]):
            text = "".join("x" if h else " " for h in hidden[c, :, q])
            longest = max(text.split(" "), key=len)
            assert summary.occluded_s[c, q] == pytest.approx(len(longest) * 0.05)
            if not longest:
                assert np.isnan(summary.sight_s[c, q])
                continue
            ends = text.index(longest) + len(longest)
            expected = np.inf if ends == len(text) else ends * 0.05
            assert summary.sight_s[c, q] == pytest.approx(expected)


def test_warm_kernels_leaves_nothing_to_compile(case):
    program, many, scene, _, _ = case
    code = (
        "from scegen.measures import evaluation, warm_kernels\n"
        "warm_kernels()\n"
        "print(len(evaluation._evaluate.signatures), len(evaluation._measure.signatures))\n"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert out.stdout.split() == ["1", "1"]
    evaluate(program, many, scene, duration_s=1.0)
    measure(simulate_batch(program, many, duration_s=1.0), scene)
    # One signature each: other scenarios do not make numba compile again.
    assert len(evaluation._evaluate.signatures) == 1
    assert len(evaluation._measure.signatures) == 1


def test_the_registry_names_what_exists(case):
    summary = case[-1]
    assert len({m.name for m in MEASURES}) == len(MEASURES)
    assert {m.field for m in MEASURES} == set(Summary._fields) - {"closest_s"}
    for m in MEASURES:
        module = importlib.import_module(f"scegen.measures.{m.defined_by}")
        for line_start in ("Unit:", "Direction:", "Source", "Validity:"):
            assert f"\n{line_start}" in module.__doc__, (m.name, line_start)
        values = getattr(summary, m.field)
        assert (values.ndim == 3) == (m.subject is Subject.EACH)
    assert measure_named("pet").unit == "s"
    with pytest.raises(KeyError):
        measure_named("danger")
