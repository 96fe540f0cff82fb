"""One scenario played by the compiled simulator, as the reference plays it, but much sooner."""

from collections.abc import Mapping

import numpy as np

from scegen.motion.batch.arrays import BatchTraces
from scegen.motion.batch.compilation import compile_program
from scegen.motion.batch.simulation import simulate_batch
from scegen.motion.model import Path, Trace
from scegen.scenario.concrete import ConcreteScenario


def play(
    concrete: ConcreteScenario, paths: Mapping[str, Path], *, dt_s: float = 0.05
) -> dict[str, Trace]:
    """Run a scenario from 0 to ``duration_s``, as :func:`scegen.motion.simulate` does, to rounding.

    Args:
        concrete: the scenario.
        paths: its paths by participant, as :func:`scegen.motion.build_paths` makes them.
        dt_s: the time step.
    """
    program, own = compile_program(concrete, paths)
    return traces_of(
        concrete, simulate_batch(program, own, duration_s=concrete.duration_s, dt_s=dt_s)
    )


def traces_of(concrete: ConcreteScenario, run: BatchTraces) -> dict[str, Trace]:
    """The first candidate of a run, as the reference gives its movements."""
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
