"""Roads are linked to what exists, and links hold both ways."""

from collections.abc import Iterator
from dataclasses import replace

from scegen.checking.opendrive.network import END, START, Link, Network, Road, road_place
from scegen.checking.results import Finding, error

RULE = "xodr.road_link"


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
        yield error(RULE, place, f"is linked to road {other.id} {link.contact}, which {said}")


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
