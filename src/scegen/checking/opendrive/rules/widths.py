"""Lane widths are positive and do not step inside a road."""

from collections.abc import Callable, Iterator
from itertools import pairwise

from scegen.checking.opendrive.curves import Poly3
from scegen.checking.opendrive.lanes import lane_width, stations
from scegen.checking.opendrive.network import END, START, Lane, Network, lane_place, road_place
from scegen.checking.opendrive.tolerances import GAP_M
from scegen.checking.results import Finding, error

ROUNDED_M = 1e-3
"""What rounding of coefficients may leave of nothing."""


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
