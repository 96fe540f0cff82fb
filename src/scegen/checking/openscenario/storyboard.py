"""A scenario as an OpenSCENARIO file states it: entities, starts, trajectories, references."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

EGO_PROPERTY = ("type", "ego_vehicle")
"""The property by which CARLA's scenario_runner, and so we, know the ego."""
EXTERNAL_PROPERTY = ("driven_by", "external")
"""The property of an ego that somebody else drives: it has no way of its own in the file."""


@dataclass(frozen=True, slots=True)
class WorldPoint:
    """A position in the world frame (m, rad)."""

    x: float
    y: float
    heading: float

    @property
    def point(self) -> complex:
        """The position as x + iy."""
        return complex(self.x, self.y)


@dataclass(frozen=True, slots=True)
class LanePoint:
    """A position on a lane, as written."""

    road: str
    lane: int
    s: float
    offset: float


@dataclass(frozen=True, slots=True)
class Entity:
    """A scenario object; ``kind`` is the element that describes it (Vehicle, Pedestrian …).

    ``size_m`` is the length, width and height of its box, where they can be read.
    """

    name: str
    kind: str
    category: str
    is_ego: bool
    is_external: bool = False
    size_m: tuple[float, float, float] | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Trajectory:
    """A polyline that the entities of its maneuver group follow, from ``begins_m`` along it on.

    A row for every vertex; the time is NaN where none is stated, ``points`` are x + iy.
    """

    name: str
    actors: tuple[str, ...]
    times: NDArray[np.float64]
    points: NDArray[np.complex128]
    headings: NDArray[np.float64]
    begins_m: float = 0.0

    @property
    def place(self) -> str:
        """How findings name it."""
        return ", ".join(self.actors) or self.name

    def at(self, along_m: float) -> WorldPoint | None:
        """The place so far along it, None if it ends before that."""
        if not len(self.points) or along_m < 0.0:
            return None
        left = along_m
        chords = np.diff(self.points)
        for begins, chord, heading in zip(self.points, chords, self.headings, strict=False):
            if left < abs(chord):
                place = begins + chord * (left / abs(chord))
                return WorldPoint(float(place.real), float(place.imag), float(heading))
            left -= abs(chord)
        last = self.points[-1]
        heading = float(self.headings[-1])
        return WorldPoint(float(last.real), float(last.imag), heading) if left == 0.0 else None


@dataclass(frozen=True)
class Storyboard:
    """Everything that the rules look at; ``starts``: where the Init section puts entities.

    ``references`` are names of entities, ``lane_points`` positions, each with where it stands.
    """

    name: str
    road_file: str | None
    entities: tuple[Entity, ...]
    starts: dict[str, WorldPoint | LanePoint | None]
    trajectories: tuple[Trajectory, ...]
    references: tuple[tuple[str, str], ...]
    lane_points: tuple[tuple[str, LanePoint], ...]

    @property
    def driven_from_outside(self) -> frozenset[str]:
        """The entities that somebody else drives."""
        return frozenset(entity.name for entity in self.entities if entity.is_external)

    def trajectory(self, entity: str) -> Trajectory | None:
        """The first trajectory that an entity follows."""
        return next((t for t in self.trajectories if entity in t.actors), None)
