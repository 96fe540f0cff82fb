"""Lanes, marks and crosswalks of a road network as point lists (m), ready to be drawn."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import ceil, copysign, sqrt

import numpy as np
import shapely

from scegen.motion.model import Array, Path
from scegen.road.geometry import Pose, ReferenceLine
from scegen.road.model import LaneType, Road, RoadNetwork
from scegen.road.sections import Section, sections
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.reversing import BacksOut

_STRIPE_M = 0.5
_ROOM_M = 0.4
_STEP_RAD = 0.08
_TAPER_M = 4.0
_OFF_M = 0.02
"""A chord is no farther from its arc than this."""


@dataclass
class RoadShapes:
    """Polygons of lanes by type, and lines by kind, each an array of points (n, 2).

    ``centre_lines`` and ``edge_lines`` are solid, ``lane_lines`` broken: those between lanes, and
    the middle of a road with one lane each way, as the written road has them.
    """

    lanes: dict[LaneType, list[Array]] = field(default_factory=dict)
    centre_lines: list[Array] = field(default_factory=list)
    edge_lines: list[Array] = field(default_factory=list)
    lane_lines: list[Array] = field(default_factory=list)
    stripes: list[Array] = field(default_factory=list)


def bays(concrete: ConcreteScenario, paths: Mapping[str, Path]) -> list[Array]:
    """Where somebody stands beside the road before it backs out: outlines up to the lanes."""
    found = []
    for who in concrete.participants:
        reversal = who.motion.reversal if isinstance(who.motion, DriveMotion) else None
        if isinstance(reversal, BacksOut) and reversal.side is not None:
            path, ahead_m = paths[who.id], who.body.front_m + _ROOM_M
            side_m = who.body.width_m / 2 + _ROOM_M
            corners = [(ahead_m, side_m), (ahead_m, -side_m),
                       (-reversal.setback_m, -side_m), (-reversal.setback_m, side_m)]  # fmt: skip
            at = Pose(path.x_m[0], path.y_m[0], path.heading_rad[0])
            poses = [at.shifted(forward_m=x, left_m=y) for x, y in corners]
            found.append(np.array([(p.x_m, p.y_m) for p in poses]))
    return found


def road_shapes(network: RoadNetwork, bays: Sequence[Array] = ()) -> RoadShapes:
    """The drawable shapes of a network; marks only where roads do not overlap (no crossing)."""
    shapes = RoadShapes(lanes={LaneType.PARKING: list(bays)} if bays else {})
    for road in network.roads:
        for part in sections(road):
            seen = replace(road, lanes=part.lanes)
            places = _places(road, part)
            poses = _poses(road.line, places)
            for sign in (1, -1):
                _add_side(shapes, seen, places, poses, sign)
        if road.junction is None or road.goes_on:
            _add_middle(shapes, road, _poses(road.line, _places(road)))
            _add_crosswalks(shapes, road)
    if len(network.junctions) == 1 and not network.plain:
        _pave(shapes)
    return shapes


def _pave(shapes: RoadShapes) -> None:
    """What the ways through a crossing lie around is paved too; in a roundabout it is an island."""
    ways = [shapely.make_valid(shapely.Polygon(p)) for p in shapes.lanes[LaneType.DRIVING]]
    paved = shapely.union_all(shapely.buffer(ways, _OFF_M))
    rings = [ring for part in shapely.get_parts(paved) for ring in part.interiors]
    shapes.lanes[LaneType.DRIVING] += [np.asarray(ring.coords) for ring in rings]


def _add_middle(shapes: RoadShapes, road: Road, poses: Array) -> None:
    """The marks where the lanes of each direction begin: one for both, unless a median parts them.

    Where one direction has none, there is an edge; a ring has none on its inside.
    """
    every = {lane.id for lane in road.lanes}
    ids = {lane.id for lane in road.lanes if lane.type is LaneType.DRIVING}
    if {1, -1} <= ids:
        kind = shapes.lane_lines if ids == {1, -1} else shapes.centre_lines
        kind.append(_offset(poses, road.lane_offset_m))
    elif road.arm is not None or road.goes_on or len({lane > 0 for lane in every}) > 1:
        for lane in (side[0] for side in (road.driving(1), road.driving(-1)) if side):
            inner = road.lane_centre_t_m(lane) - copysign(road.lane(lane).width_m / 2, lane)
            shapes.edge_lines.append(_offset(poses, inner))


def _add_side(shapes: RoadShapes, road: Road, places: Array, poses: Array, sign: int) -> None:
    lanes = sorted((lane for lane in road.lanes if lane.id * sign > 0), key=lambda n: abs(n.id))
    inner = np.full(len(places), road.lane_offset_m)
    for lane, beyond in zip(lanes, [*lanes[1:], None], strict=False):
        outer = inner + sign * np.array([lane.width_at_m(float(s)) for s in places])
        edge = _offset(poses, outer)
        outline = np.concatenate((_offset(poses, inner), edge[::-1]))
        shapes.lanes.setdefault(lane.type, []).append(outline)
        if lane.type is LaneType.DRIVING and (road.junction is None or road.goes_on):
            goes_on = beyond is not None and beyond.type is LaneType.DRIVING
            (shapes.lane_lines if goes_on else shapes.edge_lines).append(edge)
        inner = outer


def _add_crosswalks(shapes: RoadShapes, road: Road) -> None:
    for crosswalk in road.crosswalks:
        low, high = (crosswalk.s_m + k * crosswalk.width_m / 2 for k in (-1, 1))
        count = max(1, int((crosswalk.t_max_m - crosswalk.t_min_m) / (2 * _STRIPE_M)))
        for t in np.linspace(crosswalk.t_min_m, crosswalk.t_max_m, count + 1)[:-1] + _STRIPE_M / 2:
            corners = [(low, t), (high, t), (high, t + _STRIPE_M), (low, t + _STRIPE_M)]
            poses = [road.line.pose(s, at) for s, at in corners]
            shapes.stripes.append(np.array([(p.x_m, p.y_m) for p in poses]))


def _places(road: Road, part: Section | None = None) -> Array:
    """Places along a road, or a section of it, as dense as its bends and tapers need."""
    low, high = (0.0, road.length_m) if part is None else (part.from_m, part.to_m)
    found, begins = {low, high}, 0.0
    for segment in road.line.segments:
        k = abs(segment.curvature_1pm)
        step = min(_STEP_RAD, sqrt(8 * _OFF_M * k))
        count = max(1, ceil(k * segment.length_m / step)) if k else 1
        found |= {begins + segment.length_m * i / count for i in range(count + 1)}
        begins += segment.length_m
    for extent in (lane.extent for lane in (part.lanes if part else ()) if lane.extent):
        for at, length in (
            (extent.from_m, extent.opens_m),
            (extent.to_m - extent.closes_m, extent.closes_m),
        ):
            count = ceil(length / _TAPER_M)
            found |= {at + length * i / max(count, 1) for i in range(count + 1)}
    return np.array(sorted(s for s in found if low <= s <= high))


def _poses(line: ReferenceLine, places: Array) -> Array:
    """Points (x, y, heading) of a line at places along it."""
    poses = [line.pose(float(s)) for s in places]
    return np.array([(p.x_m, p.y_m, p.heading_rad) for p in poses])


def _offset(poses: Array, t_m: float | Array) -> Array:
    x, y, heading = poses.T
    return np.column_stack((x - t_m * np.sin(heading), y + t_m * np.cos(heading)))
