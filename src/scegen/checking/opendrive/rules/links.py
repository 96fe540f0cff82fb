"""Links hold both ways, to what exists and fits, and lead from every arm to every other."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import degrees, pi

from scegen.checking.opendrive.arms import open_ends
from scegen.checking.opendrive.lanes import LaneJoint, lane_joints
from scegen.checking.opendrive.network import (
    END,
    START,
    Lane,
    Link,
    Network,
    Road,
    lane_place,
    road_place,
)
from scegen.checking.opendrive.routing import lane_graph, outer_node, reach
from scegen.checking.opendrive.tolerances import GAP_M, KINK_DEG, heading_step
from scegen.checking.results import Finding, error

RULE = "xodr.road_link"
_OF_LANE = "xodr.lane_link"
BESIDE = frozenset({"shoulder", "parking", "border", "stop"})
"""Types that may follow one another: a strip beside traffic changes its use, not its place."""
_REACHABLE = "xodr.reachable"


def check_road_links(network: Network) -> Iterator[Finding]:
    """``xodr.road_link``: the linked road or junction exists and says the same."""
    for road in network.roads.values():
        for contact in (START, END):
            link = road.link(contact)
            if link is not None:
                yield from _holds(network, road, contact, link)
        if road.junction is not None and road.junction not in network.junctions:
            message = f"belongs to junction {road.junction}, which does not exist"
            yield error(RULE, road_place(road.id), message)


def _holds(network: Network, road: Road, contact: str, link: Link) -> Iterator[Finding]:
    place = road_place(road.id, contact)
    if link.element == "junction":
        if link.id not in network.junctions:
            yield error(RULE, place, f"is linked to junction {link.id}, which does not exist")
        elif not _joined(network, road, link.id):
            message = f"is linked to junction {link.id}, which has no connection with it"
            yield error(RULE, place, message)
        return
    other = network.roads.get(link.id)
    if link.element != "road" or other is None:
        yield error(RULE, place, f"is linked to {link.element} {link.id}, which does not exist")
        return
    if link.contact not in {START, END}:
        yield error(RULE, place, f"is linked to road {other.id} without a contact point")
        return
    expected = Link("road", road.id, contact)
    if road.junction is not None:
        # A connecting road is linked to a road that, in turn, is linked to the junction.
        expected = Link("junction", road.junction, None)
    back = other.link(link.contact)
    if back is not None and expected.contact is None:
        back = replace(back, contact=None)  # a junction has no ends
    if back != expected:
        said = f"is linked to {other.link(link.contact) or 'nothing'} instead of {expected}"
        message = f"is linked to road {other.id} {link.contact}, which {said}"
        yield error(RULE, place, message)


def _joined(network: Network, road: Road, junction: str) -> bool:
    connections = network.junctions[junction].connections
    leaving = (
        link.id
        for connecting in network.connecting_roads(junction)
        for link in (connecting.predecessor, connecting.successor)
        if link is not None
    )
    named = {number for c in connections for number in (c.incoming, c.connecting)}
    return road.id in {*named, *leaving}


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
            yield error(_OF_LANE, place, f"is not linked to a lane of road {other.id}")
        return
    target = other.section(other_contact).lanes.get(number)
    if target is None or number == 0:
        message = f"is linked to lane {number} of road {other.id}, which does not exist"
        yield error(_OF_LANE, place, message)
        return
    there = lane_place(other.id, number)
    if _use(target) != _use(lane):
        message = f"of type {lane.type} is linked to {there} of type {target.type}"
        yield error(_OF_LANE, place, message)
    if road.leads_to(lane.id, contact) == other.leads_to(number, other_contact):
        message = f"is linked to {there}, on which traffic runs the other way"
        yield error(_OF_LANE, place, message)
    # The incoming road of a junction has no lane links at that end: its connections have them.
    if road.junction is None and target.link(other_contact) != lane.id:
        back = target.link(other_contact)
        said = "nothing" if back is None else f"lane {back}"
        yield error(_OF_LANE, place, f"is linked to {there}, which is linked to {said}")


def _use(lane: Lane) -> str:
    return "beside" if lane.type in BESIDE else lane.type


def check_dead_ends(network: Network) -> Iterator[Finding]:
    """``xodr.dead_end``: a driving lane ends only where the network does."""
    graph = lane_graph(network)
    leaving = {outer_node(arm, lane) for arm in open_ends(network) for lane in arm.outward}
    for node, following in graph.items():
        if not following and node not in leaving:
            road, _, lane = node
            yield error("xodr.dead_end", lane_place(road, lane), "leads nowhere")


def check_reachability(network: Network) -> Iterator[Finding]:
    """``xodr.reachable``: each lane out is reached, each arm reaches every other arm.

    One that leads only in or only out (a ramp, a one-way road) has a way to or from some arm.
    """
    graph = lane_graph(network)
    arms = list(open_ends(network))
    leaving = {
        (i, lane): outer_node(arm, lane) for i, arm in enumerate(arms) for lane in arm.outward
    }
    reached_lanes: set[tuple[int, int]] = set()
    for i, arm in enumerate(arms):
        reached = reach(graph, [outer_node(arm, lane) for lane in arm.inward])
        lanes = {key for key, node in leaving.items() if node in reached}
        reached_lanes |= {key for key in lanes if key[0] != i}
        two_way = arm.inward and arm.outward
        for j, other in enumerate(arms):
            both = two_way and other.inward and other.outward
            if i != j and both and all(k != j for k, _ in lanes):
                yield error(_REACHABLE, arm.place, f"no way leads to {other.place}")
        if arm.inward and not arm.outward and not any(k != i for k, _ in lanes):
            yield error(_REACHABLE, arm.place, "no way leads to any other arm")
    for i, lane in sorted(set(leaving) - reached_lanes):
        place = lane_place(arms[i].road.id, lane)
        yield error(_REACHABLE, place, "is not reached from any other arm")


def check_joints(network: Network) -> Iterator[Finding]:
    """``xodr.lane_gap``, ``lane_kink``, ``lane_step``: measured at the ends of linked lanes.

    Centre, heading and width together fix both edges; reference lines need not meet, since a
    connecting road's lies on its lane's centre.
    """
    seen = set()
    for joint in lane_joints(network):
        ends = frozenset({joint.first.place, joint.second.place})
        if ends in seen or not (joint.first.road.measurable and joint.second.road.measurable):
            continue
        seen.add(ends)
        yield from _meet(joint)


def _meet(joint: LaneJoint) -> Iterator[Finding]:
    first, second = joint.first.pose, joint.second.pose
    place = f"{joint.first.place} – {joint.second.place}"
    gap = abs(first.centre - second.centre)
    if gap > GAP_M:
        yield error("xodr.lane_gap", place, f"linked lanes end {gap:.3f} m apart")
    # Where two ends of the same kind meet, the roads' s run against each other.
    turned = pi if joint.first.contact == joint.second.contact else 0.0
    kink = degrees(heading_step(first.heading + turned, second.heading))
    if abs(kink) > KINK_DEG:
        yield error("xodr.lane_kink", place, f"linked lanes bend by {kink:.2f}°")
    width = second.width - first.width
    if abs(width) > GAP_M:
        message = f"the width jumps from {first.width:.3f} m to {second.width:.3f} m"
        yield error("xodr.lane_step", place, message)
    height = second.height - first.height
    if abs(height) > GAP_M:
        yield error("xodr.lane_step", place, f"the height jumps by {height:+.3f} m")
