"""Our own simulation with an ego that is driven from outside."""

from collections.abc import Mapping

from scegen.closed_loop.running import State
from scegen.motion import build_paths
from scegen.motion.simulation import Steps
from scegen.motion.standing import object_paths
from scegen.motion.trigger_steps import STEP_S
from scegen.road import build_network
from scegen.road.geometry import Pose
from scegen.scenario.concrete import ConcreteScenario


class OwnSimulation:
    """Steps a concrete scenario by our reference simulator.

    Raises:
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """

    def __init__(self, concrete: ConcreteScenario, dt_s: float = STEP_S) -> None:
        paths = build_paths(concrete, build_network(concrete.road, concrete.name))
        self._ego = concrete.ego.id
        self._steps = Steps(concrete, paths, dt_s=dt_s, outside=self._ego)
        self._still = {
            name: State(path.start.x_m, path.start.y_m, path.start.heading_rad, 0.0)
            for name, path in object_paths(concrete).items()
        }

    @property
    def dt_s(self) -> float:
        """The time step."""
        return self._steps.dt_s

    @property
    def time_s(self) -> float:
        """The present time."""
        return self._steps.time_s

    @property
    def states(self) -> Mapping[str, State]:
        """Everybody at the present time."""
        placed = self._steps.placed().items()
        moving = {n: State(p.x_m, p.y_m, p.heading_rad, speed) for n, (p, speed) in placed}
        return moving | self._still

    def step(self, ego: State) -> None:
        """Go one step on."""
        self._steps.put(self._ego, Pose(ego.x_m, ego.y_m, ego.heading_rad), ego.speed_mps)
        self._steps.advance()

    def close(self) -> None:
        """Nothing is left open."""
