"""Junctions are complete: every connection leads from a lane that exists to one that exists."""

from collections import Counter
from collections.abc import Iterator

from scegen.checking.opendrive.lanes import LaneEnd, end_at_junction, junction_joints
from scegen.checking.opendrive.network import (
    END,
    START,
    Connection,
    Junction,
    Network,
    lane_place,
    road_place,
)
from scegen.checking.results import Finding, error

RULE = "xodr.connection"


def check_connections(network: Network) -> Iterator[Finding]:
    """``xodr.connection``: roads, contact points and lane links of every connection."""
    for junction in network.junctions.values():
        counted = Counter(connection.id for connection in junction.connections)
        for number in (number for number, times in counted.items() if times > 1):
            place = f"junction {junction.id} connection {number}"
            yield error(RULE, place, f"the id is used {counted[number]} times")
        for connection in junction.connections:
            place = f"junction {junction.id} connection {connection.id}"
            yield from _roads(network, junction, connection, place)


def check_connecting_roads(network: Network) -> Iterator[Finding]:
    """``xodr.connecting_road``: each is named by a connection and joins two roads."""
    for junction in network.junctions.values():
        named = {connection.connecting for connection in junction.connections}
        for road in network.connecting_roads(junction.id):
            if road.id not in named:
                message = f"belongs to junction {junction.id}, but no connection names it"
                yield error("xodr.connecting_road", road_place(road.id), message)
            for contact in (START, END):
                link = road.link(contact)
                if link is None or link.element != "road":
                    message = "a connecting road must be linked to a road at both ends"
                    yield error("xodr.connecting_road", road_place(road.id, contact), message)


def _roads(
    network: Network, junction: Junction, connection: Connection, place: str
) -> Iterator[Finding]:
    incoming = network.roads.get(connection.incoming)
    connecting = network.roads.get(connection.connecting)
    for name, road, number in (
        ("incoming", incoming, connection.incoming),
        ("connecting", connecting, connection.connecting),
    ):
        if road is None:
            yield error(RULE, place, f"names {name} road {number}, which does not exist")
    if incoming is None or connecting is None:
        return
    if connecting.junction != junction.id and not junction.direct:
        message = f"road {connecting.id} belongs to {connecting.junction or 'no junction'}"
        yield error(RULE, place, message)
    if connection.contact not in {START, END}:
        yield error(RULE, place, f"has contact point {connection.contact!r}")
        return
    contact = end_at_junction(incoming, junction.id, connecting, connection.contact)
    if contact is None:
        message = f"no end of incoming road {incoming.id} is linked to junction {junction.id}"
        yield error(RULE, place, message)
        return
    link = connecting.link(connection.contact)
    to_road = link is not None and (link.id, link.contact) == (incoming.id, contact)
    to_junction = link is not None and (link.element, link.id) == ("junction", junction.id)
    if not (to_junction if junction.direct else to_road):
        goes_on = f"junction {junction.id}" if junction.direct else f"road {incoming.id} {contact}"
        said = f"is linked to {link or 'nothing'} instead of {goes_on}"
        yield error(RULE, place, f"road {connecting.id} {connection.contact} {said}")
    if not connection.lanes:
        yield error(RULE, place, "links no lanes")
    for lane_from, lane_to in connection.lanes:
        start = LaneEnd(incoming, contact, lane_from)
        goal = LaneEnd(connecting, connection.contact, lane_to)
        yield from _lanes(start, goal, place, linked=not junction.direct)


def check_connected_types(network: Network) -> Iterator[Finding]:
    """``xodr.connection``: connections join driving lanes only."""
    for junction in network.junctions.values():
        for joint in junction_joints(network, junction):
            for road, contact, number in (joint.first, joint.second):
                kind = road.section(contact).lanes[number].type
                if kind != "driving":
                    message = f"links {lane_place(road.id, number)}, which is of type {kind}"
                    yield error(RULE, joint.by, message)


def _lanes(start: LaneEnd, goal: LaneEnd, place: str, *, linked: bool) -> Iterator[Finding]:
    for road, contact, number in (start, goal):
        lane = road.section(contact).lanes.get(number)
        if lane is None or number == 0:
            yield error(RULE, place, f"links {lane_place(road.id, number)}, which does not exist")
            return
    (incoming, in_contact, lane_from), (connecting, contact, lane_to) = start, goal
    driven = incoming.section(in_contact).lanes[lane_from].type == "driving"
    if driven and not incoming.leads_to(lane_from, in_contact):
        message = f"comes from {lane_place(incoming.id, lane_from)}, which leaves the junction"
        yield error(RULE, place, message)
    if driven and connecting.leads_to(lane_to, contact):
        message = f"{lane_place(connecting.id, lane_to)} runs against the connection"
        yield error(RULE, place, message)
    back = connecting.section(contact).lanes[lane_to].link(contact)
    if linked and back != lane_from:
        message = (
            f"links lane {lane_from} to {lane_place(connecting.id, lane_to)}, "
            f"which is linked to {'nothing' if back is None else f'lane {back}'}"
        )
        yield error(RULE, place, message)
