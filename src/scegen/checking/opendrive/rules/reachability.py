"""Whoever enters can leave: every lane of every arm leads on, and every arm to every other."""

from collections.abc import Iterator

from scegen.checking.opendrive.arms import open_ends
from scegen.checking.opendrive.network import Network, lane_place
from scegen.checking.opendrive.routing import lane_graph, outer_node, reach
from scegen.checking.results import Finding, error

RULE = "xodr.reachable"


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
                yield error(RULE, arm.place, f"no way leads to {other.place}")
        if arm.inward and not arm.outward and not any(k != i for k, _ in lanes):
            yield error(RULE, arm.place, "no way leads to any other arm")
    for i, lane in sorted(set(leaving) - reached_lanes):
        yield error(RULE, lane_place(arms[i].road.id, lane), "is not reached from any other arm")
