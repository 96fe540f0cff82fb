"""What a file has to say: that it is OpenDRIVE 1.7, and how high every road lies."""

from collections.abc import Iterator

from scegen.checking.opendrive.network import Network, road_place
from scegen.checking.results import Finding, error

VERSION = ("1", "7")
"""1.7 is the newest version whose schema lxml can read, and for which ASAM's rules all run."""


def check_version(network: Network) -> Iterator[Finding]:
    """``xodr.version``: revMajor and revMinor are 1 and 7."""
    if network.version != VERSION:
        found = ".".join(network.version)
        yield error("xodr.version", "header", f"version {found} instead of {'.'.join(VERSION)}")


def check_elevation(network: Network) -> Iterator[Finding]:
    """``xodr.elevation``: a profile from s = 0 on; the standard takes a road for flat otherwise."""
    for road in network.roads.values():
        if not road.elevations:
            yield error("xodr.elevation", road_place(road.id), "has no elevation profile")
        elif road.elevations[0].s > 0:
            start = road.elevations[0].s
            message = f"its elevation profile begins at s = {start:g} m instead of 0"
            yield error("xodr.elevation", road_place(road.id), message)
