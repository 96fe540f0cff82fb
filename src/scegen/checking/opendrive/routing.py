"""Where one can drive: lanes as nodes, links and connections as edges."""

from collections import defaultdict
from collections.abc import Iterable

from scegen.checking.opendrive.arms import Arm
from scegen.checking.opendrive.lanes import driving, junction_joints
from scegen.checking.opendrive.network import END, START, Network, Road

Node = tuple[str, int, int]
"""Road id, index of the lane section, lane."""
LaneGraph = dict[Node, tuple[Node, ...]]
"""The driving lanes, each with those that follow."""


def reach(graph: LaneGraph, starts: Iterable[Node]) -> set[Node]:
    """All lanes that can be driven to from any of some, themselves included."""
    seen = {*starts}
    open_nodes = [*seen]
    while open_nodes:
        for following in graph.get(open_nodes.pop(), ()):
            if following not in seen:
                seen.add(following)
                open_nodes.append(following)
    return seen


def lane_graph(network: Network) -> LaneGraph:
    """The graph of all driving lanes; links to what does not exist lead nowhere."""
    connected = _connected(network)
    after: LaneGraph = {}
    for road in network.roads.values():
        for index, section in enumerate(road.sections):
            for lane in driving(section):
                node = (road.id, index, lane)
                after[node] = (*_after(network, road, node, connected), *_beside(road, node))
    return after


def _beside(road: Road, node: Node) -> tuple[Node, ...]:
    """The lanes into which one changes: out of a lane that ends here, into one that begins here."""
    name, index, number = node
    section = road.sections[index]
    beside = [number + step for step in (-1, 1) if (number + step) * number > 0]
    lanes = [section.lanes[n] for n in beside if n in section.lanes]
    lanes = [lane for lane in lanes if lane.type == "driving"]
    ahead, behind = (END, START) if road.runs_along_s(number) else (START, END)
    found = {x.id for x in lanes if _has_end(road, index, x.id, behind)}
    if _has_end(road, index, number, ahead):
        found |= {lane.id for lane in lanes}
    return tuple((name, index, n) for n in sorted(found))


def _has_end(road: Road, index: int, number: int, contact: str) -> bool:
    """Whether a lane begins or ends where its section does, in the middle of the road."""
    inner = index + (1 if contact == END else -1)
    lane = road.sections[index].lanes[number]
    return 0 <= inner < len(road.sections) and lane.link(contact) is None


def outer_node(arm: Arm, lane: int) -> Node:
    """The node of a lane at an arm's open end."""
    return (arm.road.id, _index(arm.road, arm.contact), lane)


def _index(road: Road, contact: str) -> int:
    return 0 if contact == START else len(road.sections) - 1


def _after(
    network: Network, road: Road, node: Node, connected: dict[tuple[str, str, int], list[Node]]
) -> tuple[Node, ...]:
    _, index, number = node
    ahead = END if road.runs_along_s(number) else START
    target = road.sections[index].lanes[number].link(ahead)
    step = 1 if ahead == END else -1
    if 0 <= index + step < len(road.sections):
        return _driving(network, road.id, index + step, target)
    link = road.link(ahead)
    if link is not None and link.element == "junction":
        return tuple(connected[road.id, ahead, number])
    if (joined := network.joined(road, ahead)) is None:
        return ()
    other, end = joined
    return _driving(network, other.id, _index(other, end), target)


def _driving(network: Network, road: str, index: int, lane: int | None) -> tuple[Node, ...]:
    found = network.roads[road].sections[index].lanes.get(lane) if lane else None
    return ((road, index, found.id),) if found and found.type == "driving" else ()


def _connected(network: Network) -> dict[tuple[str, str, int], list[Node]]:
    connected: dict[tuple[str, str, int], list[Node]] = defaultdict(list)
    for junction in network.junctions.values():
        for (road, contact, lane), (onward, end, there), _ in junction_joints(network, junction):
            connected[road.id, contact, lane].append((onward.id, _index(onward, end), there))
    return connected
