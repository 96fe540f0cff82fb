"""Where lanes lie: borders, centres and ends, computed from a road as read."""

from cmath import exp
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import atan2, ceil
from typing import NamedTuple

from scegen.checking.opendrive.curves import Poly3
from scegen.checking.opendrive.network import (
    END,
    START,
    Junction,
    LaneSection,
    Network,
    Road,
    lane_place,
    piece_at,
)

STEP_M = 1.0
"""Rules look at places no farther apart than this along a road."""


def stations(start: float, end: float) -> list[float]:
    """Both ends and points at most ``STEP_M`` apart between them."""
    count = max(1, min(10_000, ceil((end - start) / STEP_M)))
    return [start + (end - start) * i / count for i in range(count + 1)]


def reference(road: Road, s: float) -> tuple[complex, float, float]:
    """Point, heading and curvature of the reference line at ``s``."""
    geometry = piece_at(road.geometries, s) or road.geometries[0]
    ds = s - geometry.s
    return geometry.point(ds), geometry.heading_at(ds), geometry.shape.curvature(ds)


def section_at(road: Road, s: float) -> LaneSection:
    """The lane section that covers ``s``."""
    return piece_at(road.sections, s) or road.sections[0]


def lane_width(section: LaneSection, lane: int, s: float) -> float:
    """Width of a lane at ``s``."""
    return _of_width(section, lane, s, Poly3.value)


def lane_borders(road: Road, section: LaneSection, lane: int, s: float) -> tuple[float, float]:
    """Offsets of the inner and the outer border of a lane from the reference line (left > 0)."""
    inner, width = _inner_and_width(road, section, lane, s, Poly3.value)
    return inner, inner + width


def _inner_and_width(
    road: Road, section: LaneSection, lane: int, s: float, of: Callable[[Poly3, float], float]
) -> tuple[float, float]:
    """A lane's inner border and its width, to the left, at ``s``: their values or their slopes."""
    offset = piece_at(road.lane_offsets, s)
    inner = of(offset, s) if offset else 0.0
    sign = 1 if lane > 0 else -1
    for number in range(1, abs(lane)):
        inner += sign * _of_width(section, sign * number, s, of)
    return inner, sign * _of_width(section, lane, s, of)


def _of_width(
    section: LaneSection, lane: int, s: float, of: Callable[[Poly3, float], float]
) -> float:
    widths = section.lanes[lane].widths
    return of(piece_at(widths, s) or widths[0], s)


@dataclass(frozen=True, slots=True)
class LanePose:
    """A lane's cross-section: centre, heading along s, width and height."""

    centre: complex
    heading: float
    width: float
    height: float


def lane_pose(road: Road, section: LaneSection, lane: int, s: float) -> LanePose:
    """A lane's cross-section at ``s``, seen in the given section."""
    point, heading, curvature = reference(road, s)
    inner, outer = lane_borders(road, section, lane, s)
    t = (inner + outer) / 2
    inner_slope, width_slope = _inner_and_width(road, section, lane, s, Poly3.slope)
    elevation = piece_at(road.elevations, s)
    return LanePose(
        centre=point + 1j * t * exp(1j * heading),
        heading=heading + atan2(inner_slope + width_slope / 2, 1 - curvature * t),
        width=abs(outer - inner),
        height=elevation.value(s) if elevation else 0.0,
    )


class LaneEnd(NamedTuple):
    """One end of a lane: that at an end of its road."""

    road: Road
    contact: str
    lane: int

    @property
    def place(self) -> str:
        """How findings name it."""
        return lane_place(self.road.id, self.lane, self.contact)

    @property
    def pose(self) -> LanePose:
        """Its cross-section."""
        section, s = self.road.section(self.contact), self.road.s_at(self.contact)
        return lane_pose(self.road, section, self.lane, s)


class LaneJoint(NamedTuple):
    """Two lane ends that a file says are joined; ``by`` names the statement."""

    first: LaneEnd
    second: LaneEnd
    by: str


def lane_joints(network: Network) -> Iterator[LaneJoint]:
    """Every joint that lane links and junction connections state between existing lanes."""
    for road in network.roads.values():
        for contact in (START, END):
            yield from _road_joints(network, road, contact)
    for junction in network.junctions.values():
        yield from junction_joints(network, junction)


def junction_joints(network: Network, junction: Junction) -> Iterator[LaneJoint]:
    """Every joint of the lanes of two roads that a junction's connections state."""
    for connection in junction.connections:
        incoming = network.roads.get(connection.incoming)
        connecting = network.roads.get(connection.connecting)
        if incoming is None or connecting is None or connection.contact not in {START, END}:
            continue
        met = end_at_junction(incoming, junction.id, connecting, connection.contact)
        if met is None:
            continue
        for lane_from, lane_to in connection.lanes:
            known = lane_from in incoming.section(met).lanes and 0 not in {lane_from, lane_to}
            if known and lane_to in connecting.section(connection.contact).lanes:
                start = LaneEnd(incoming, met, lane_from)
                goal = LaneEnd(connecting, connection.contact, lane_to)
                yield LaneJoint(start, goal, f"junction {junction.id} connection {connection.id}")


def _road_joints(network: Network, road: Road, contact: str) -> Iterator[LaneJoint]:
    if (joined := network.joined(road, contact)) is None:
        return
    other, end = joined
    for lane in road.section(contact).lanes.values():
        target = lane.link(contact)
        if lane.id != 0 and target and target in other.section(end).lanes:
            here, there = LaneEnd(road, contact, lane.id), LaneEnd(other, end, target)
            yield LaneJoint(here, there, "lane link")


def end_at_junction(
    incoming: Road, junction: str, connecting: Road, connecting_contact: str
) -> str | None:
    """The end of an incoming road that meets a connecting road at a junction.

    A road can meet the same junction with both ends; then the connecting road's own link says
    which end is meant.
    """
    ends = [
        contact
        for contact in (START, END)
        if (link := incoming.link(contact)) and (link.element, link.id) == ("junction", junction)
    ]
    link = connecting.link(connecting_contact)
    if link and link.element == "road" and link.id == incoming.id and link.contact in ends:
        return link.contact
    return ends[0] if len(ends) == 1 else None


def driving(section: LaneSection) -> list[int]:
    """The driving lanes of a section, in the order of the file."""
    return [n for n, lane in section.lanes.items() if n != 0 and lane.type == "driving"]
