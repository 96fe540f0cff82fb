"""Movements on a road that bends, told as on a straight one: along the ego's lane, and beside it.

What is said of a road (ahead, behind, in the lane beside, so far in front) is said along it. Claims
therefore look at places in the frame of the road; contact and lines of sight stay where they are.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from scegen.motion.batch.arrays import COS, HEADING, SIN, Floats, X, Y
from scegen.motion.lanes import arm_lane_id
from scegen.road import build_network
from scegen.road.geometry import ReferenceLine, Segment
from scegen.road.straight import curve_of
from scegen.scenario.concrete import ConcreteScenario, DriveMotion, RoadParameters
from scegen.scenario.vocabulary import JunctionKind


@dataclass(frozen=True, slots=True)
class Axis:
    """A road's centre line from arm 0 to arm 1; lengths are those ``beside_m`` to its left."""

    line: ReferenceLine
    beside_m: float

    def length_m(self, segment: Segment) -> float:
        """Length of a piece of the lane."""
        return segment.length_m * (1.0 - segment.curvature_1pm * self.beside_m)


def axis_of(concrete: ConcreteScenario) -> Axis | None:
    """The axis along the ego's first lane; None where the road is straight or has a junction."""
    road = concrete.road
    if road.kind is not JunctionKind.STRAIGHT or road.u_turns or curve_of(road) is None:
        return None
    motion = concrete.ego.motion
    if not isinstance(motion, DriveMotion):
        return _axis(road, 0, 1)
    return _axis(
        road, motion.entry, max(1, min(motion.entry_lane, road.arms[motion.entry].lanes_in))
    )


@lru_cache(maxsize=64)
def _axis(road: RoadParameters, arm: int, number: int) -> Axis:
    network = build_network(road)
    first, second = network.arm_road(0), network.arm_road(1)
    line = ReferenceLine((*first.line.segments, *second.line.reversed().segments))
    built = network.arm_road(arm)
    beside = built.lane_centre_t_m(arm_lane_id(built, number, inbound=True)) if number else 0.0
    return Axis(line, beside if arm == 0 else -beside)


def straightened(axis: Axis, tracks: Floats) -> Floats:
    """Tracks (c, i, row, t) with places (x along the lane, y left of the centre line), headings."""
    x, y, heading = tracks[:, :, X], tracks[:, :, Y], tracks[:, :, HEADING]
    best = np.full(x.shape, np.inf)
    along, aside, turned = np.empty_like(x), np.empty_like(x), np.empty_like(x)
    begins, last = 0.0, len(axis.line.segments) - 1
    for number, segment in enumerate(axis.line.segments):
        u, t = _seen_from(segment, x, y)
        before = np.inf if number == 0 else 0.0
        beyond = np.inf if number == last else segment.length_m
        away = np.hypot(np.maximum(np.maximum(-u - before, u - beyond), 0.0), t)
        nearer = away < best
        best = np.where(nearer, away, best)
        scale = axis.length_m(segment) / segment.length_m
        along = np.where(nearer, begins + scale * u, along)
        aside = np.where(nearer, t, aside)
        road = segment.start.heading_rad + segment.curvature_1pm * u
        turned = np.where(nearer, heading - road, turned)
        begins += axis.length_m(segment)
    told = tracks.copy()
    told[:, :, X], told[:, :, Y], told[:, :, HEADING] = along, aside, turned
    told[:, :, COS], told[:, :, SIN] = np.cos(turned), np.sin(turned)
    return told


def _seen_from(segment: Segment, x: Floats, y: Floats) -> tuple[Floats, Floats]:
    """How far along a line or arc, and how far to its left (m)."""
    start, k = segment.start, segment.curvature_1pm
    c, s = np.cos(start.heading_rad), np.sin(start.heading_rad)
    dx, dy = x - start.x_m, y - start.y_m
    ahead, left = dx * c + dy * s, dy * c - dx * s
    if k == 0.0:
        return ahead, left
    # Seen from the centre, which lies 1/k to the left.
    sign = 1.0 if k > 0 else -1.0
    angle = np.arctan2(ahead, sign * (1.0 / k - left))
    radius = np.hypot(ahead, left - 1.0 / k)
    return angle / abs(k), 1.0 / k - sign * radius
