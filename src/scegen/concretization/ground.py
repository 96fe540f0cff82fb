"""Where things may stand: off the carriageway, off everybody's way, clear of what stands there."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import shapely
from numpy.typing import NDArray

from scegen.claims.boxes import Boxes
from scegen.concretization.boxes import box_of, box_on
from scegen.motion.model import Path
from scegen.motion.standing import object_path
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
            # All along its way: in bends the corners of a body go wide.
            s = np.linspace(0.0, path.length_m, max(2, int(path.length_m / _SAMPLE_M) + 1))
            parts.append(shapely.union_all(outlines(box_on(path, body, s))).buffer(_OFF_THE_WAY_M))
        else:
            parts.append(_standing_on(path, body))
    parts += [_standing_on(object_path(thing), thing.body) for thing in concrete.objects]
    return shapely.union_all(parts)


def _standing_on(path: Path, body: Body) -> shapely.Geometry:
    return outlines(box_of(path.start, body))[0].buffer(_OFF_THE_ROAD_M)


def outlines(boxes: Boxes) -> NDArray[np.object_]:
    """The outlines of boxes, (n,)."""
    along = np.array([1, 1, -1, -1]) * boxes.half_length
    left = np.array([1, -1, -1, 1]) * boxes.half_width
    c, s = boxes.cos[:, None], boxes.sin[:, None]
    x, y = boxes.x[:, None], boxes.y[:, None]
    corners = np.stack((x + along * c - left * s, y + along * s + left * c), axis=-1)
    found: NDArray[np.object_] = shapely.polygons(corners)
    return found


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
