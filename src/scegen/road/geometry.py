"""Reference lines of lines and arcs: the only curves that every simulator places alike.

Frame: x east, y north, headings in radians counter-clockwise from east; s in metres along the
line, t in metres to its left.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Pose:
    """A position (m) and heading (rad)."""

    x_m: float
    y_m: float
    heading_rad: float

    def shifted(self, forward_m: float = 0.0, left_m: float = 0.0) -> Pose:
        """The pose moved in its own frame, heading kept."""
        c, s = cos(self.heading_rad), sin(self.heading_rad)
        return Pose(
            self.x_m + forward_m * c - left_m * s,
            self.y_m + forward_m * s + left_m * c,
            self.heading_rad,
        )

    def reversed(self) -> Pose:
        """The same place, looking back."""
        return Pose(self.x_m, self.y_m, self.heading_rad + np.pi)


@dataclass(frozen=True, slots=True)
class Segment:
    """A line (``curvature_1pm == 0``) or an arc (left-turning where positive)."""

    start: Pose
    length_m: float
    curvature_1pm: float = 0.0

    def pose(self, s_m: float) -> Pose:
        """The pose at arc length ``s_m`` from the start of the segment."""
        k, h = self.curvature_1pm, self.start.heading_rad
        if k == 0.0:
            return self.start.shifted(forward_m=s_m)
        end = h + k * s_m
        return Pose(
            self.start.x_m + (sin(end) - sin(h)) / k,
            self.start.y_m - (cos(end) - cos(h)) / k,
            end,
        )

    @property
    def end(self) -> Pose:
        """The pose at the end."""
        return self.pose(self.length_m)


@dataclass(frozen=True, slots=True)
class ReferenceLine:
    """Segments joined end to start without a step in position or heading."""

    segments: tuple[Segment, ...]

    @property
    def length_m(self) -> float:
        """Total arc length."""
        return sum(segment.length_m for segment in self.segments)

    @property
    def start(self) -> Pose:
        """The pose at s = 0."""
        return self.segments[0].start

    @property
    def end(self) -> Pose:
        """The pose at s = length."""
        return self.segments[-1].end

    def reversed(self) -> ReferenceLine:
        """The same line, run through from its end."""
        back = (
            Segment(x.end.reversed(), x.length_m, -x.curvature_1pm) for x in self.segments[::-1]
        )
        return ReferenceLine(tuple(back))

    def pose(self, s_m: float, t_m: float = 0.0) -> Pose:
        """The pose at (s, t), heading along the line; s beyond either end is extrapolated."""
        rest = s_m
        for segment in self.segments[:-1]:
            if rest < segment.length_m:
                return segment.pose(rest).shifted(left_m=t_m)
            rest -= segment.length_m
        return self.segments[-1].pose(rest).shifted(left_m=t_m)
