"""Where on the road somebody is: how far along which arm, and in which of its lanes."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import cos, pi, sin
from typing import NamedTuple

import numpy as np

from scegen.claims.boxes import Boxes, boxes
from scegen.claims.series import first
from scegen.claims.straightened import Axis, axis_of
from scegen.claims.view import View
from scegen.motion.batch.arrays import Bools, Floats, Ints
from scegen.motion.batch.kernels import inner_kernel
from scegen.road import build_network
from scegen.road.cross_section import CROSSWALK_MIDDLE_M, median_half_m
from scegen.road.geometry import Pose
from scegen.road.model import LaneType, Road
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.vocabulary import DrivingSide


class Line(NamedTuple):
    """An arm: where it begins and heads, how long it is straight, and its edges."""

    x: float
    y: float
    cos: float
    sin: float
    length: float
    right: float
    left: float


@inner_kernel
def place_on(line: Line, x: float, y: float) -> tuple[float, float]:
    """How far along a line from its beginning, and how far to its left (m)."""
    dx, dy = x - line.x, y - line.y
    return dx * line.cos + dy * line.sin, dy * line.cos - dx * line.sin


@dataclass(frozen=True, slots=True)
class Arm:
    """An arm of a road, from its outer end inwards: straight, or a bend behind ``straight_m``.

    ``inner_m`` is where its lanes begin beside the centre line: behind half a median.
    ``inward`` is the side of the traffic towards the junction, as a sign of the offset to the left
    of the centre line; ``edges_m`` are the offsets of the carriageway's right and left edge,
    ``strips`` how far from the centre line those beside the lanes begin and end, by type;
    ``crosswalk_m`` is where the middle of its crosswalk lies, None if it has none.
    """

    x_m: float
    y_m: float
    cos: float
    sin: float
    length_m: float
    straight_m: float
    lane_width_m: float
    inner_m: float
    inward: int
    edges_m: tuple[float, float]
    strips: Mapping[LaneType, tuple[float, float]]
    crosswalk_m: float | None

    def place(self, box: Boxes) -> tuple[Floats, Floats]:
        """How far from the outer end, and how far to the left of the centre line (m)."""
        dx, dy = box.x - self.x_m, box.y - self.y_m
        return dx * self.cos + dy * self.sin, dy * self.cos - dx * self.sin

    def comes_to(self, view: View, name: str, along_m: Floats | float) -> Ints:
        """The first step in which somebody's centre is farther than that from the outer end (c,).

        All steps where it never is.
        """
        return first(self.place(boxes(view, name))[0] > np.full(view.count, along_m)[:, None])

    @property
    def line(self) -> Line:
        """The same for kernels."""
        return Line(self.x_m, self.y_m, self.cos, self.sin, self.straight_m, *self.edges_m)

    def on_it(self, box: Boxes) -> Bools:
        """Whether its centre is between the edges of the carriageway."""
        offset = (box.y - self.y_m) * self.cos - (box.x - self.x_m) * self.sin
        return (offset > self.edges_m[0]) & (offset < self.edges_m[1])

    def facing(self, box: Boxes) -> Floats:
        """1 where it heads straight towards the junction, -1 straight away from it."""
        return box.cos * self.cos + box.sin * self.sin

    def lane_in_m(self, number: int) -> float:
        """Offset of the middle of a lane that leads in, to the left of the centre line; from 1."""
        return self.inward * (self.inner_m + (number - 0.5) * self.lane_width_m)


def arms_of(view: View) -> tuple[Arm, ...]:
    """The arms of the road that a view is on."""
    return view.once("arms", lambda: _built(view.concrete.road, axis_of(view.concrete)))


@lru_cache(maxsize=64)
def _built(road: RoadParameters, axis: Axis | None) -> tuple[Arm, ...]:
    network = build_network(road)
    inward = -1 if road.driving_side is DrivingSide.RIGHT else 1
    made = []
    for described in road.arms:
        built = network.arm_road(described.id)
        outer, length, straight = built.line.start, built.length_m, built.line.segments[0].length_m
        if axis is not None:
            length = straight = axis.half_m(described.id)
            whole = axis.half_m(0) + axis.half_m(1)
            outer = Pose(0.0, 0.0, 0.0) if described.id == 0 else Pose(whole, 0.0, pi)
        made.append(
            Arm(
                outer.x_m,
                outer.y_m,
                cos(outer.heading_rad),
                sin(outer.heading_rad),
                length,
                straight,
                described.lane_width_m,
                median_half_m(road.carriageway),
                inward,
                (built.edge_t_m(-1, 0.0), built.edge_t_m(1, 0.0)),
                _strips(built, inward if described.lanes_in else -inward),
                length - CROSSWALK_MIDDLE_M if built.crosswalks else None,
            )
        )
    return tuple(made)


def _strips(road: Road, sign: int) -> dict[LaneType, tuple[float, float]]:
    """Where the strips on one side of a road begin and end, from the centre line (m)."""
    found: dict[LaneType, tuple[float, float]] = {}
    for lane in road.lanes:
        if lane.id * sign > 0 and lane.type is not LaneType.DRIVING:
            middle = abs(road.lane_centre_t_m(lane.id))
            found[lane.type] = (middle - lane.width_m / 2, middle + lane.width_m / 2)
    return found
