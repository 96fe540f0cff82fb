"""A driver and a simulation, step by step to the end of the scenario."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from scegen.checking.esmini.recording import Movement
from scegen.closed_loop.state import Simulation, State

Driver = Callable[[float, float, Mapping[str, State]], State]
"""From time (s), step (s) and everybody's state to the ego's own state after the next step."""


def drive(simulation: Simulation, driver: Driver, duration_s: float) -> list[Movement]:
    """Let a driver drive the ego until ``duration_s``; what everybody did, step by step.

    The simulation is closed at the end, whatever happens.
    """
    times, seen = [simulation.time_s], [simulation.states]
    try:
        for _ in range(round(duration_s / simulation.dt_s)):
            simulation.step(driver(times[-1], simulation.dt_s, seen[-1]))
            times.append(simulation.time_s)
            seen.append(simulation.states)
    finally:
        simulation.close()
    return [
        Movement(
            entity=name,
            time_s=np.array(times),
            point=np.array([complex(states[name].x_m, states[name].y_m) for states in seen]),
            speed_mps=np.array([states[name].speed_mps for states in seen]),
            heading_rad=np.array([states[name].heading_rad for states in seen]),
        )
        for name in seen[0]
    ]
