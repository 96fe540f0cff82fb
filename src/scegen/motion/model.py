"""Motion = path × speed program: what the simulator evaluates and what export writes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from hashlib import blake2b

import numpy as np
from numpy.typing import NDArray

from scegen.road.geometry import Pose
from scegen.scenario.bodies import Body

Array = NDArray[np.float64]

NEGLIGIBLE = 1e-6
"""esmini's SMALL_NUMBER: below this distance (m) or speed (m/s) no time to arrival exists."""
STANDING_MPS = 1e-3
"""esmini's STAND_STILL_THRESHOLD."""


@dataclass(frozen=True, slots=True)
class LaneSpan:
    """A path lies on lane ``lane`` of road ``road`` from ``start_m`` to ``end_m`` of its length."""

    road: int
    lane: int
    forward: bool
    start_m: float
    end_m: float


@dataclass(frozen=True)
class Path:
    """The way of a reference point (rear axle; a pedestrian's centre) as a polyline.

    ``s_m``, ``x_m``, ``y_m``, ``heading_rad`` have shape (vertices,); s starts at 0 where the
    participant starts and strictly rises; headings are unwrapped. Vertices are dense enough
    (4 m on lines, 0.25 m in arcs and lane changes) that straight interpolation is off by less
    than 1 cm. ``spans`` are the lanes it lies on, in order; empty off the road (crossings).
    A participant that stands has one vertex. Headings are those of the body: where it reverses,
    it moves against them.
    """

    s_m: Array
    x_m: Array
    y_m: Array
    heading_rad: Array
    spans: tuple[LaneSpan, ...]

    @classmethod
    def at(cls, pose: Pose, spans: tuple[LaneSpan, ...] = ()) -> Path:
        """That of one who stands there."""
        values = (0.0, pose.x_m, pose.y_m, pose.heading_rad)
        s, x, y, heading = (np.array([value]) for value in values)
        return cls(s, x, y, heading, spans)

    @property
    def length_m(self) -> float:
        """Length of the path."""
        return float(self.s_m[-1])

    @cached_property
    def backwards(self) -> tuple[tuple[float, float], ...]:
        """Where it is driven backwards: from and to (m), in order."""
        if len(self.s_m) < 2:
            return ()
        dx, dy = np.diff(self.x_m), np.diff(self.y_m)
        back = dx * np.cos(self.heading_rad[:-1]) + dy * np.sin(self.heading_rad[:-1]) < 0.0
        if not back.any():
            return ()
        turns = np.flatnonzero(np.diff(np.concatenate(([False], back, [False]))))
        places = self.s_m[turns].tolist()
        return tuple(zip(places[::2], places[1::2], strict=True))

    @cached_property
    def digest(self) -> bytes:
        """What tells ways apart that lead elsewhere."""
        told = blake2b(self.s_m.tobytes(), digest_size=16)
        for array in (self.x_m, self.y_m, self.heading_rad):
            told.update(array.tobytes())
        return told.digest()

    @property
    def start(self) -> Pose:
        """Where the participant starts."""
        return self.pose(0.0)

    def pose(self, s_m: float) -> Pose:
        """The pose at ``s_m`` from the start, clipped to the path."""
        rows = (self.x_m, self.y_m, self.heading_rad)
        return Pose(*(float(np.interp(s_m, self.s_m, row)) for row in rows))

    def places(self, s_m: Array) -> tuple[Array, Array, Array]:
        """x, y and heading at these ``s_m`` from the start, clipped to the path."""
        x, y, heading = (
            np.interp(s_m, self.s_m, along) for along in (self.x_m, self.y_m, self.heading_rad)
        )
        return x, y, heading


@dataclass(frozen=True)
class Trace:
    """A participant's simulated movement; arrays have shape (steps,), times in rising order."""

    participant: str
    body: Body
    time_s: Array
    s_m: Array
    x_m: Array
    y_m: Array
    heading_rad: Array
    speed_mps: Array

    @property
    def step_s(self) -> float:
        """How far two steps are apart; 1 where there is one alone."""
        return float(self.time_s[1] - self.time_s[0]) if len(self.time_s) > 1 else 1.0
