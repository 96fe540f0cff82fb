"""Run many candidates of one program, or one scenario as it is."""

from collections.abc import Mapping

import numpy as np

from scegen.motion.batch.arrays import (
    BatchTraces,
    Candidates,
    Floats,
    Program,
    empty_traces,
    mark_backwards,
)
from scegen.motion.batch.compilation import compile_program
from scegen.motion.batch.kernels import kernel
from scegen.motion.batch.stepping import run_candidate
from scegen.motion.model import Path, Trace
from scegen.scenario.concrete import ConcreteScenario


def simulate_batch(
    program: Program,
    candidates: Candidates,
    *,
    duration_s: float,
    dt_s: float = 0.05,
    driven: tuple[int, Floats] | None = None,
) -> BatchTraces:
    """Simulate all candidates from 0 to ``duration_s``.

    A participant that reaches the end of its path stops there for good.

    Args:
        program: paths and structure of the speed programs.
        candidates: the numbers that differ.
        duration_s: simulated time, s; the steps are 0 to round(duration / dt).
        dt_s: time step, s.
        driven: who is moved from outside, and its track (row, t), of which step 0 is not looked at.
    """
    traces = empty_traces(
        candidates.speed_mps.shape[0],
        round(duration_s / dt_s) + 1,
        candidates.speed_mps.shape[1],
        candidates.trigger.shape[1],
        dt_s,
    )
    outside = -1
    if driven is not None:
        outside, traces.tracks[:, outside] = driven
    _run(program, candidates, traces, outside)
    mark_backwards(traces, program.paths.backwards)
    return traces


@kernel
def _run(program: Program, candidates: Candidates, traces: BatchTraces, outside: int) -> None:
    for c in range(candidates.speed_mps.shape[0]):
        run_candidate(
            program, candidates, c, traces.dt_s, traces.tracks[c], traces.fired_step[c], outside
        )


def simulate(
    concrete: ConcreteScenario, paths: Mapping[str, Path], *, dt_s: float = 0.05
) -> dict[str, Trace]:
    """Run a scenario from 0 to ``duration_s``; the traces have the same times.

    Args:
        concrete: the scenario.
        paths: its paths by participant, as :func:`scegen.motion.build_paths` makes them.
        dt_s: the time step.
    """
    program, own = compile_program(concrete, paths)
    run = simulate_batch(program, own, duration_s=concrete.duration_s, dt_s=dt_s)
    return traces_of(concrete, run)


def traces_of(concrete: ConcreteScenario, run: BatchTraces) -> dict[str, Trace]:
    """The participants of the first candidate of a run; speeds are along the path."""
    return {
        p.id: Trace(
            participant=p.id,
            body=p.body,
            time_s=run.time_s,
            s_m=run.s_m[0, :, i],
            x_m=run.x_m[0, :, i],
            y_m=run.y_m[0, :, i],
            heading_rad=run.heading_rad[0, :, i],
            speed_mps=np.abs(run.speed_mps[0, :, i]),
        )
        for i, p in enumerate(concrete.participants)
    }
