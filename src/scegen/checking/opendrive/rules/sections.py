"""Lane sections follow each other; lanes have a width, and carry on without a step."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise

from scegen.checking.opendrive.lanes import lane_borders, lane_width, stations
from scegen.checking.opendrive.network import (
    END,
    START,
    Lane,
    LaneSection,
    Network,
    Poly3,
    Road,
    lane_place,
    road_place,
)
from scegen.checking.opendrive.tolerances import GAP_M
from scegen.checking.results import Finding, error

ROUNDED_M = 1e-3
"""What rounding of coefficients may leave of nothing."""


def check_sections(network: Network) -> Iterator[Finding]:
    """``xodr.sections``: sections begin at 0 and rise; ``xodr.section_lanes``: lanes fit."""
    for road in network.roads.values():
        starts = [section.s for section in road.sections]
        if starts[0] != 0 or any(b <= a for a, b in pairwise([*starts, road.length])):
            message = f"its lane sections begin at {starts} m: not at 0, or not in rising order"
            yield error("xodr.sections", road_place(road.id), message)
            continue
        for before, after in pairwise(road.sections):
            yield from _carry_on(road, before, after)


def check_lanes_carry_on(network: Network) -> Iterator[Finding]:
    """``xodr.section_lanes``: a driving lane that has a width does not end where a section does."""
    for road in network.roads.values():
        for before, after in pairwise(road.sections):
            for lane in before.lanes.values():
                carries_on = lane.successor in after.lanes and lane.successor != 0
                wide = lane.id != 0 and lane_width(before, lane.id, after.s) > GAP_M
                if wide and lane.type == "driving" and not carries_on:
                    place = lane_place(road.id, lane.id, f"s = {after.s:.2f} m")
                    message = "does not carry on into a lane of the next section"
                    yield error("xodr.section_lanes", place, message)


def _carry_on(road: Road, before: LaneSection, after: LaneSection) -> Iterator[Finding]:
    for lane in before.lanes.values():
        place = lane_place(road.id, lane.id, f"s = {after.s:.2f} m")
        if lane.id == 0 or lane.type != "driving":
            continue
        following = after.lanes.get(lane.successor) if lane.successor else None
        if following is None:
            continue
        if following.predecessor != lane.id:
            message = f"carries on as lane {following.id}, which does not link back"
            yield error("xodr.section_lanes", place, message)
        borders = zip(
            lane_borders(road, before, lane.id, after.s),
            lane_borders(road, after, following.id, after.s),
            strict=True,
        )
        step = max(abs(a - b) for a, b in borders)
        if step > GAP_M:
            message = f"its border steps by {step:.3f} m between two sections"
            yield error("xodr.section_lanes", place, message)


def check_widths(network: Network) -> Iterator[Finding]:
    """``xodr.lane_width``: no lane has a negative width."""
    yield from _narrow(network, -ROUNDED_M, lambda _: True)


def check_driving_widths(network: Network) -> Iterator[Finding]:
    """``xodr.lane_width``: a driving lane has a width everywhere, its ends included.

    It may begin or end with none where it is linked to no other.
    """
    yield from _narrow(network, GAP_M, lambda lane: lane.type == "driving")


def _narrow(network: Network, least: float, asked: Callable[[Lane], bool]) -> Iterator[Finding]:
    for road in network.roads.values():
        for section in road.sections:
            for lane in section.lanes.values():
                if lane.id == 0 or not asked(lane):
                    continue
                along = stations(section.s, section.end)
                widths = [(lane_width(section, lane.id, s), s) for s in along]
                for end, first in ((START, 0), (END, -1)):
                    while lane.link(end) is None and len(widths) > 1:
                        if not 0.0 <= widths[first][0] < GAP_M:
                            break
                        widths.pop(first)
                width, s = min(widths)
                if width < least:
                    place = lane_place(road.id, lane.id, f"s = {s:.2f} m")
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
