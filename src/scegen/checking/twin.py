"""The OpenSCENARIO 1.2 twin of a generated scenario: of 1.0, ASAM checks 5 of its 17 rules."""

from __future__ import annotations

from typing import NamedTuple

from scegen.export.openscenario import write_openscenario
from scegen.motion import build_paths
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario


class Twin(NamedTuple):
    """The scenario in both versions, as the generator writes them."""

    played: bytes
    checked: bytes


def make_twin(concrete: ConcreteScenario, road_file: str, ego: str = "scripted") -> Twin:
    """Write a concrete scenario in versions 1.0 and 1.2.

    The twin speaks for a file only if ``played`` is that file, byte for byte. ``ego`` says who
    drives it, as in :func:`write_openscenario`.

    Raises:
        InfeasibleError: the concrete scenario cannot be built.
    """
    network = build_network(concrete.road)
    paths = build_paths(concrete, network)
    played, checked = (
        write_openscenario(concrete, paths, road_file=road_file, version=version, ego=ego)
        for version in ("1.0", "1.2")
    )
    return Twin(played, checked)
