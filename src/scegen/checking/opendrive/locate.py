"""From points back to roads and lanes."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from math import ceil, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scegen.checking.opendrive.curves import Arc, Poly3
from scegen.checking.opendrive.network import Geometry, LaneSection, Network, Road, lane_place

TOLERANCE_M = 0.05
"""How far outside a lane a point may lie and still count as on it."""
CHORD_M = 0.5
_ROUNDING = 1e-9
_KEPT = 8
"""Networks of which it is kept how far their roads reach."""
Points = NDArray[np.complex128]
Numbers = NDArray[np.float64]


class OnLane(NamedTuple):
    """A point lies on this lane; ``t_m`` is its offset from the lane's centre (left > 0)."""

    road: str
    lane: int
    type: str
    s_m: float
    t_m: float
    geometry: Geometry
    along_s: bool
    """Whether traffic on the lane runs in the direction of s."""

    @property
    def heading_rad(self) -> float:
        """Heading of traffic on the lane."""
        heading = self.geometry.heading_at(self.s_m - self.geometry.s)
        return heading + (0.0 if self.along_s else pi)


def lanes_at(network: Network, points: Points) -> list[list[OnLane]]:
    """For each point (x + iy), every lane of any type that it lies on."""
    found: list[list[OnLane]] = [[] for _ in points]
    known: set[tuple[int, str, int]] = set()
    strips = _strips(network)
    middles = np.array([strip.middle for strip in strips], dtype=np.complex128)
    radii = np.array([strip.radius_m for strip in strips])
    close = np.abs(points - middles[:, None]) <= radii[:, None]
    for strip, mine in zip(strips, close, strict=True):
        road, geometry = strip.road, strip.geometry
        near = np.flatnonzero(mine)
        if not near.size:
            continue
        ds, t = _along(geometry, points[near])
        inside = (ds >= -TOLERANCE_M) & (ds <= geometry.length + TOLERANCE_M)
        here = np.flatnonzero(inside & (np.abs(t) <= strip.reach_m))
        if here.size:
            s = np.clip(geometry.s + ds[here], 0.0, road.length)
            numbers = near[here].tolist()
            for n, lane in _on_lanes(road, geometry, s, t[here]):
                number = numbers[n]
                if (number, road.id, lane.lane) not in known:
                    known.add((number, road.id, lane.lane))
                    found[number].append(lane)
    return found


def in_words(lanes: Iterable[OnLane]) -> str:
    """How findings name the lanes that a point lies on."""
    return ", ".join(lane_place(lane.road, lane.lane) for lane in lanes) or "no lane"


@dataclass(frozen=True, slots=True)
class _Strip:
    """A geometry of a road with a circle outside which no point can lie on one of its lanes."""

    road: Road
    geometry: Geometry
    reach_m: float
    middle: complex
    radius_m: float


@lru_cache(maxsize=_KEPT)
def _strips(network: Network) -> list[_Strip]:
    found = []
    for road in network.roads.values():
        reach = _reach(road) if road.measurable else 0.0
        for geometry in road.geometries if road.measurable else ():
            half = geometry.length / 2
            # The length of other curves may not be that of their points.
            exact = isinstance(geometry.curve, Arc)
            radius = half + reach + 2 * TOLERANCE_M if exact else np.inf
            found.append(_Strip(road, geometry, reach, geometry.point(half), radius))
    return found


def _along(geometry: Geometry, points: Points) -> tuple[Numbers, Numbers]:
    local = (points - complex(geometry.x, geometry.y)) * np.exp(-1j * geometry.hdg)
    if not isinstance(geometry.curve, Arc):
        return _along_chords(geometry, local)
    k = geometry.curve.bend
    if k == 0.0:
        return local.real, local.imag
    from_centre = local - 1j / k
    swept = np.angle(from_centre / (-1j / k)) * np.sign(k)
    ds = np.mod(swept, 2 * pi) / abs(k)
    # Just before the start is a little less than nothing, not almost a full circle.
    ds = np.where(ds > (2 * pi / abs(k) + geometry.length) / 2, ds - 2 * pi / abs(k), ds)
    return ds, 1 / k - np.sign(k) * np.abs(from_centre)


def _along_chords(geometry: Geometry, local: Points) -> tuple[Numbers, Numbers]:
    """Along the chords of a curve without a closed form; one of 0.5 m is off by millimetres."""
    count = max(1, ceil(geometry.length / CHORD_M))
    ds = np.linspace(0.0, geometry.length, count + 1)
    line = np.array([geometry.shape.point(float(s)) for s in ds])
    chord = np.diff(line)
    share = ((local[:, None] - line[:-1]) * chord.conj()).real / np.abs(chord) ** 2
    # Beyond the ends, and nowhere else, a point lies before or after the curve.
    low = np.where(np.arange(count) == 0, -np.inf, 0.0)
    high = np.where(np.arange(count) == count - 1, np.inf, 1.0)
    share = np.clip(share, low, high)
    away = local[:, None] - (line[:-1] + share * chord)
    best = np.abs(away).argmin(axis=1)
    rows = np.arange(len(local))
    left = (away[rows, best] * chord[best].conj()).imag / np.abs(chord[best])
    return ds[best] + share[rows, best] * np.diff(ds)[best], left


def _reach(road: Road) -> float:
    offsets = max(
        (abs(piece.value(s)) for piece in road.lane_offsets for s in (piece.s, road.length)),
        default=0.0,
    )
    widths = (
        sum(
            max(abs(width.value(s)) for width in lane.widths for s in (width.s, section.end))
            for lane in section.lanes.values()
            if lane.id != 0
        )
        for section in road.sections
    )
    return offsets + max(widths) + 1.0


def _on_lanes(
    road: Road, geometry: Geometry, s: Numbers, t: Numbers
) -> Iterator[tuple[int, OnLane]]:
    """(number of the point, a lane that it lies on), of points beside one geometry of a road."""
    begun = np.array([section.s for section in road.sections]) <= s[:, None] + _ROUNDING
    last = np.maximum(begun.sum(axis=1) - 1, 0)
    offset = _values(road.lane_offsets, s, np.zeros(len(s)))
    for number, section in enumerate(road.sections):
        borders = _borders(section, s, offset)
        for lane in section.lanes.values():
            if lane.id == 0:
                continue
            inner, outer = borders[lane.id - (1 if lane.id > 0 else -1)], borders[lane.id]
            low, high = np.minimum(inner, outer), np.maximum(inner, outer)
            on = (low - TOLERANCE_M <= t) & (t <= high + TOLERANCE_M) & (last == number)
            here = np.flatnonzero(on)
            aside = t[here] - (inner[here] + outer[here]) / 2
            along_s = road.runs_along_s(lane.id)
            for n, at, off in zip(here.tolist(), s[here].tolist(), aside.tolist(), strict=True):
                yield n, OnLane(road.id, lane.id, lane.type, at, off, geometry, along_s)


def _borders(section: LaneSection, s: Numbers, offset: Numbers) -> dict[int, Numbers]:
    """Offsets of the outer border of every lane from the reference line (left > 0)."""
    borders = {0: offset}
    for sign in (1, -1):
        number = sign
        while number in section.lanes:
            widths = section.lanes[number].widths
            width = _values(widths, s, widths[0].value(s))
            borders[number] = borders[number - sign] + sign * width
            number += sign
    return borders


def _values(pieces: tuple[Poly3, ...], s: Numbers, before: Numbers) -> Numbers:
    """The values of the last pieces that have begun at places; ``before`` the first."""
    for piece in pieces:
        before = np.where(piece.s <= s + _ROUNDING, piece.value(s), before)
    return before
