"""Lanes, marks and crosswalks of a road network as point lists (m), ready to be drawn."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import ceil, sqrt

import numpy as np
from numpy.typing import NDArray

from scegen.road.geometry import ReferenceLine
from scegen.road.model import LaneType, Road, RoadNetwork

Array = NDArray[np.float64]
_STRIPE_M = 0.5
_STEP_RAD = 0.08
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


def road_shapes(network: RoadNetwork) -> RoadShapes:
    """The drawable shapes of a network; marks only where roads do not overlap (no junction)."""
    shapes = RoadShapes()
    for road in network.roads:
        poses = _poses(road.line)
        for sign in (1, -1):
            _add_side(shapes, road, poses, sign)
        if road.junction is None:
            _add_middle(shapes, road, poses)
            _add_crosswalks(shapes, road)
    return shapes


def _add_middle(shapes: RoadShapes, road: Road, poses: Array) -> None:
    """The marks where the lanes of each direction begin: one for both, unless a median parts them.

    Where one direction has none, there is an edge; a ring has none on its inside.
    """
    ids = {lane.id for lane in road.lanes if lane.type is LaneType.DRIVING}
    if {1, -1} <= ids:
        kind = shapes.lane_lines if ids == {1, -1} else shapes.centre_lines
        kind.append(_offset(poses, road.lane_offset_m))
    elif road.arm is not None:
        for lane in (side[0] for side in (road.driving(1), road.driving(-1)) if side):
            inner = road.lane_centre_t_m(lane) - (road.lane(lane).width_m / 2) * (
                1 if lane > 0 else -1
            )
            shapes.edge_lines.append(_offset(poses, inner))


def _add_side(shapes: RoadShapes, road: Road, poses: Array, sign: int) -> None:
    lanes = sorted((lane for lane in road.lanes if lane.id * sign > 0), key=lambda n: abs(n.id))
    inner = road.lane_offset_m
    for lane, beyond in zip(lanes, [*lanes[1:], None], strict=False):
        outer = inner + sign * lane.width_m
        edge = _offset(poses, outer)
        outline = np.concatenate((_offset(poses, inner), edge[::-1]))
        shapes.lanes.setdefault(lane.type, []).append(outline)
        if lane.type is LaneType.DRIVING and road.junction is None:
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


def _poses(line: ReferenceLine) -> Array:
    """Points (x, y, heading) along a line, as dense as its bends need."""
    rows = []
    for segment in line.segments:
        k = abs(segment.curvature_1pm)
        step = min(_STEP_RAD, sqrt(8 * _OFF_M * k))
        count = max(1, ceil(k * segment.length_m / step)) if k else 1
        rows += [segment.pose(segment.length_m * i / count) for i in range(count + 1)]
    return np.array([(p.x_m, p.y_m, p.heading_rad) for p in rows])


def _offset(poses: Array, t_m: float) -> Array:
    x, y, heading = poses.T
    return np.column_stack((x - t_m * np.sin(heading), y + t_m * np.cos(heading)))
