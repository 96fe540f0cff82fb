"""Our own check of OpenSCENARIO files: references, starts, trajectories, exits."""

from collections.abc import Callable, Iterator
from functools import lru_cache
from pathlib import PurePosixPath

from scegen.checking.documents import BrokenXmlError, parse_document
from scegen.checking.opendrive.arms import match_arms
from scegen.checking.opendrive.network import Network
from scegen.checking.openscenario.read import read_storyboard
from scegen.checking.openscenario.rules.objects import check_objects
from scegen.checking.openscenario.rules.paths import check_paths
from scegen.checking.openscenario.rules.references import (
    check_ego,
    check_entities,
    check_lane_positions,
    check_participants,
)
from scegen.checking.openscenario.rules.starts import check_starts
from scegen.checking.openscenario.rules.trajectories import (
    check_trajectories,
    check_trajectory_shapes,
    check_trajectory_starts,
)
from scegen.checking.openscenario.situation import Situation
from scegen.checking.openscenario.storyboard import Storyboard
from scegen.checking.results import CheckResult, Finding, as_remarks, error, verdict
from scegen.scenario.concrete import ConcreteScenario

CHECKER = "openscenario"
Rule = Callable[[Situation], Iterator[Finding]]

RULES: tuple[Rule, ...] = (
    check_entities,
    check_participants,
    check_lane_positions,
    check_starts,
    check_trajectories,
    check_paths,
    check_objects,
)
CONVENTIONS: tuple[Rule, ...] = (check_ego, check_trajectory_shapes, check_trajectory_starts)
"""What our own scenarios keep besides; remarks on those of others."""


def check_openscenario(
    name: str,
    content: bytes,
    *,
    road_file: str | None,
    network: Network | None = None,
    concrete: ConcreteScenario | None = None,
) -> CheckResult:
    """Check an OpenSCENARIO file on its road.

    ``road_file`` is the name of the OpenDRIVE file beside it, ``network`` that road as read,
    ``concrete`` what the file should say; None where that is not there, or cannot be read.
    """
    try:
        storyboard, unread = _read(name, content)
    except BrokenXmlError as broken:
        return verdict(CHECKER, [broken.finding])
    arms = match_arms(network, concrete).arms if network and concrete else {}
    situation = Situation(storyboard, network, concrete, arms)
    findings = [*unread, *_road_file(storyboard, road_file)]
    findings += (finding for rule in RULES for finding in rule(situation))
    unconventional = [finding for rule in CONVENTIONS for finding in rule(situation)]
    findings += unconventional if concrete is not None else as_remarks(unconventional)
    detail = f"{len(storyboard.entities)} entities, {len(RULES) + len(CONVENTIONS) + 1} rules"
    return verdict(CHECKER, findings, detail)


def driven_from_outside(name: str, content: bytes) -> frozenset[str]:
    """The entities of a file that somebody else drives; none in a file that cannot be read."""
    try:
        storyboard, _ = _read(name, content)
    except BrokenXmlError:
        return frozenset()
    return storyboard.driven_from_outside


@lru_cache(maxsize=1)
def _read(name: str, content: bytes) -> tuple[Storyboard, tuple[Finding, ...]]:
    """The storyboard of a file, for all who ask for it one after the other.

    Raises:
        BrokenXmlError: it cannot be read.
    """
    return read_storyboard(parse_document(name, content, "OpenSCENARIO"))


def _road_file(storyboard: Storyboard, beside: str | None) -> Iterator[Finding]:
    """``xosc.road_file``: the road that the scenario names lies beside it."""
    named = storyboard.road_file
    if named is None:
        yield error("xosc.road_file", storyboard.name, "names no road file")
    elif beside is None or PurePosixPath(named).name != beside:
        message = f"names the road file {named!r}, which does not exist"
        yield error("xosc.road_file", storyboard.name, message)
