"""Every road says its height from its start on; the standard takes it for flat otherwise."""

from __future__ import annotations

from collections.abc import Iterator

from scegen.checking.opendrive.network import Network, road_place
from scegen.checking.results import Finding, error


def check_elevation(network: Network) -> Iterator[Finding]:
    """``xodr.elevation``: an elevation profile that begins at s = 0."""
    for road in network.roads.values():
        if not road.elevations:
            yield error("xodr.elevation", road_place(road.id), "has no elevation profile")
        elif road.elevations[0].s > 0:
            start = road.elevations[0].s
            message = f"its elevation profile begins at s = {start:g} m instead of 0"
            yield error("xodr.elevation", road_place(road.id), message)
