"""A driver and a simulation, step by step to the end, and what the drive made of the danger."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from scegen.checking.esmini.recording import Movement
from scegen.checking.said import recorded_view
from scegen.claims.hazards.judging import judge, number
from scegen.motion.batch.arrays import COS, HEADING, SIN, SPEED, TRACK_ROWS, Floats, S, X, Y
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.proof import HazardProof

_MEASURES = ("distance_m", "ttc_s", "pet_s", "drac_mps2", "contact_s")


@dataclass(frozen=True, slots=True)
class State:
    """Where somebody is: the reference point (rear axle; a pedestrian's centre) in the world.

    ``heading_rad`` counter-clockwise from east.
    """

    x_m: float
    y_m: float
    heading_rad: float
    speed_mps: float


class Simulation(Protocol):
    """A scenario whose ego is driven from outside, in steps of ``dt_s``."""

    @property
    def dt_s(self) -> float:
        """The time step."""

    @property
    def time_s(self) -> float:
        """The present time, 0 at the start."""

    @property
    def states(self) -> Mapping[str, State]:
        """Everybody at the present time, things among them, by id."""

    def step(self, ego: State) -> None:
        """Go one step on; ``ego`` is where the ego will be then."""

    def close(self) -> None:
        """End it."""


Driver = Callable[[float, float, Mapping[str, State]], State]
"""From time (s), step (s) and everybody's state to the ego's own state after the next step."""


def as_step(states: Iterable[State], before: Floats | None = None) -> Floats:
    """States as a step of tracks (i, row); the way gone adds up from place to place."""
    seen = np.array([[s.x_m, s.y_m, s.heading_rad, s.speed_mps] for s in states])
    step = np.zeros((len(seen), TRACK_ROWS))
    step[:, [X, Y, HEADING, SPEED]] = seen
    step[:, COS], step[:, SIN] = np.cos(seen[:, 2]), np.sin(seen[:, 2])
    if before is not None:
        step[:, S] = before[:, S] + np.hypot(*(step - before)[:, [X, Y]].T)
    return step


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


@dataclass(frozen=True, slots=True)
class Danger:
    """How near the ego came to one other, None where a measure does not exist.

    ``distance_m`` is the least between the bodies, 0 in contact; ``ttc_s`` the least time to
    collision; ``pet_s`` the post-encroachment time; ``drac_mps2`` the highest deceleration that
    would have been needed; ``contact_s`` when they touched.
    """

    other: str
    distance_m: float | None
    ttc_s: float | None
    pet_s: float | None
    drac_mps2: float | None
    contact_s: float | None


def judged(
    concrete: ConcreteScenario, movements: Sequence[Movement]
) -> tuple[list[Danger], tuple[HazardProof, ...]]:
    """The danger of the ego with everybody else, and whether each hazard still happens.

    Raises:
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """
    view = recorded_view(concrete, list(movements))
    ego = concrete.ego.id
    dangers = []
    for entity in concrete.entities:
        if entity.id == ego or view.pair(ego, entity.id) is None:
            continue
        values = {name: number(view.of_pair(name, ego, entity.id)[0]) for name in _MEASURES}
        dangers.append(Danger(entity.id, **values))
    return dangers, tuple(judge(view, hazard) for hazard in concrete.hazards)
