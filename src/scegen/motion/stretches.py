"""The roads of one drive in order, and where on them the vehicle changes lanes.

Stations ``u`` are positions along the drive as in the scenario files: metres along the centre
of the lane in which the vehicle enters each road, counted from the outer end of the entry arm.
``d`` is the offset from a road's reference line to the driver's left (m).
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from scegen.errors import MotionInfeasibleError
from scegen.motion.model import Array
from scegen.road.model import Road, RoadNetwork, RouteStep
from scegen.scenario.concrete import DriveMotion

ROUNDING_M = 1e-6


@dataclass(frozen=True, slots=True)
class Shift:
    """A smooth sideways move from offset ``from_d_m`` to ``to_d_m`` over ``length_m`` from ``u_m``.

    Follows half a cosine, d = from + (to - from)(1 - cos(pi p))/2, the ``sinusoidal`` shape of
    OpenSCENARIO's lane changes: heading is continuous, sideways speed ends at zero.
    """

    u_m: float
    length_m: float
    from_d_m: float
    to_d_m: float

    @property
    def end_m(self) -> float:
        """Station at which the new offset is reached."""
        return self.u_m + self.length_m

    def offset_and_slope(self, stations_m: Array) -> tuple[Array, Array]:
        """What the shift adds to the offset (m), and its slope dd/du, at each station."""
        progress = np.clip((stations_m - self.u_m) / self.length_m, 0.0, 1.0)
        width = self.to_d_m - self.from_d_m
        added = width * 0.5 * (1.0 - np.cos(np.pi * progress))
        slope = width * 0.5 * np.pi / self.length_m * np.sin(np.pi * progress)
        return added, slope


@dataclass(frozen=True, slots=True)
class Stretch:
    """One road of a drive, travelled from station ``start_m`` to ``end_m``.

    ``lane`` is the OpenDRIVE id of the lane at its start; ``lane_after`` maps the station in the
    middle of each shift on it to the lane id from there on.
    """

    road: Road
    forward: bool
    lane: int
    start_m: float
    end_m: float
    d_m: float
    shifts: tuple[Shift, ...] = ()
    lane_after: tuple[tuple[float, int], ...] = ()

    @property
    def scale(self) -> float:
        """Station metres per metre of the reference line."""
        return (self.end_m - self.start_m) / self.road.length_m

    def lanes(self) -> list[tuple[float, float, int]]:
        """(from, to, lane id) by station; a change counts from its middle."""
        cuts = [self.start_m, *(u for u, _ in self.lane_after), self.end_m]
        ids = [self.lane, *(lane for _, lane in self.lane_after)]
        spans = zip(cuts[:-1], cuts[1:], ids, strict=True)
        return [(max(a, self.start_m), min(b, self.end_m), lane) for a, b, lane in spans]


def lane_offset_d_m(road: Road, lane: int, *, forward: bool) -> float:
    """Offset of a lane's centre to the left of one who drives along (or against) the road."""
    t = road.lane_centre_t_m(lane)
    return t if forward else -t


def lane_length_m(road: Road, lane: int) -> float:
    """Length of a lane's centre line: inner lanes of a bend are shorter than outer ones."""
    t = road.lane_centre_t_m(lane)
    return sum(seg.length_m * (1.0 - seg.curvature_1pm * t) for seg in road.line.segments)


def stretch(road: Road, lane: int, start_m: float, *, forward: bool) -> Stretch:
    """A road entered in lane id ``lane`` at station ``start_m``."""
    d = lane_offset_d_m(road, lane, forward=forward)
    return Stretch(road, forward, lane, start_m, start_m + lane_length_m(road, lane), d)


class Walk:
    """A drive while it is laid out road by road; ``lane`` and ``offset_m`` are where it is by now.

    ``todo`` are the changes of lane that are not over yet; ``moved`` are (from, to, road id, the
    ids of both lanes) of those begun, once a road.
    """

    def __init__(self, network: RoadNetwork, motion: DriveMotion, who: str) -> None:
        self.network, self.motion, self.who = network, motion, who
        self.lane, self.offset_m = motion.entry_lane, motion.offset_m
        self.todo = list(motion.lane_changes)
        self.moved: list[tuple[float, float, int, tuple[int, int]]] = []
        self.done: list[Stretch] = []

    @property
    def end_m(self) -> float:
        """How far it is laid out."""
        return self.done[-1].end_m if self.done else 0.0

    def refused(self, message: str) -> MotionInfeasibleError:
        """What is wrong with a change of lane."""
        return MotionInfeasibleError(
            message, where=self.who, hint="Move or shorten the change of lane, or leave it out."
        )

    def lay(self, step: Callable[[int], RouteStep]) -> None:
        """One more road, with all changes that run on it; ``step`` tells it by the lane's number.

        Raises:
            MotionInfeasibleError: a change leads to another road.
        """
        begins = self.end_m
        begun = [c for c in self.todo if c.position_m < begins - ROUNDING_M]
        after = [c for c in begun if c.position_m + c.length_m / 2 < begins - ROUNDING_M]
        way = step(begun[0].lane_after if begun else self.lane)
        lane = step(after[0].lane_after if after else self.lane).lane
        road = self.network.road(way.road)
        piece = stretch(road, way.lane, begins, forward=way.forward)
        shifts, lanes = list[Shift](), list[tuple[float, int]]()
        while self.todo and self.todo[0].position_m < piece.end_m - ROUNDING_M:
            change = self.todo[0]
            from_m, over_m = change.position_m, change.length_m
            sides = step(self.lane), step(change.lane_after)
            if any(side.road != road.id for side in sides):
                raise self.refused(
                    f"the lane change from {from_m:.1f} to {from_m + over_m:.1f} m runs on the "
                    f"ramp or where it parts from the road ({road.name})"
                )
            numbers = sides[0].lane, sides[1].lane
            self.moved.append((from_m, from_m + over_m, road.id, numbers))
            out, into = (lane_offset_d_m(road, n, forward=way.forward) for n in numbers)
            shifts.append(Shift(from_m, over_m, out + self.offset_m, into + change.offset_m))
            if begins < from_m + over_m / 2 < piece.end_m:
                lanes.append((from_m + over_m / 2, numbers[1]))
            if from_m + over_m > piece.end_m + ROUNDING_M:
                break
            self.todo.pop(0)
            self.lane, self.offset_m = change.lane_after, change.offset_m
        d = shifts[0].from_d_m if shifts else piece.d_m + self.offset_m
        self.done.append(
            replace(piece, lane=lane, d_m=d, shifts=tuple(shifts), lane_after=tuple(lanes))
        )
