"""A concrete scenario as files: road, scenario, the numbers themselves and a picture."""

from __future__ import annotations

from scegen.export.opendrive import write_opendrive
from scegen.export.openscenario import write_openscenario
from scegen.motion import build_paths
from scegen.report.preview import preview_png
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import to_yaml

ROAD_FILE = "road.xodr"
SCENARIO_FILE = "scenario.xosc"
LAMPS_FILE = "scenario-esmini.xosc"
"""Beside the scenario where it has lights: the same, with them changed as esmini needs it."""
CONCRETE_FILE = "concrete.yaml"
PREVIEW_FILE = "preview.png"


def export_scenario(
    concrete: ConcreteScenario, *, osc: str = "1.0", ego: str = "scripted"
) -> dict[str, bytes]:
    """The files of one scenario folder by name.

    Args:
        concrete: the scenario.
        osc: version of OpenSCENARIO, ``1.0`` or ``1.2``.
        ego: ``scripted``, or ``external`` for a driver outside the scenario file.

    Raises:
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """
    network = build_network(concrete.road, name=concrete.name)
    paths = build_paths(concrete, network)
    files = {
        ROAD_FILE: write_opendrive(
            network,
            control=concrete.road.control,
            controlled_arms=concrete.road.controlled_arms,
            signals=concrete.signals,
        ).encode(),
        SCENARIO_FILE: write_openscenario(
            concrete, paths, road_file=ROAD_FILE, version=osc, ego=ego
        ),
        CONCRETE_FILE: to_yaml(concrete).encode(),
        PREVIEW_FILE: preview_png(concrete, network, paths),
    }
    if concrete.signals is not None:
        files[LAMPS_FILE] = write_openscenario(
            concrete, paths, road_file=ROAD_FILE, version=osc, ego=ego, lamps=True
        )
    return files
