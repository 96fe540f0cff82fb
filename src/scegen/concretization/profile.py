"""Changes of speed, and the way travelled over time by phases of steady acceleration."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Protocol

import numpy as np

from scegen.motion.model import Array
from scegen.scenario.bodies import Body
from scegen.scenario.vocabulary import HazardKind


class Sort(Enum):
    """What a change is: a danger's, an act, the road's (round a bend), what follows another."""

    DANGER = "danger"
    ACT = "act"
    SLOWS = "slows"
    FREES = "frees"
    GOES_ON = "goes on"


@dataclass(frozen=True, slots=True)
class SpeedChange:
    """The speed goes over to ``target_mps`` at ``rate_mps2``: from ``begins_s`` on, or ``s_m``.

    At a junction it is tied to the place ``s_m`` of the path (from the outer end) until a drive is
    worked out. With ``then_s`` it comes so long after the one before it has ended instead, wherever
    that is, and ``then`` is one that does so at once.
    What the road slows down to must be reached ``by_m``: where acts have changed the speed, it
    begins just in time for that. ``act`` names the act of the text that it is, ``hazard`` the
    danger that it serves, ``reacts_to`` whom it answers. ``timed``: it comes so long after the
    start, whatever others do.
    """

    target_mps: float
    rate_mps2: float
    begins_s: float = 0.0
    s_m: float = 0.0
    act: str | None = None
    hazard: HazardKind | None = None
    sort: Sort = Sort.DANGER
    then: SpeedChange | None = None
    then_s: float | None = None
    by_m: float = 0.0
    reacts_to: str | None = None
    timed: bool = False


class Mover(Protocol):
    """One who goes along a way and may brake; ``steps`` are the changes of its speed."""

    id: str
    body: Body
    steps: list[SpeedChange]

    @property
    def speed_mps(self) -> float:
        """The speed before all steps."""

    def speed_at_mps(self, time_s: float) -> float:
        """Its speed at a time of the scenario; 0 at the end of its way."""

    def gone_m(self, time_s: float) -> float:
        """How far it has come by then."""

    def timing(self) -> Callable[[SpeedChange, float], SpeedChange]:
        """What lets a step begin at a moment, as this one drives now."""

    def after(self, step: SpeedChange, then_s: float) -> SpeedChange:
        """A step that comes so long after the others are over."""


NEVER_S = 1e6
_STANDS_MPS = 1e-9


class Profile:
    """Phases of steady acceleration, one after another from time 0 and place 0 on."""

    def __init__(self, speed_mps: float) -> None:
        self._phases: list[tuple[float, float, float, float]] = [(0.0, 0.0, speed_mps, 0.0)]
        self._times = [0.0]

    def change(self, begins_s: float, target_mps: float, rate_mps2: float) -> None:
        """From a time on, go over to another speed; what was under way then is given up."""
        while len(self._phases) > 1 and self._phases[-1][0] >= begins_s:
            self._phases.pop()
        way, speed = self._state(self._phases[-1], begins_s)
        change = target_mps - speed
        if abs(change) < 1e-9:
            self._phases.append((begins_s, way, speed, 0.0))
        else:
            rate = rate_mps2 if change > 0 else -rate_mps2
            self._phases.append((begins_s, way, speed, rate))
            ends_s = begins_s + change / rate
            way, _ = self._state(self._phases[-1], ends_s)
            self._phases.append((ends_s, way, target_mps, 0.0))
        self._times = [phase[0] for phase in self._phases]

    @staticmethod
    def _state(phase: tuple[float, float, float, float], time_s: float) -> tuple[float, float]:
        begins, way, speed, rate = phase
        after = time_s - begins
        return way + speed * after + rate * after * after / 2, speed + rate * after

    def _at(self, time_s: float) -> tuple[float, float]:
        return self._state(self._phases[max(0, bisect_right(self._times, time_s) - 1)], time_s)

    @property
    def times_s(self) -> list[float]:
        """When its phases begin."""
        return self._times

    def way_m(self, time_s: float) -> float:
        """The way travelled since the start."""
        return self._at(time_s)[0]

    def speed_mps(self, time_s: float) -> float:
        """The speed at a time."""
        return self._at(time_s)[1]

    def at_times(self, times_s: Array) -> tuple[Array, Array]:
        """(way, speed) at many times."""
        begins, ways, speeds, rates = np.array(self._phases).T
        n = np.maximum(np.searchsorted(begins, times_s, side="right") - 1, 0)
        after = times_s - begins[n]
        speed = speeds[n] + rates[n] * after
        return ways[n] + (speeds[n] + speed) / 2 * after, speed

    def time_s(self, way_m: float) -> float:
        """When that way has been travelled; ``NEVER_S`` if it never is."""
        _, way, speed, _ = self._phases[-1]
        reached = way_m <= way or speed > _STANDS_MPS
        return float(self.times_at(np.array(way_m))) if reached else NEVER_S

    def times_at(self, ways_m: Array) -> Array:
        """When ways have been travelled for the first time; all of them are travelled."""
        begins, ways, speeds, rates = np.array(self._phases).T
        n = np.maximum(np.searchsorted(ways, ways_m) - 1, 0)
        left = ways_m - ways[n]
        then = np.sqrt(np.maximum(speeds[n] ** 2 + 2 * rates[n] * left, 0.0))
        times: Array = begins[n] + 2 * left / np.maximum(speeds[n] + then, _STANDS_MPS)
        return times

    def rests_s(self, after_s: float) -> float:
        """When it first stands from a time on; ``NEVER_S`` if it never does."""
        standing = (t for t, _, speed, rate in self._phases if abs(speed) + abs(rate) < 1e-9)
        return next((t for t in standing if t > after_s), NEVER_S)

    def settles_s(self, after_s: float) -> float:
        """When the change of speed under way at a time is over."""
        n = max(0, bisect_right(self._times, after_s + 1e-9) - 1)
        return self._phases[n + 1][0] if n + 1 < len(self._phases) else after_s
