"""Lane sections of a road follow each other, and their lanes carry on without a step."""

from collections.abc import Iterator
from itertools import pairwise

from scegen.checking.opendrive.lanes import lane_borders, lane_width
from scegen.checking.opendrive.network import LaneSection, Network, Road, lane_place, road_place
from scegen.checking.opendrive.tolerances import GAP_M
from scegen.checking.results import Finding, error


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
