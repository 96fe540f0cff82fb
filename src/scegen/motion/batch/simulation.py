"""Run many candidates of one program."""

from scegen.motion.batch.arrays import (
    BatchTraces,
    Candidates,
    Program,
    empty_traces,
    mark_backwards,
)
from scegen.motion.batch.kernels import kernel
from scegen.motion.batch.stepping import run_candidate


def simulate_batch(
    program: Program, candidates: Candidates, *, duration_s: float, dt_s: float = 0.05
) -> BatchTraces:
    """Simulate all candidates from 0 to ``duration_s``.

    Row c agrees with :func:`scegen.motion.simulate` on the scenario with c's numbers to rounding
    (there, speeds are along the path).
    A participant that reaches the end of its path stops there for good.

    Args:
        program: paths and structure of the speed programs.
        candidates: the numbers that differ.
        duration_s: simulated time, s; the steps are 0 to round(duration / dt).
        dt_s: time step, s.
    """
    traces = empty_traces(
        candidates.speed_mps.shape[0],
        round(duration_s / dt_s) + 1,
        candidates.speed_mps.shape[1],
        candidates.trigger.shape[1],
        dt_s,
    )
    _run(program, candidates, traces)
    mark_backwards(traces, program.paths.backwards)
    return traces


@kernel
def _run(program: Program, candidates: Candidates, traces: BatchTraces) -> None:
    for c in range(candidates.speed_mps.shape[0]):
        run_candidate(program, candidates, c, traces.dt_s, traces.tracks[c], traces.fired_step[c])
