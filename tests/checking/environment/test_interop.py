"""Generated roads are taken by validators that share no code with us: ASAM, CARLA, netconvert."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from lxml import etree

from scegen.checking.asam import OPENDRIVE, Job, run_asam
from scegen.checking.environment import INTEROP_HINT, asam_python, interop_python
from scegen.checking.limits import run_limited
from scegen.checking.results import CheckStatus
from scegen.export.opendrive import write_opendrive
from scegen.road import build_network, plan_road
from scegen.scenario.junction import ARM_COUNTS, Junction
from scegen.scenario.roadway import AuxiliaryLane, Carriageway
from scegen.scenario.vocabulary import DrivingSide, JunctionKind

pytestmark = pytest.mark.interop

JUNCTIONS = [
    Junction(
        kind=kind,
        arms=arms,
        lanes=(lanes,) * arms,
        driving_side=side,
        ring_lanes=lanes if kind is JunctionKind.ROUNDABOUT else None,
        crosswalks=frozenset({0}),
    )
    for kind, counts in ARM_COUNTS.items()
    for arms in sorted(set(counts))
    for lanes in (1, 2)
    for side in DrivingSide
]
JUNCTIONS += [
    Junction(
        kind=JunctionKind.STRAIGHT,
        arms=2,
        lanes=(2, 2),
        carriageway=carriageway,
        auxiliary=auxiliary,
        driving_side=side,
    )
    for auxiliary in AuxiliaryLane
    for carriageway in Carriageway
    for side in DrivingSide
]
NAMES = [
    f"{j.auxiliary or j.kind}-{j.arms}-{j.lanes[0]}-{j.driving_side}-{j.carriageway}"
    for j in JUNCTIONS
]


ARM_M = 400.0
"""Long enough for an acceleration lane."""


@pytest.fixture(scope="module")
def road_files(tmp_path_factory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("roads")
    files = {}
    for name, junction in zip(NAMES, JUNCTIONS, strict=True):
        written = write_opendrive(build_network(plan_road(junction, arm_length_m=ARM_M)))
        files[name] = folder / f"{name}.xodr"
        files[name].write_bytes(written.encode() if isinstance(written, str) else written)
    return files


@pytest.fixture(scope="module")
def validators() -> Path:
    """The python of the environment with CARLA and netconvert."""
    python = interop_python()
    if python is None:
        pytest.skip(f"carla and netconvert are not installed; {INTEROP_HINT}")
    return python


@pytest.mark.asam
def test_asam_takes_every_road(road_files):
    if asam_python() is None:
        pytest.skip("the ASAM checkers are not installed; run: make asam")
    ran = run_asam([Job(path.read_bytes()) for path in road_files.values()])
    for name, [result] in zip(road_files, ran, strict=True):
        assert result.checker == OPENDRIVE
        assert result.status is CheckStatus.PASSED, (name, result.findings)
        assert result.detail.startswith("23 of 23")


@pytest.mark.parametrize("name", NAMES)
def test_carla_takes_the_road(name, road_files, validators):
    probe = Path(__file__).with_name("carla_probe.py")
    command = [str(validators), str(probe), str(road_files[name])]
    ran = run_limited(command, road_files[name].parent, timeout_s=60)
    assert ran.code == 0, ran.output
    found = json.loads(ran.output.splitlines()[-1])
    roads = etree.parse(road_files[name]).findall("road")
    assert found["roads"] == sorted(int(road.get("id")) for road in roads)
    assert found["topology"] >= len([r for r in roads if r.get("junction") != "-1"])
    assert found["stuck_in_junction"] == 0


@pytest.mark.parametrize("name", NAMES)
def test_netconvert_takes_the_road(name, road_files, validators, tmp_path):
    netconvert = validators.with_name("netconvert")
    command = [str(netconvert), "--opendrive-files", str(road_files[name]), "-o", "o.net.xml"]
    ran = run_limited(command, tmp_path, timeout_s=60)
    assert ran.code == 0, ran.output
    assert "Error" not in ran.output
    net = etree.parse(tmp_path / "o.net.xml")
    ways = [edge for edge in net.iterfind("edge") if edge.get("function") != "internal"]
    arms = [
        road
        for road in etree.parse(road_files[name]).iterfind("road")
        if road.get("junction") == "-1"
    ]
    assert len(ways) >= len(arms)
    assert net.findall("connection")
