"""What a driver sees of everybody, and what it says of itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol


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
        ...

    @property
    def time_s(self) -> float:
        """The present time, 0 at the start."""
        ...

    @property
    def states(self) -> Mapping[str, State]:
        """Everybody at the present time, things among them, by id."""
        ...

    def step(self, ego: State) -> None:
        """Go one step on; ``ego`` is where the ego will be then."""
        ...

    def close(self) -> None:
        """End it."""
        ...
