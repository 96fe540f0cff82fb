"""Compile the kernels ahead of their first use."""

from time import perf_counter

import numpy as np

from scegen.measures.distance import distances_at
from scegen.measures.evaluation import evaluate, measure
from scegen.measures.occlusion import occlusion_series
from scegen.measures.tables import build_tables
from scegen.motion.batch import build_program, simulate_batch
from scegen.motion.model import Path
from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ParticipantKind


def warm_kernels() -> float:
    """Compile, or load from the cache, all that a search runs; returns the seconds it took.

    The first time after an installation takes some 15 s, later processes well under one. Call it
    before anything that is timed or has a time budget.
    """
    begin = perf_counter()
    s = np.array([0.0, 4.0, 8.0])
    ahead, across = np.zeros(3), np.full(3, np.pi / 2)
    paths = [Path(s, s, ahead, ahead, ()), Path(s, ahead + 6.0, s - 4.0, across, ())]
    program, candidate = build_program(paths, [1.0, 1.0], [[], []])
    scene = build_tables(paths, [BODIES[ParticipantKind.CAR]] * 2)
    evaluate(program, candidate, scene, duration_s=0.1)
    traces = simulate_batch(program, candidate, duration_s=0.1)
    measure(traces, scene)
    distances_at(traces.tracks, scene.bodies, scene.pairs[0], np.zeros((1, 1), dtype=np.int64))
    occlusion_series(traces.tracks, scene.bodies, scene.occlusions)
    return perf_counter() - begin
