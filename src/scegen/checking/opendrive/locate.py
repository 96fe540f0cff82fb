"""From points back to roads and lanes."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, pi

import numpy as np
from numpy.typing import NDArray

from scegen.checking.opendrive.curves import Arc
from scegen.checking.opendrive.lanes import lane_borders, reference, section_at
from scegen.checking.opendrive.network import Geometry, Network, Road

TOLERANCE_M = 0.05
"""How far outside a lane a point may lie and still count as on it."""
CHORD_M = 0.5
Points = NDArray[np.complex128]
Numbers = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class OnLane:
    """A point lies on this lane; ``t_m`` is its offset from the lane's centre (left > 0)."""

    road: str
    lane: int
    type: str
    s_m: float
    t_m: float
    heading_rad: float
    """Heading of traffic on the lane."""


def lanes_at(network: Network, points: Points) -> list[list[OnLane]]:
    """For each point (x + iy), every lane of any type that it lies on."""
    found: list[list[OnLane]] = [[] for _ in points]
    for road in network.roads.values():
        if not road.measurable:
            continue
        reach = _reach(road)
        for geometry in road.geometries:
            ds, t = _along(geometry, points)
            inside = (ds >= -TOLERANCE_M) & (ds <= geometry.length + TOLERANCE_M)
            for i in np.flatnonzero(inside & (np.abs(t) <= reach)):
                s = min(max(geometry.s + float(ds[i]), 0.0), road.length)
                _add(found[i], road, s, float(t[i]))
    return found


def _along(geometry: Geometry, points: Points) -> tuple[Numbers, Numbers]:
    turned = np.exp(-1j * geometry.hdg)
    local = (points - complex(geometry.x, geometry.y)) * turned
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


def _add(found: list[OnLane], road: Road, s: float, t: float) -> None:
    section = section_at(road, s)
    for lane in section.lanes.values():
        if lane.id == 0:
            continue
        inner, outer = lane_borders(road, section, lane.id, s)
        low, high = min(inner, outer), max(inner, outer)
        if not low - TOLERANCE_M <= t <= high + TOLERANCE_M:
            continue
        if any(other.road == road.id and other.lane == lane.id for other in found):
            continue
        heading = reference(road, s)[1] + (0.0 if road.runs_along_s(lane.id) else pi)
        found.append(OnLane(road.id, lane.id, lane.type, s, t - (inner + outer) / 2, heading))
