"""OpenSCENARIO files: a concrete scenario and its paths as one self-contained XML document.

Version 1.0 is the one that esmini and CARLA's scenario_runner both play; everything is inline,
and only constructs that both understand are used. Version 1.2 is its twin for checkers whose
rules start there.
"""

import xml.etree.ElementTree as ET  # builds, never parses
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from datetime import datetime
from threading import Lock

from scegen.errors import InputError
from scegen.export.library import VersionBase, xosc
from scegen.export.openscenario_entities import entities
from scegen.export.openscenario_numbers import numbers_of
from scegen.export.openscenario_parameters import (
    VERSION,
    Parameterisation,
    declarations,
    distribution,
)
from scegen.export.openscenario_signals import controllers
from scegen.export.openscenario_storyboard import storyboard
from scegen.export.openscenario_text import header_description, xml_text
from scegen.motion.model import Path
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.wording import counted

"""Who drives the ego: the file, or somebody outside it."""
_MINOR: dict[str, int] = {"1.0": 0, "1.2": 2}
_DATE = datetime(2024, 1, 1)  # without a zone: strptime-based readers take none
"""A fixed date, or files of the same scenario would differ from run to run."""
_VERSION_LOCK = Lock()
"""The library keeps the version of the standard in a global."""


def write_openscenario(
    concrete: ConcreteScenario,
    paths: Mapping[str, Path],
    *,
    road_file: str = "road.xodr",
    version: str = "1.0",
    external_ego: bool = False,
    lamps: bool = False,
) -> bytes:
    """The scenario as an OpenSCENARIO file; the same input gives the same bytes.

    A path of one vertex means that it stands. ``road_file`` is where the OpenDRIVE file lies, as
    seen from the scenario file; ``version`` is ``1.0`` or ``1.2``. An ``external_ego`` is placed
    with its speed and has no motion of its own, for a driver outside the file. With ``lamps``,
    lights are changed by actions as well, as esmini needs it and others refuse it.

    Raises:
        InputError: the version is none of these, or a participant has no path.
    """
    if version not in _MINOR:
        raise InputError(
            f"OpenSCENARIO {version} cannot be written", hint=f"use {' or '.join(_MINOR)}"
        )
    missing = [p.id for p in concrete.participants if p.id not in paths]
    if missing:
        raise InputError(f"no path for {', '.join(missing)}", where=concrete.name)
    with _library_writes(_MINOR[version]) as minor:
        numbers = numbers_of(concrete, paths)
        return _scenario(
            header_description(concrete.name),
            xosc.ParameterDeclarations(),
            entities(concrete, external_ego=external_ego),
            storyboard(concrete, paths, numbers, minor, external_ego=external_ego, lamps=lamps),
            _roads(concrete, road_file),
            minor,
        )


def write_parameterised(
    concrete: ConcreteScenario,
    paths: Mapping[str, Path],
    parameters: Parameterisation,
    *,
    road_file: str = "road.xodr",
) -> bytes:
    """The scenario with parameters in place of numbers; their defaults are its own numbers."""
    with _library_writes(_MINOR[VERSION]) as minor:
        return _scenario(
            xml_text(f"{header_description(concrete.name)}. {parameters.note}"),
            declarations(parameters.declared),
            entities(parameters.fastest),
            storyboard(concrete, paths, parameters.numbers, minor),
            _roads(concrete, road_file),
            minor,
        )


def write_distribution(
    concrete: ConcreteScenario, scenario_file: str, sets: Sequence[Mapping[str, float]]
) -> bytes:
    """The file of values with which a parameterised scenario is played, set after set."""
    with _library_writes(_MINOR[VERSION]) as minor:
        values = f"{counted(len(sets), 'set')} of its parameters"
        description = f"{header_description(concrete.name)}: {values}"
        made = distribution(description, xml_text(scenario_file), sets, minor)
        made.header.creation_date = _DATE
        return _document(made.get_element())


def _scenario(
    description: str,
    declared: xosc.ParameterDeclarations,
    who: xosc.Entities,
    board: xosc.StoryBoard,
    roads: xosc.RoadNetwork,
    minor: int,
) -> bytes:
    made = xosc.Scenario(
        description,
        "ML-SceGen",
        declared,
        who,
        board,
        roads,
        xosc.Catalog(),
        osc_minor_version=minor,
        creation_date=_DATE,
    )
    return _document(made.get_element())


def _roads(concrete: ConcreteScenario, road_file: str) -> xosc.RoadNetwork:
    roads = xosc.RoadNetwork(xml_text(road_file))
    for controller in controllers(concrete.signals) if concrete.signals else ():
        roads.add_traffic_signal_controller(controller)
    return roads


@contextmanager
def _library_writes(minor: int) -> Iterator[int]:
    """Nobody else writes meanwhile, and the library's version is put back."""
    with _VERSION_LOCK:
        before = VersionBase.version_minor
        try:
            VersionBase().setVersion(minor=minor)
            yield minor
        finally:
            VersionBase().setVersion(minor=before)


def _document(root: ET.Element) -> bytes:
    ET.indent(root)
    text = ET.tostring(root, encoding="unicode")
    return f"<?xml version='1.0' encoding='utf-8'?>\n{text}\n".encode()
