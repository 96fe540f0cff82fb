"""Stretches to polyline: where a drive's vertices lie and which way they point."""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import ceil, hypot

import numpy as np

from scegen.errors import MotionInfeasibleError
from scegen.motion.model import Array, LaneSpan, Path
from scegen.motion.stretches import Stretch
from scegen.road.geometry import Segment

LINE_STEP_M = 4.0
CURVE_STEP_M = 0.25
"""Vertex spacing on lines, and in arcs and lane changes: esmini is then off by 0.12 cm."""
JOINT_GAP_M = 0.02
_SAME_M = 1e-6
_APART_M = 0.01
"""Vertices closer than this are one."""


@dataclass(frozen=True)
class LaidDrive:
    """A drive laid out on the road.

    ``stations_m`` are the positions along the drive (as in the scenario files) of the path's
    vertices; ``stretches`` its roads, the first its entry arm, the last its exit arm. Stations
    fall where it reverses, and stay the same while it backs out.
    """

    path: Path
    stations_m: Array
    stretches: tuple[Stretch, ...]

    @property
    def turning_starts_m(self) -> float:
        """Station of the inner end of the entry arm."""
        return self.stretches[0].end_m

    @property
    def turning_ends_m(self) -> float:
        """Station of the inner end of the exit arm."""
        return self.stretches[-1].start_m

    @cached_property
    def bends(self) -> tuple[tuple[float, float, float], ...]:
        """Where along the path each arc of the way begins and ends, and the radius driven, m."""
        found = []
        for piece in self.stretches:
            at = piece.start_m
            segments = piece.road.line.segments
            for segment in segments if piece.forward else reversed(segments):
                after = at + segment.length_m * piece.scale
                if segment.curvature_1pm:
                    bend = segment.curvature_1pm * (1 if piece.forward else -1)
                    radius_m = abs(1.0 / bend - piece.d_m)
                    found.append((self.path_s_m(at), self.path_s_m(after), radius_m))
                at = after
        return tuple(found)

    def path_s_m(self, station_m: float) -> float:
        """Arc length along the path where a station is first reached."""
        if not self.path.backwards:
            return float(np.interp(station_m, self.stations_m, self.path.s_m))
        after = int(np.searchsorted(np.maximum.accumulate(self.stations_m), station_m))
        here = slice(max(0, after - 1), after + 1)
        return float(np.interp(station_m, self.stations_m[here], self.path.s_m[here]))

    def station_m(self, path_s_m: float) -> float:
        """Station at an arc length along the path."""
        return float(np.interp(path_s_m, self.path.s_m, self.stations_m))


def passed_m(x_m: Array, y_m: Array) -> Array:
    """How far along a line its vertices are."""
    return np.concatenate(([0.0], np.cumsum(np.hypot(np.diff(x_m), np.diff(y_m)))))


def lay_polyline(stretches: tuple[Stretch, ...], start_m: float, end_m: float) -> LaidDrive:
    """The polyline of a drive between two stations.

    Raises:
        MotionInfeasibleError: two roads of the way do not meet.
    """
    parts: list[tuple[Array, ...]] = []
    for piece in stretches:
        for part in _segments(piece, start_m, end_m):
            if parts:
                (x0, y0), (x1, y1) = (float(c[-1]) for c in parts[-1][1:3]), part[1:3]
                if hypot(x1[0] - x0, y1[0] - y0) > JOINT_GAP_M:
                    raise MotionInfeasibleError(
                        f"{piece.road.name} does not start where the way so far ends, "
                        f"({x0:.2f}, {y0:.2f})"
                    )
            # The first vertex is the last one of the part before.
            parts.append(tuple(column[1:] for column in part) if parts else part)
    stations, x, y, heading = (np.concatenate(column) for column in zip(*parts, strict=True))
    s = passed_m(x, y)
    spans = _spans(stretches, stations, s)
    return LaidDrive(Path(s, x, y, np.unwrap(heading), spans), stations, stretches)


def _segments(
    piece: Stretch, start_m: float, end_m: float
) -> list[tuple[Array, Array, Array, Array]]:
    """(stations, x, y, heading) of each line or arc of a stretch, within [start, end]."""
    segments = piece.road.line.segments
    ordered = segments if piece.forward else tuple(reversed(segments))
    result = []
    at = piece.start_m
    for segment in ordered:
        after = at + segment.length_m * piece.scale
        low, high = max(at, start_m), min(after, end_m)
        if high - low > _SAME_M:
            stations = _stations(piece, segment, low, high)
            result.append((stations, *_place(piece, segment, stations, at)))
        at = after
    return result


def _stations(piece: Stretch, segment: Segment, low: float, high: float) -> Array:
    """Vertices between two stations: dense in arcs and shifts, exact where they begin and end."""
    marks = {low, high}
    for shift in piece.shifts:
        marks |= {m for m in (shift.u_m, shift.end_m) if low + _APART_M < m < high - _APART_M}
    cuts = sorted(marks)
    parts = []
    for a, b in pairwise(cuts):
        middle = (a + b) / 2
        curved = segment.curvature_1pm != 0.0 or any(
            shift.u_m < middle < shift.end_m for shift in piece.shifts
        )
        count = max(1, ceil((b - a) / (CURVE_STEP_M if curved else LINE_STEP_M)))
        parts.append(a + np.arange(count) * ((b - a) / count))
    return np.concatenate((*parts, [high]))


def _place(
    piece: Stretch, segment: Segment, stations: Array, begins_m: float
) -> tuple[Array, Array, Array]:
    """x, y and heading at stations of one segment, which is entered at ``begins_m``."""
    travelled = (stations - begins_m) / piece.scale
    s = travelled if piece.forward else segment.length_m - travelled
    k, h0 = segment.curvature_1pm, segment.start.heading_rad
    along = h0 + k * s
    if k == 0.0:
        x = segment.start.x_m + s * np.cos(h0)
        y = segment.start.y_m + s * np.sin(h0)
    else:
        x = segment.start.x_m + (np.sin(along) - np.sin(h0)) / k
        y = segment.start.y_m - (np.cos(along) - np.cos(h0)) / k
    direction, bend = (along, k) if piece.forward else (along + np.pi, -k)
    offset, slope = offsets(piece, stations)
    # Per metre of reference line, the vehicle gains slope*scale sideways and 1 - k*d ahead.
    heading = direction + np.arctan2(slope * piece.scale, 1.0 - bend * offset)
    return x - offset * np.sin(direction), y + offset * np.cos(direction), heading


def offsets(piece: Stretch, stations: Array) -> tuple[Array, Array]:
    """Offset to the driver's left of the reference line (m) and its slope per station metre."""
    offset = np.full_like(stations, piece.d_m)
    slope = np.zeros_like(stations)
    for shift in piece.shifts:
        added, rise = shift.offset_and_slope(stations)
        offset += added
        slope += rise
    return offset, slope


def _spans(stretches: tuple[Stretch, ...], stations: Array, s: Array) -> tuple[LaneSpan, ...]:
    """The lanes below the path, by its arc length."""
    spans = []
    for piece in stretches:
        for low, high, lane in piece.lanes():
            a, b = np.interp([low, high], stations, s)
            if b - a > _SAME_M:
                spans.append(LaneSpan(piece.road.id, lane, piece.forward, float(a), float(b)))
    return tuple(spans)
