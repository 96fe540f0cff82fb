"""Our own simulation with an ego that is driven from outside."""

from collections.abc import Mapping

import numpy as np

from scegen.closed_loop.running import State, as_step
from scegen.motion import build_paths
from scegen.motion.batch import compile_program, simulate_batch
from scegen.motion.batch.arrays import HEADING, SPEED, Floats, X, Y
from scegen.motion.trigger_steps import STEP_S
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario


class OwnSimulation:
    """Steps a concrete scenario by our own simulator: anew each time, which takes it no time.

    Raises:
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """

    def __init__(self, concrete: ConcreteScenario, dt_s: float = STEP_S) -> None:
        self.dt_s = dt_s
        paths = build_paths(concrete, build_network(concrete.road, concrete.name))
        self._program = compile_program(concrete, paths)
        self._names = [entity.id for entity in concrete.entities]
        self._ego = self._names.index(concrete.ego.id)
        self._driven: list[Floats] = []
        start = simulate_batch(*self._program, duration_s=0.0, dt_s=dt_s)
        self._now = start.tracks[0, :, :, 0]
        self._driven.append(as_step([self.states[concrete.ego.id]]))

    @property
    def time_s(self) -> float:
        """The present time."""
        return (len(self._driven) - 1) * self.dt_s

    @property
    def states(self) -> Mapping[str, State]:
        """Everybody at the present time."""
        rows = self._now[:, [X, Y, HEADING, SPEED]].tolist()
        return {
            name: State(x, y, heading, abs(speed))
            for name, (x, y, heading, speed) in zip(self._names, rows, strict=True)
        }

    def step(self, ego: State) -> None:
        """Go one step on."""
        self._driven += [as_step([ego], self._driven[-1])]
        driven = self._ego, np.concatenate(self._driven).T
        end_s = self.time_s
        run = simulate_batch(*self._program, duration_s=end_s, dt_s=self.dt_s, driven=driven)
        self._now = run.tracks[0, :, :, -1]

    def close(self) -> None:
        """Nothing is left open."""
