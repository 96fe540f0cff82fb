"""Good files of every kind, for tests to check as they are or broken on purpose."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from lxml import etree

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.export.opendrive import write_opendrive
from scegen.export.openscenario import write_openscenario
from scegen.motion import build_paths
from scegen.road import build_network, plan_road
from scegen.scenario.files import to_yaml
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.junction import ARM_COUNTS, Junction
from scegen.scenario.vocabulary import (
    DrivingSide,
    JunctionKind,
    Maneuver,
    ParticipantKind,
    Role,
)


def pytest_generate_tests(metafunc):
    """Tests with an argument ``junction`` run on every kind, size, side and number of lanes."""
    if "junction" in metafunc.fixturenames:
        junctions = [
            Junction(
                kind=kind,
                arms=arms,
                lanes=(lanes,) * arms,
                driving_side=side,
                ring_lanes=lanes if kind is JunctionKind.ROUNDABOUT else None,
                crosswalks=frozenset({0}),
            )
            for kind, (fewest, most) in ARM_COUNTS.items()
            for arms in range(fewest, most + 1)
            for lanes in (1, 2)
            for side in DrivingSide
        ]
        names = [f"{j.kind}-{j.arms}-{j.lanes[0]}-{j.driving_side}" for j in junctions]
        metafunc.parametrize("junction", junctions, ids=names)


@pytest.fixture(scope="session")
def road_file():
    """Write the road of a junction."""

    def write(junction: Junction, **planned) -> bytes:
        written = write_opendrive(build_network(plan_road(junction, **planned)))
        return written.encode() if isinstance(written, str) else written

    return write


@pytest.fixture(scope="session")
def four_way(road_file):
    return road_file(Junction(kind=JunctionKind.FOUR_WAY, arms=4))


@pytest.fixture(scope="session")
def straight(road_file):
    return road_file(Junction(kind=JunctionKind.STRAIGHT, arms=2))


@pytest.fixture
def winding(road_file):
    """A crossing with U-turns, whose connecting roads have several geometries, as XML to edit."""
    junction = Junction(kind=JunctionKind.FOUR_WAY, arms=4)
    return etree.fromstring(road_file(junction, u_turns=frozenset(range(4))))


@pytest.fixture
def tree(four_way):
    """The four-way crossing as XML to edit."""
    return etree.fromstring(four_way)


def functional(junction: Junction) -> FunctionalScenario:
    """An ego, a car, a parked van and a pedestrian who crosses."""
    return FunctionalScenario(
        description="for tests",
        junction=junction,
        participants=(
            Participant(id="ego", role=Role.EGO),
            Participant(id="car"),
            Participant(id="van", kind=ParticipantKind.VAN, parked=True),
            Participant(
                id="walker", kind=ParticipantKind.PEDESTRIAN, maneuvers=frozenset({Maneuver.CROSS})
            ),
        ),
    )


def write_folder(folder: Path, concrete) -> Path:
    network = build_network(concrete.road, concrete.name)
    paths = build_paths(concrete, network)
    road = write_opendrive(network)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "road.xodr").write_bytes(road.encode() if isinstance(road, str) else road)
    scenario = write_openscenario(concrete, paths, road_file="road.xodr")
    (folder / "scenario.xosc").write_bytes(scenario)
    (folder / "concrete.yaml").write_text(to_yaml(concrete), encoding="utf-8")
    return folder


@pytest.fixture(scope="session")
def write():
    """Write the folder of a concrete scenario."""
    return write_folder


@pytest.fixture(scope="session")
def make_folder(tmp_path_factory):
    """Write the scenario folder of a junction's first scenario."""

    def make(junction: Junction) -> Path:
        described = functional(junction)
        logical = enumerate_scenarios(described).scenarios[0]
        return write_folder(tmp_path_factory.mktemp("made") / "s", concretize(described, logical))

    return make


@pytest.fixture(scope="session")
def good_folder(make_folder):
    return make_folder(Junction(kind=JunctionKind.FOUR_WAY, arms=4))


@pytest.fixture
def folder(good_folder, tmp_path):
    """A copy of the good folder, to break."""
    return Path(shutil.copytree(good_folder, tmp_path / "scenario"))
