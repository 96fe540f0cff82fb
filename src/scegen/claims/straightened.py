"""Movements on a road that bends, told as on a straight one: along the ego's lane, and beside it.

What is said of a road (ahead, behind, in the lane beside, so far in front) is said along it. Claims
therefore look at places in the frame of the road; contact and lines of sight stay where they are. A
ramp is told as if its lane lay beside the others all the way.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from scegen.motion.batch.arrays import COS, HEADING, SIN, Floats, X, Y
from scegen.motion.lanes import arm_lane_id
from scegen.road import build_network
from scegen.road.geometry import ReferenceLine, Segment
from scegen.road.ramps import gore_m
from scegen.road.straight import curve_of
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.vocabulary import JunctionKind

_ON_RAMP_M = 2.5
"""Nearer than this to the middle of a ramp's lane, somebody is on the ramp."""


@dataclass(frozen=True, slots=True)
class Ramp:
    """A ramp's lane in the direction of its traffic, which lies ``aside_m`` left of the axis.

    That is where it goes on along the road; it begins ``begins_m`` along the axis.
    """

    line: ReferenceLine
    begins_m: float
    aside_m: float


@dataclass(frozen=True, slots=True)
class Axis:
    """A road's centre line from arm 0 to arm 1; lengths are those ``beside_m`` to its left.

    ``joint`` is the number of its first segment that belongs to arm 1.
    """

    line: ReferenceLine
    beside_m: float
    joint: int = 1
    ramp: Ramp | None = None

    def length_m(self, segment: Segment) -> float:
        """Length of a piece of the lane."""
        return segment.length_m * (1.0 - segment.curvature_1pm * self.beside_m)

    def half_m(self, arm: int) -> float:
        """Length of the part of an arm."""
        own = self.line.segments[: self.joint] if arm == 0 else self.line.segments[self.joint :]
        return sum(self.length_m(segment) for segment in own)


def axis_of(concrete: ConcreteScenario) -> Axis | None:
    """The axis along the ego's first lane; None where the road is straight or has a junction."""
    road = concrete.road
    if gore_m(road):
        return _beside_ramp(road)
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
    joint = len(first.line.segments)
    built = network.arm_road(arm)
    beside = built.lane_centre_t_m(arm_lane_id(built, number, inbound=True)) if number else 0.0
    return Axis(line, beside if arm == 0 else -beside, joint)


@lru_cache(maxsize=64)
def _beside_ramp(road: RoadParameters) -> Axis:
    """The straight axis of a road with a ramp, its joint where the ramp's lane meets the others."""
    network = build_network(road)
    route = next(r for r in network.routes[0, 1] if r.entry_lane > road.arms[0].lanes_in)
    arms = [step for step in route.steps if network.road(step.road).arm is not None]
    ramp = [network.road(step.road) for step in route.steps if step not in arms]
    lane = network.arm_road(arms[0].road - 1)
    aside = lane.lane_centre_t_m(arms[0].lane) * (1 if arms[0].forward else -1)
    joins = network.road(route.steps[0].road).arm is None
    begin = network.arm_road(0).line.start
    halves = [network.arm_road(0).length_m, network.arm_road(1).length_m]
    halves[0 if joins else 1] += gore_m(road)
    first = Segment(begin, halves[0])
    line = ReferenceLine((first, Segment(first.end, halves[1])))
    way = ReferenceLine(tuple(segment for piece in ramp for segment in piece.line.segments))
    begins = halves[0] - way.length_m if joins else halves[0]
    return Axis(line, 0.0, 1, Ramp(way, begins, aside))


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
    if axis.ramp is not None:
        along, aside, turned = _on_ramp(axis.ramp, (x, y, heading), (along, aside, turned))
    told = tracks.copy()
    told[:, :, X], told[:, :, Y], told[:, :, HEADING] = along, aside, turned
    told[:, :, COS], told[:, :, SIN] = np.cos(turned), np.sin(turned)
    return told


def _on_ramp(
    ramp: Ramp, places: tuple[Floats, Floats, Floats], told: tuple[Floats, Floats, Floats]
) -> tuple[Floats, Floats, Floats]:
    """Those who are on the ramp, told along its lane; all others as they are told."""
    x, y, heading = places
    along, aside, turned = told
    begins, last = ramp.begins_m, len(ramp.line.segments) - 1
    for number, segment in enumerate(ramp.line.segments):
        u, t = _seen_from(segment, x, y)
        before = -np.inf if number == 0 and ramp.begins_m <= 0.0 else 0.0
        beyond = np.inf if number == last and ramp.begins_m > 0.0 else segment.length_m
        there = (u >= before) & (u <= beyond) & (np.abs(t) < _ON_RAMP_M)
        along = np.where(there, begins + u, along)
        aside = np.where(there, ramp.aside_m + t, aside)
        road = segment.start.heading_rad + segment.curvature_1pm * u
        turned = np.where(there, heading - road, turned)
        begins += segment.length_m
    return along, aside, turned


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
