"""The moment that a picture of a scenario is about: when the ego and another come closest."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from scegen.criticality.course import in_the_way
from scegen.motion.model import Trace
from scegen.scenario.bodies import BODIES
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.objects import StaticObject
from scegen.scenario.vocabulary import ParticipantKind

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Encounter:
    """The closest approach of the ego's box to the box of ``other``, at step ``step``."""

    other: str
    step: int
    time_s: float
    distance_m: float


def box_corners(kind: ParticipantKind, x_m: Array, y_m: Array, heading_rad: Array) -> Array:
    """Corners of a participant's box, shape (steps, 4, 2), from its reference point's poses."""
    body = BODIES[kind]
    ahead = np.array([body.front_m, body.front_m, -body.rear_m, -body.rear_m])
    left = np.array([1, -1, -1, 1]) * body.width_m / 2
    c, s = np.cos(heading_rad)[:, None], np.sin(heading_rad)[:, None]
    return np.stack(
        (x_m[:, None] + ahead * c - left * s, y_m[:, None] + ahead * s + left * c), axis=-1
    )


def thing_corners(thing: StaticObject) -> Array:
    """Corners of a thing's box, (4, 2)."""
    along = np.array([1, 1, -1, -1]) * thing.length_m / 2
    left = np.array([1, -1, -1, 1]) * thing.width_m / 2
    c, s = np.cos(np.deg2rad(thing.heading_deg)), np.sin(np.deg2rad(thing.heading_deg))
    return np.stack((thing.x_m + along * c - left * s, thing.y_m + along * s + left * c), axis=-1)


def closest_encounter(concrete: ConcreteScenario, traces: Mapping[str, Trace]) -> Encounter | None:
    """The closest approach to the ego; parked vehicles count only where nobody else is.

    A hazard that names a parked vehicle makes it count too, and things that are an obstacle count.
    """
    ego = traces[concrete.ego.id]
    named = {name for hazard in concrete.hazards for name in (*hazard.by, *hazard.to)}
    others = [p for p in concrete.participants if p.id != concrete.ego.id]
    counting = [p for p in others if not p.parked or p.id in named] or others
    best: Encounter | None = None
    ego_boxes = _boxes(ego)
    for participant in counting:
        distances = shapely.distance(ego_boxes, _boxes(traces[participant.id]))
        step = int(np.argmin(distances))
        if best is None or distances[step] < best.distance_m:
            best = Encounter(participant.id, step, float(ego.time_s[step]), float(distances[step]))
    if best is not None and best.distance_m <= 0.0:
        return best
    for thing in (o for o in concrete.objects if in_the_way(concrete, o)):
        distances = shapely.distance(ego_boxes, shapely.Polygon(thing_corners(thing)))
        step = int(np.argmin(distances))
        if best is None or distances[step] < best.distance_m:
            best = Encounter(thing.id, step, float(ego.time_s[step]), float(distances[step]))
    return best


def _boxes(trace: Trace) -> NDArray[np.object_]:
    corners = box_corners(trace.kind, trace.x_m, trace.y_m, trace.heading_rad)
    polygons: NDArray[np.object_] = shapely.polygons(corners)
    return polygons
