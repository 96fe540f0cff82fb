"""The reference line of each road is one unbroken, unbent line of lines and arcs."""

from collections.abc import Iterator
from itertools import pairwise
from math import degrees

from scegen.checking.opendrive.network import Geometry, Network, Road, road_place
from scegen.checking.opendrive.tolerances import GAP_M, KINK_DEG, heading_step
from scegen.checking.results import Finding, error, unchecked

LENGTH_M = 0.001
"""How far stated s values and lengths may differ; they are written with more digits than that."""


def check_geometry_kinds(network: Network) -> Iterator[Finding]:
    """``xodr.geometry_kind``: lines and arcs only, which every simulator places alike."""
    for road in network.roads.values():
        for kind in sorted({g.kind for g in road.geometries} - {"line", "arc"}):
            message = f"has a geometry of kind {kind!r}, neither line nor arc"
            yield error("xodr.geometry_kind", road_place(road.id), message)


def check_readable_kinds(network: Network) -> Iterator[Finding]:
    """``xodr.geometry_kind``: what lies along a geometry of another kind is not worked out."""
    for road in network.roads.values():
        for kind in sorted({g.kind for g in road.geometries if g.curve is None}):
            message = f"the geometry {kind!r} is not read, so nothing is placed on this road"
            yield unchecked("xodr.geometry_kind", road_place(road.id), message)


def check_stations(network: Network) -> Iterator[Finding]:
    """``xodr.stations``: s values follow from the lengths, and the lengths add up."""
    for road in network.roads.values():
        expected = 0.0
        for geometry in road.geometries:
            place = road_place(road.id, f"geometry at s = {geometry.s:g} m")
            if abs(geometry.s - expected) > LENGTH_M:
                message = f"should begin at s = {expected:.3f} m, where the one before it ends"
                yield error("xodr.stations", place, message)
            if geometry.length <= 0:
                yield error("xodr.stations", place, f"has length {geometry.length:g} m")
            expected = geometry.s + geometry.length
        if abs(road.length - expected) > LENGTH_M:
            message = f"length {road.length:g} m, but its geometries end at {expected:.3f} m"
            yield error("xodr.stations", road_place(road.id), message)


def check_reference_line(network: Network) -> Iterator[Finding]:
    """``xodr.road_gap``, ``xodr.road_kink``: no step between the geometries of a road."""
    for road in network.roads.values():
        for before, after in pairwise(road.geometries):
            if before.curve is not None:
                yield from _joint(road, before, after)


def _starts(geometry: Geometry) -> float:
    """The heading at its start: a cubic may begin at an angle to its own axis."""
    return geometry.hdg if geometry.curve is None else geometry.heading_at(0.0)


def _joint(road: Road, before: Geometry, after: Geometry) -> Iterator[Finding]:
    place = road_place(road.id, f"s = {after.s:.2f} m")
    gap = abs(before.point(before.length) - complex(after.x, after.y))
    if gap > GAP_M:
        yield error("xodr.road_gap", place, f"the reference line breaks by {gap:.3f} m")
    kink = degrees(heading_step(before.heading_at(before.length), _starts(after)))
    if abs(kink) > KINK_DEG:
        yield error("xodr.road_kink", place, f"the reference line bends by {kink:.2f}°")
