"""The roads of one drive in order, and where on them the vehicle changes lanes.

Stations ``u`` are positions along the drive as in the scenario files: metres along the centre
of the lane in which the vehicle enters each road, counted from the outer end of the entry arm.
``d`` is the offset from a road's reference line to the driver's left (m).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from scegen.motion.model import Array
from scegen.road.model import Road


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

    def with_shift(self, shift: Shift, lane: int) -> Stretch:
        """The stretch with one more shift, which leads into lane id ``lane``."""
        middle = shift.u_m + shift.length_m / 2
        return replace(
            self,
            shifts=(*self.shifts, shift),
            lane_after=(*self.lane_after, (middle, lane)),
        )

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
