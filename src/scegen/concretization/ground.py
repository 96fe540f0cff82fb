"""Where things may stand: off the carriageway, off everybody's way, clear of what stands there."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import shapely
from numpy.typing import NDArray

from scegen.motion.model import Array, Path
from scegen.motion.standing import object_path
from scegen.road.geometry import Pose
from scegen.road.model import LaneType, Road, RoadNetwork
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import ConcreteScenario

_OFF_THE_ROAD_M = 0.2
_OFF_THE_WAY_M = 0.5
_SAMPLE_M = 1.0
_TRAVELLED = frozenset({LaneType.DRIVING, LaneType.PARKING})


def taken_ground(
    network: RoadNetwork, concrete: ConcreteScenario, paths: Mapping[str, Path]
) -> shapely.Geometry:
    """All ground on which nothing may stand."""
    parts = [
        strip.buffer(_OFF_THE_ROAD_M)
        for road in network.roads
        for strip in (_carriageway(road),)
        if strip is not None
    ]
    for participant in concrete.participants:
        path, body = paths[participant.id], participant.body
        if len(path.s_m) > 1:
            parts.append(shapely.union_all(swept(path, body)).buffer(_OFF_THE_WAY_M))
        else:
            middle = path.start.shifted(forward_m=body.centre_ahead_m)
            parts.append(_standing_on(middle, body))
    parts += [_standing_on(object_path(thing).start, thing.body) for thing in concrete.objects]
    return shapely.union_all(parts)


def swept(path: Path, body: Body) -> NDArray[np.object_]:
    """The outlines of a body all along its way: in bends its corners go wide."""
    s = np.linspace(0.0, path.length_m, max(2, int(path.length_m / _SAMPLE_M) + 1))
    heading = np.interp(s, path.s_m, path.heading_rad)
    return boxes(
        np.interp(s, path.s_m, path.x_m) + body.centre_ahead_m * np.cos(heading),
        np.interp(s, path.s_m, path.y_m) + body.centre_ahead_m * np.sin(heading),
        heading,
        body.length_m,
        body.width_m,
    )


def _standing_on(middle: Pose, body: Body) -> shapely.Geometry:
    x, y, heading = (np.array([v]) for v in (middle.x_m, middle.y_m, middle.heading_rad))
    return boxes(x, y, heading, body.length_m, body.width_m)[0].buffer(_OFF_THE_ROAD_M)


def boxes(
    x_m: Array, y_m: Array, heading_rad: Array, length_m: float, width_m: float
) -> NDArray[np.object_]:
    """The outlines of boxes of one size, (n,), by centre and heading."""
    along = np.array([1, 1, -1, -1]) * length_m / 2
    left = np.array([1, -1, -1, 1]) * width_m / 2
    c, s = np.cos(heading_rad)[:, None], np.sin(heading_rad)[:, None]
    corners = np.stack(
        (x_m[:, None] + along * c - left * s, y_m[:, None] + along * s + left * c), axis=-1
    )
    outlines: NDArray[np.object_] = shapely.polygons(corners)
    return outlines


def _carriageway(road: Road) -> shapely.Geometry | None:
    """What is driven or parked on of a road."""
    lanes = [lane for lane in road.lanes if lane.type in _TRAVELLED]
    if not lanes:
        return None
    edges = [
        road.lane_centre_t_m(lane.id) + side * lane.width_m / 2
        for lane in lanes
        for side in (-1, 1)
    ]
    count = max(2, int(road.length_m / _SAMPLE_M) + 1)
    stations = np.linspace(0.0, road.length_m, count)
    right = [road.line.pose(float(s), min(edges)) for s in stations]
    left = [road.line.pose(float(s), max(edges)) for s in stations[::-1]]
    outline = shapely.Polygon([(pose.x_m, pose.y_m) for pose in (*right, *left)])
    return shapely.make_valid(outline)
