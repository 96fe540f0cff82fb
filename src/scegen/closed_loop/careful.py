"""The careful and competent driver of UN R157, who decides from step to step what it does.

Its figures and what it can perceive are those of :mod:`scegen.criticality.careful_driver` and
:mod:`scegen.criticality.perception`, where their sources stand. It keeps the ego's path and planned
speed; a danger that it perceives for 0.4 s without a break makes it brake 0.75 s later, to a
standstill.
"""

from collections.abc import Mapping

import numpy as np

from scegen.closed_loop.running import State, as_step
from scegen.criticality.careful_driver import (
    DELAY_S,
    JERK_MPS3,
    RISK_EVALUATION_S,
    hardest_mps2,
    horizon_s,
)
from scegen.criticality.perception import perceivable_dangers
from scegen.measures.bodies import body_table
from scegen.motion import build_paths, simulate
from scegen.motion.batch.arrays import SPEED, Floats
from scegen.motion.friction import friction_of
from scegen.motion.model import Path
from scegen.motion.standing import object_paths
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario

_ROUNDING_S = 1e-6


class CarefulDriver:
    """Drives the ego of a scenario; ask it once a step.

    ``brakes_s`` is when its brakes act and ``danger`` for whom, None as long as they do not.

    Raises:
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """

    def __init__(self, concrete: ConcreteScenario) -> None:
        self.danger: str | None = None
        self.brakes_s: float | None = None
        self._names = [entity.id for entity in concrete.entities]
        self._ego = self._names.index(concrete.ego.id)
        own = build_paths(concrete, build_network(concrete.road, concrete.name))
        paths = {**own, **object_paths(concrete)}
        self._ways: list[Path] = [paths[name] for name in self._names]
        self._way = paths[concrete.ego.id]
        friction = friction_of(concrete.environment)
        self._bodies = body_table([each.body for each in concrete.entities], friction=friction)
        self._hardest_mps2 = hardest_mps2(concrete.ego.body, friction)
        planned = simulate(concrete, own)[concrete.ego.id]
        self._planned_s, self._planned_mps = planned.time_s, planned.speed_mps
        self._s_m = 0.0
        self._seen: list[Floats] = []
        self._since: dict[str, float] = {}

    def __call__(self, time_s: float, dt_s: float, states: Mapping[str, State]) -> State:
        """Where it will be after the next step, from what everybody does now."""
        before = self._seen[-1] if self._seen else None
        self._seen.append(as_step((states[name] for name in self._names), before))
        self._perceive(time_s)
        speed = self._speed(time_s + dt_s, dt_s, states[self._names[self._ego]].speed_mps)
        self._s_m = min(self._s_m + speed * dt_s, self._way.length_m)
        pose = self._way.pose(self._s_m)
        return State(pose.x_m, pose.y_m, pose.heading_rad, speed)

    def _speed(self, time_s: float, dt_s: float, now_mps: float) -> float:
        """As planned until the brakes act; then the pedal goes down within 0.6 s."""
        planned = float(np.interp(time_s, self._planned_s, self._planned_mps))
        if self.brakes_s is None or time_s <= self.brakes_s + _ROUNDING_S:
            return planned
        rate = min(self._hardest_mps2, JERK_MPS3 * (time_s - self.brakes_s))
        return max(0.0, now_mps - rate * dt_s)

    def _perceive(self, time_s: float) -> None:
        """Who has been a perceivable danger, and since when."""
        if self.brakes_s is not None:
            return
        tracks = np.stack(self._seen, axis=2)
        ahead_s = horizon_s(tracks[self._ego, SPEED], self._hardest_mps2)
        now = perceivable_dangers(tracks, self._bodies, self._ways, self._ego, ahead_s)[:, -1]
        for name, dangerous in zip(self._names, now.tolist(), strict=True):
            if not dangerous:
                self._since.pop(name, None)
                continue
            since = self._since.setdefault(name, time_s)
            if time_s - since >= RISK_EVALUATION_S - _ROUNDING_S:
                self.danger, self.brakes_s = name, time_s + DELAY_S
                return
