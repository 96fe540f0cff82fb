"""Lane widths are positive and do not step inside a road."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from scegen.checking.opendrive.lanes import lane_width
from scegen.checking.opendrive.network import (
    LaneSection,
    Network,
    Poly3,
    Road,
    lane_place,
    road_place,
)
from scegen.checking.opendrive.sampling import stations
from scegen.checking.opendrive.tolerances import GAP_M
from scegen.checking.results import Finding, error


def check_widths(network: Network) -> Iterator[Finding]:
    """``xodr.lane_width``: driving lanes have a width everywhere, no lane a negative one."""
    for road in network.roads.values():
        for section in road.sections:
            for lane in section.lanes.values():
                if lane.id != 0:
                    yield from _narrowest(road, section, lane.id)


def _narrowest(road: Road, section: LaneSection, lane: int) -> Iterator[Finding]:
    width, s = min((lane_width(section, lane, s), s) for s in stations(section.s, section.end))
    lowest = GAP_M if section.lanes[lane].type == "driving" else -1e-6
    if width < lowest:
        place = lane_place(road.id, lane, f"s = {s:.2f} m")
        yield error("xodr.lane_width", place, f"is {width:.3f} m wide")


def check_width_steps(network: Network) -> Iterator[Finding]:
    """``xodr.width_step``: neither a width nor the lane offset jumps inside a section."""
    for road in network.roads.values():
        yield from _steps(road.lane_offsets, road_place(road.id, "lane offset"))
        for section in road.sections:
            for lane in section.lanes.values():
                yield from _steps(lane.widths, lane_place(road.id, lane.id, "width"))


def _steps(pieces: tuple[Poly3, ...], place: str) -> Iterator[Finding]:
    for before, after in pairwise(pieces):
        step = after.a - before.value(after.s)
        if abs(step) > GAP_M:
            yield error("xodr.width_step", f"{place} s = {after.s:.2f} m", f"jumps {step:+.3f} m")
