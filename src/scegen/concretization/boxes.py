"""Boxes of bodies on their ways, as the claims see them: how far apart, and on which ground.

Things may stand off the carriageway, off everybody's way, clear of what stands there.
"""

from collections.abc import Mapping
from math import hypot

import numpy as np
import shapely

from scegen.claims.boxes import Boxes, around, counting_mps, free, gap_m
from scegen.motion.footprints import swept
from scegen.motion.model import Array, Path
from scegen.motion.standing import object_path
from scegen.road.geometry import Pose
from scegen.road.model import LaneType, Road, RoadNetwork
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.spacings import Measure

_OFF_THE_ROAD_M = 0.2
_OFF_THE_WAY_M = 0.5
_SAMPLE_M = 1.0
_TRAVELLED = frozenset({LaneType.DRIVING, LaneType.PARKING})


def missing_m(
    measure: Measure, value: float, own: tuple[Boxes, Array], other: tuple[Boxes, Array]
) -> Array:
    """How much longer the free length between two is than a measure along the road says (n,), m.

    Both with their boxes and speeds (see ``counting_mps``), the value in its unit.
    """
    gap = gap_m(own[0], other[0])
    return gap - value * (1.0 if measure is Measure.GAP_M else counting_mps(measure, own, other))


def box_at(x_m: Array, y_m: Array, heading_rad: Array, body: Body) -> Boxes:
    """Boxes whose reference points are at places, (n,) or of any one shape."""
    return around(body, x_m, y_m, np.cos(heading_rad), np.sin(heading_rad))


def box_on(path: Path, body: Body, s_m: Array) -> Boxes:
    """Boxes of a body whose reference point is at places of a path, or on its prolongation."""
    x, y, heading = path.places(s_m)
    beyond = np.minimum(s_m, 0.0) + np.maximum(s_m - path.length_m, 0.0)
    return box_at(x + beyond * np.cos(heading), y + beyond * np.sin(heading), heading, body)


def box_of(pose: Pose, body: Body) -> Boxes:
    """The box of a body whose reference point is at a pose, (1,)."""
    x, y, heading = (np.array([v]) for v in (pose.x_m, pose.y_m, pose.heading_rad))
    return box_at(x, y, heading, body)


def apart(a: Boxes, b: Boxes, within_m: float) -> Array:
    """Greatest free distance along an axis of either box; at most 0 where they touch.

    Where it is more than ``within_m`` it is inf.
    """
    reach = hypot(a.half_length, a.half_width) + hypot(b.half_length, b.half_width) + within_m
    dx, dy = b.x - a.x, b.y - a.y
    near = dx * dx + dy * dy <= 2 * reach * reach
    if not near.any():
        return np.full(near.shape, np.inf)
    distance = np.max([*free(a, b), *free(b, a)], axis=0)
    return np.where(distance <= within_m, distance, np.inf)


def overlap(first: Pose, first_body: Body, second: Pose, second_body: Body) -> bool:
    """Whether two bodies overlap on the ground."""
    return bool(apart(box_of(first, first_body), box_of(second, second_body), 0.0)[0] < 0.0)


def taken_ground(
    network: RoadNetwork, concrete: ConcreteScenario, paths: Mapping[str, Path]
) -> shapely.Geometry:
    """All ground on which nothing may stand."""
    parts = [_carriageway(road).buffer(_OFF_THE_ROAD_M) for road in network.roads]
    standing = [(object_path(thing), thing.body) for thing in concrete.objects]
    for path, body in [*((paths[p.id], p.body) for p in concrete.participants), *standing]:
        # All along its way: in bends the corners of a body go wide.
        s = np.linspace(0.0, path.length_m, int(path.length_m / _SAMPLE_M) + 1)
        away_m = _OFF_THE_WAY_M if len(path.s_m) > 1 else _OFF_THE_ROAD_M
        parts.append(swept(path, body, s).buffer(away_m))
    return shapely.union_all(parts)


def _carriageway(road: Road) -> shapely.Geometry:
    """What is driven or parked on of a road."""
    lanes = [lane for lane in road.lanes if lane.type in _TRAVELLED]
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
