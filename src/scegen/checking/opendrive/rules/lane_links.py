"""Lanes are linked to lanes that exist, of the same type and direction, and both ways."""

from collections.abc import Iterator

from scegen.checking.opendrive.network import END, START, Lane, Network, Road, lane_place
from scegen.checking.results import Finding, error

RULE = "xodr.lane_link"
BESIDE = frozenset({"shoulder", "parking", "border", "stop"})
"""Types that may follow one another: a strip beside traffic changes its use, not its place."""


def check_lane_links(network: Network) -> Iterator[Finding]:
    """``xodr.lane_link``: at every end that is linked to a road."""
    for road in network.roads.values():
        for contact in (START, END):
            if (joined := network.joined(road, contact)) is None:
                continue
            for lane in road.section(contact).lanes.values():
                if lane.id != 0:
                    yield from _lane(road, contact, lane, *joined)


def _lane(
    road: Road, contact: str, lane: Lane, other: Road, other_contact: str
) -> Iterator[Finding]:
    place = lane_place(road.id, lane.id, contact)
    number = lane.link(contact)
    if number is None:
        if lane.type == "driving":
            yield error(RULE, place, f"is not linked to a lane of road {other.id}")
        return
    target = other.section(other_contact).lanes.get(number)
    if target is None or number == 0:
        message = f"is linked to lane {number} of road {other.id}, which does not exist"
        yield error(RULE, place, message)
        return
    there = lane_place(other.id, number)
    if _use(target) != _use(lane):
        yield error(RULE, place, f"of type {lane.type} is linked to {there} of type {target.type}")
    if road.leads_to(lane.id, contact) == other.leads_to(number, other_contact):
        yield error(RULE, place, f"is linked to {there}, on which traffic runs the other way")
    # The incoming road of a junction has no lane links at that end: its connections have them.
    if road.junction is None and target.link(other_contact) != lane.id:
        back = target.link(other_contact)
        said = "nothing" if back is None else f"lane {back}"
        yield error(RULE, place, f"is linked to {there}, which is linked to {said}")


def _use(lane: Lane) -> str:
    return "beside" if lane.type in BESIDE else lane.type
