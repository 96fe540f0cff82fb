"""Our own check of OpenDRIVE files: geometry, topology, reachability.

Schema, ASAM's checker, netconvert, CARLA and esmini each let through files with broken roads,
deleted connections or wrong lane links; these rules do not.
"""

from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import NamedTuple

from scegen.checking.documents import BrokenXmlError, parse_document
from scegen.checking.opendrive.network import Network
from scegen.checking.opendrive.read import read_network
from scegen.checking.opendrive.rules.described import check_described
from scegen.checking.opendrive.rules.folds import check_folds, check_overlaps
from scegen.checking.opendrive.rules.header import check_elevation, check_version
from scegen.checking.opendrive.rules.joints import check_joints
from scegen.checking.opendrive.rules.junctions import (
    check_connected_types,
    check_connecting_roads,
    check_connections,
)
from scegen.checking.opendrive.rules.lane_links import check_lane_links
from scegen.checking.opendrive.rules.plan_view import (
    check_geometry_kinds,
    check_readable_kinds,
    check_reference_line,
    check_stations,
)
from scegen.checking.opendrive.rules.reachability import check_dead_ends, check_reachability
from scegen.checking.opendrive.rules.road_links import check_road_links
from scegen.checking.opendrive.rules.sections import check_lanes_carry_on, check_sections
from scegen.checking.opendrive.rules.widths import (
    check_driving_widths,
    check_width_steps,
    check_widths,
)
from scegen.checking.results import CheckResult, Finding, as_remarks, verdict
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.wording import counted

CHECKER = "opendrive"
Rule = Callable[[Network], Iterator[Finding]]

RULES: tuple[Rule, ...] = (
    check_readable_kinds,
    check_stations,
    check_reference_line,
    check_sections,
    check_widths,
    check_width_steps,
    check_folds,
    check_overlaps,
    check_road_links,
    check_lane_links,
    check_joints,
    check_connections,
    check_connecting_roads,
)
"""What the standard asks for."""
CONVENTIONS: tuple[Rule, ...] = (
    check_version,
    check_elevation,
    check_geometry_kinds,
    check_driving_widths,
    check_lanes_carry_on,
    check_connected_types,
    check_dead_ends,
    check_reachability,
)
"""What our own roads keep besides, so that all players agree; remarks on the roads of others."""
_KEPT = 8
"""Roads that are kept: many scenarios of a campaign share theirs."""


class CheckedRoad(NamedTuple):
    """The verdict, and the network for whoever looks at the scenario next (None if unreadable)."""

    result: CheckResult
    network: Network | None


def check_opendrive(
    name: str, content: bytes, concrete: ConcreteScenario | None = None
) -> CheckedRoad:
    """Check an OpenDRIVE file, against the concrete scenario it should serve if there is one."""
    try:
        network, found, unconventional = _looked_at(name, content)
    except BrokenXmlError as broken:
        return CheckedRoad(verdict(CHECKER, [broken.finding]), None)
    findings = list(found)
    findings += unconventional if concrete is not None else as_remarks(unconventional)
    if concrete is not None and network.roads:
        findings += check_described(network, concrete)
    of_roads, of_junctions = len(network.roads), len(network.junctions)
    detail = f"{counted(of_roads, 'road')}, {counted(of_junctions, 'junction')}, "
    detail += counted(len(RULES) + len(CONVENTIONS), "rule")
    return CheckedRoad(verdict(CHECKER, findings, detail), network)


@lru_cache(maxsize=_KEPT)
def _looked_at(
    name: str, content: bytes
) -> tuple[Network, tuple[Finding, ...], tuple[Finding, ...]]:
    """A road as read, what the rules and the conventions find in it, whatever drives there.

    Raises:
        BrokenXmlError: it cannot be read.
    """
    network, unread = read_network(parse_document(name, content, "OpenDRIVE"))
    found, unconventional = (
        tuple(finding for rule in rules for finding in rule(network))
        for rules in (RULES, CONVENTIONS)
    )
    return network, (*unread, *found), unconventional
