"""A concrete scenario as files: road, scenario, the numbers themselves and a picture."""

from functools import lru_cache, partial

from scegen.checking.subject import CONCRETE_FILE, ROAD_FILE, SCENARIO_FILE
from scegen.export.opendrive import write_opendrive
from scegen.export.openscenario import write_openscenario
from scegen.motion import build_paths
from scegen.report.preview import preview_svg
from scegen.report.raster import png_of
from scegen.road import build_network
from scegen.road.build import KEPT
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import to_yaml
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.signals import SignalPlan

LAMPS_FILE = "scenario-esmini.xosc"
"""Beside the scenario where it has lights: the same, with them changed as esmini needs it."""
PREVIEW_FILE = "preview.png"


def export_scenario(
    concrete: ConcreteScenario, *, osc: str = "1.0", ego: str = "scripted", picture: bool = True
) -> dict[str, bytes]:
    """The files of one scenario folder by name.

    Args:
        concrete: the scenario.
        osc: version of OpenSCENARIO, ``1.0`` or ``1.2``.
        ego: ``scripted``, or ``external`` for a driver outside the scenario file.
        picture: whether there is a preview, which takes longer than all else.

    Raises:
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """
    network = build_network(concrete.road)
    paths = build_paths(concrete, network)
    external = ego == "external"
    write = partial(write_openscenario, concrete, paths, version=osc, external_ego=external)
    files = {
        ROAD_FILE: road_file(concrete.road, concrete.signals),
        SCENARIO_FILE: write(),
        CONCRETE_FILE: to_yaml(concrete).encode(),
    }
    if picture:
        files[PREVIEW_FILE] = png_of(preview_svg(concrete, network, paths))
    if concrete.signals is not None:
        files[LAMPS_FILE] = write(lamps=True)
    return files


@lru_cache(maxsize=KEPT)
def road_file(road: RoadParameters, signals: SignalPlan | None) -> bytes:
    """The OpenDRIVE file of a road with its lights; scenarios on equal ones share it.

    Raises:
        RoadInfeasibleError: it cannot be built.
    """
    text = write_opendrive(
        build_network(road),
        control=road.control,
        controlled_arms=road.controlled_arms,
        signals=signals,
    )
    return text.encode()
