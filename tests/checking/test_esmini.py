"""esmini's verdict: the log decides, and what was played must make sense."""

from __future__ import annotations

import numpy as np
import pytest
from lxml import etree

from scegen.checking import CheckStatus, Severity, check_folder
from scegen.checking.environment import esmini
from scegen.checking.esmini import check_esmini
from scegen.checking.esmini.log import check_log
from scegen.checking.esmini.movement import check_movements
from scegen.checking.esmini.playing import play
from scegen.checking.esmini.recording import Movement, RecordingError, read_recording
from scegen.checking.opendrive import check_opendrive
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load

needs_esmini = pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")


@pytest.fixture
def root(folder):
    return etree.parse(folder / "scenario.xosc").getroot()


@pytest.fixture
def concrete(folder):
    return load(folder / "concrete.yaml", ConcreteScenario)


def played(folder, root):
    (folder / "scenario.xosc").write_bytes(etree.tostring(root))
    return check_folder(folder, ["esmini"]).result("esmini")


def rules(result):
    return {f.rule for f in result.findings if f.severity is Severity.ERROR}


@pytest.mark.esmini
@needs_esmini
def test_good_scenario_plays(folder):
    result = check_folder(folder, ["esmini"]).result("esmini")
    assert rules(result) == set()
    assert result.status is CheckStatus.PASSED
    assert "4 entities" in result.detail


@pytest.mark.esmini
@needs_esmini
def test_two_plays_give_the_same_result(folder):
    assert check_folder(folder, ["esmini"]) == check_folder(folder, ["esmini"])


@pytest.mark.esmini
@needs_esmini
def test_unknown_entity(folder, root):
    root.find(".//Private").set("entityRef", "nobody")
    assert played(folder, root).status is CheckStatus.FAILED


@pytest.mark.esmini
@needs_esmini
def test_lane_that_does_not_exist(folder, root):
    """esmini ends with 0 and a warning in its log."""
    position = root.find(".//Private[@entityRef='van']//TeleportAction/Position")
    position.clear()
    etree.SubElement(position, "LanePosition", roadId="1", laneId="-9", s="5")
    result = played(folder, root)
    assert result.status is CheckStatus.FAILED
    assert "esmini.log" in rules(result)


@pytest.mark.esmini
@needs_esmini
def test_wrong_exit(folder, root):
    """The trajectory ends before the junction, and its vehicle with it."""
    for group in root.iter("ManeuverGroup"):
        if group.find("Actors/EntityRef[@entityRef='ego']") is not None:
            polyline = group.find(".//Polyline")
            vertices = polyline.findall("Vertex")
            for vertex in vertices[5:]:
                polyline.remove(vertex)
    assert "esmini.exit_arm" in rules(played(folder, root))


@pytest.mark.esmini
@needs_esmini
def test_standing_vehicle_that_moves(folder, root):
    speed = root.find(".//Private[@entityRef='van']//AbsoluteTargetSpeed")
    assert speed is not None
    speed.set("value", "3")
    assert "esmini.standing" in rules(played(folder, root))


@pytest.mark.esmini
@needs_esmini
def test_a_speed_out_of_this_world(folder, root):
    for speed in root.iter("AbsoluteTargetSpeed"):
        if float(speed.get("value")) > 0:
            speed.set("value", "90")
    for limits in root.iter("Performance"):
        limits.set("maxSpeed", "100")
    assert "esmini.speed" in rules(played(folder, root))


@pytest.mark.esmini
@needs_esmini
def test_missing_road(folder):
    (folder / "road.xodr").unlink()
    assert check_esmini(folder / "scenario.xosc").status is CheckStatus.FAILED


@pytest.mark.esmini
@needs_esmini
def test_scenario_that_does_not_end(folder):
    scenario = folder / "scenario.xosc"
    result = check_esmini(scenario, once=lambda: play(scenario, 0.001))
    assert rules(result) >= {"esmini.end"}


def test_without_esmini(folder, monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    result = check_folder(folder, ["esmini"]).result("esmini")
    assert result.status is CheckStatus.NOT_RUN
    assert "PATH" in result.detail


@pytest.mark.parametrize(
    ("line", "caught"),
    [
        ("[] [error] Failed to load", True),
        ("[1.500] [warn] Lane -9 not available", True),
        ("[] [warn] 3D model car_white.osgb not located, using specified file path", False),
        ("[0.000] [warn] Stopping Init ego TeleportAction on conflicting Lateral domain", False),
        ("[2.000] [warn] Stopping a b on conflicting Lateral domain(s)", True),
        ("[0.000] [info] all is well", False),
    ],
)
def test_log(line, caught):
    assert bool(list(check_log(line))) is caught


def test_contact_is_told_but_does_not_fail():
    [finding] = check_log("[5.050] [warn] Collision between ego and car")
    assert finding.severity is Severity.INFO
    assert finding.place == "t = 5.050 s"


@pytest.mark.parametrize("text", ["", "Index [-], TimeStamp [s]", "Index [-], #1 Entity_Name\n0,a"])
def test_recordings_that_cannot_be_read(text):
    with pytest.raises(RecordingError):
        read_recording(text)


def movement(name, speeds, start=0j, heading=1 + 0j, dt=0.05):
    speeds = np.asarray(speeds, dtype=float)
    points = start + heading * np.concatenate([[0.0], np.cumsum(speeds[1:] * dt)])
    heads = np.full(len(speeds), np.angle(heading))
    return Movement(name, np.arange(len(speeds)) * dt, points, speeds, heads)


def test_jump():
    steady = movement("a", [10.0] * 5)
    assert list(check_movements([steady], None, None)) == []
    points = steady.point.copy()
    points[3:] += 1.0
    [finding] = check_movements(
        [Movement("a", steady.time_s, points, steady.speed_mps, steady.heading_rad)], None, None
    )
    assert (finding.rule, finding.place) == ("esmini.jump", "a t = 0.15 s")


def test_acceleration_beyond_body_and_program(concrete):
    others = [movement(p.id, [0.0, 0.0]) for p in concrete.participants if p.id != "ego"]
    gentle = movement("ego", [10.0, 10.2, 10.4])
    harsh = movement("ego", [10.0, 15.0, 15.0])

    def found(ego):
        findings = check_movements([ego, *others], None, concrete)
        return {f.rule for f in findings if f.place.startswith("ego")}

    assert found(gentle) == set()
    assert found(harsh) == {"esmini.acceleration"}
    halted_for_good = movement("ego", [10.0, 10.0, 0.0, 0.0])
    halted_on_the_way = movement("ego", [10.0, 0.0, 0.3, 0.6])
    assert found(halted_for_good) == {"esmini.arrival"}
    assert found(halted_on_the_way) == {"esmini.acceleration"}


def test_participant_who_is_not_played(concrete):
    found = list(check_movements([], None, concrete))
    assert {f.place for f in found} == {p.id for p in concrete.participants}


def test_entry_and_exit_are_looked_up_on_the_road(folder, concrete):
    network = check_opendrive("road.xodr", (folder / "road.xodr").read_bytes()).network
    away = [movement(p.id, [0.0, 0.0], start=900 + 900j) for p in concrete.participants]
    found = {(f.rule, f.place) for f in check_movements(away, network, concrete)}
    assert {("esmini.entry", "ego"), ("esmini.exit_arm", "ego")} <= found
    assert ("esmini.crossing", "walker") in found
