"""Good scenarios are clean; each way of breaking one is caught, with its place."""

from __future__ import annotations

import copy
import shutil
from cmath import exp

import pytest
from lxml import etree

from scegen.checking import CheckStatus, check_folder
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.files import load, to_yaml
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import JunctionKind

OWN = ("opendrive", "openscenario")


@pytest.fixture
def root(folder):
    return etree.parse(folder / "scenario.xosc").getroot()


def trajectory(root, entity):
    """The vertices of an entity's trajectory, with their parent."""
    for group in root.iter("ManeuverGroup"):
        if group.find(f"Actors/EntityRef[@entityRef='{entity}']") is not None:
            polyline = group.find(".//Polyline")
            return polyline, polyline.findall("Vertex")
    raise AssertionError(entity)


def world(vertex):
    return vertex.find("Position/WorldPosition")


def teleport(root, entity):
    return root.find(f".//Private[@entityRef='{entity}']//TeleportAction/Position")


def move(element, **by):
    for name, step in by.items():
        element.set(name, repr(float(element.get(name)) + step))


def caught(folder, root, rule, place):
    """The file fails by this rule at this place, and says something."""
    (folder / "scenario.xosc").write_bytes(etree.tostring(root))
    result = check_folder(folder, OWN).result("openscenario")
    assert result.status is CheckStatus.FAILED
    found = [finding for finding in result.findings if finding.rule == rule]
    assert found, [(f.rule, f.place, f.message) for f in result.findings]
    assert any(place in f.place or place in f.message for f in found), found
    return found


def test_good_scenarios_are_clean(junction, make_folder):
    report = check_folder(make_folder(junction), OWN)
    assert [finding for result in report.results for finding in result.findings] == []
    assert report.ok


def test_unknown_entity(folder, root):
    root.find(".//Actors/EntityRef").set("entityRef", "nobody")
    caught(folder, root, "xosc.entity", "nobody")


def test_unknown_entity_in_a_condition(folder, root):
    private = root.find(".//Private")
    private.set("entityRef", "nobody")
    found = caught(folder, root, "xosc.entity", "scenario.xosc:")
    assert "<Private>" in found[0].place


def test_two_entities_of_one_name(folder, root):
    entities = root.find("Entities")
    entities.append(copy.deepcopy(entities[1]))
    caught(folder, root, "xosc.entity", "is the name of 2")


@pytest.mark.parametrize("count", [0, 2])
def test_not_exactly_one_ego(folder, root, count):
    properties = root.findall(".//ScenarioObject//Property[@value='ego_vehicle']")
    assert len(properties) == 1
    if count == 0:
        properties[0].set("value", "simulation")
    else:
        other = root.find(".//ScenarioObject[@name='car']/Vehicle/Properties")
        other.append(copy.deepcopy(properties[0]))
    caught(folder, root, "xosc.ego", "exactly one")


def test_the_wrong_ego(folder, root):
    ego = root.find(".//ScenarioObject//Property[@value='ego_vehicle']")
    other = root.find(".//ScenarioObject[@name='car']/Vehicle/Properties")
    other.append(copy.deepcopy(ego))
    ego.getparent().remove(ego)
    caught(folder, root, "xosc.ego", "car")


def test_missing_participant(folder, root):
    gone = root.find(".//ScenarioObject[@name='van']")
    gone.getparent().remove(gone)
    caught(folder, root, "xosc.participants", "van")
    caught(folder, root, "xosc.entity", "van")


def test_road_file_that_does_not_exist(folder, root):
    root.find("RoadNetwork/LogicFile").set("filepath", "elsewhere.xodr")
    caught(folder, root, "xosc.road_file", "elsewhere.xodr")


@pytest.mark.parametrize(
    ("road", "lane", "s", "words"),
    [("1", "-9", "5", "lane -9"), ("4711", "-1", "5", "road 4711"), ("1", "-1", "9999", "9999")],
)
def test_lane_position_that_does_not_exist(folder, root, road, lane, s, words):
    position = teleport(root, "car")
    position.clear()
    etree.SubElement(position, "LanePosition", roadId=road, laneId=lane, s=s)
    caught(folder, root, "xosc.lane_position", words)


def test_start_beside_the_road(folder, root):
    move(world(teleport(root, "ego").getparent()), x=500.0, y=500.0)
    caught(folder, root, "xosc.start", "ego")
    caught(folder, root, "xosc.trajectory_start", "ego")


def test_start_on_the_wrong_side(folder, root):
    """Half a road to the left: the oncoming lane."""
    position = world(teleport(root, "ego").getparent())
    heading = float(position.get("h"))
    shift = 3.5j * exp(1j * heading)
    move(position, x=shift.real, y=shift.imag)
    found = caught(folder, root, "xosc.start", "ego")
    assert "lane" in found[0].message


def test_nobody_teleported(folder, root):
    private = root.find(".//Private[@entityRef='van']")
    private.getparent().remove(private)
    caught(folder, root, "xosc.start", "van")


def test_parked_vehicle_elsewhere(folder, root):
    move(world(teleport(root, "van").getparent()), x=300.0, y=-300.0)
    caught(folder, root, "xosc.start", "van")


def test_jump(folder, root):
    _, vertices = trajectory(root, "ego")
    for vertex in vertices[len(vertices) // 2 :]:
        move(world(vertex), x=20.0, y=20.0)
    caught(folder, root, "xosc.trajectory", "ego")
    caught(folder, root, "xosc.off_road", "ego")


def test_kink(folder, root):
    _, vertices = trajectory(root, "ego")
    middle = world(vertices[len(vertices) // 2])
    move(middle, x=0.3, y=-0.3)
    found = caught(folder, root, "xosc.trajectory", "ego")
    assert "vertex" in found[0].message


def test_heading_against_the_way(folder, root):
    _, vertices = trajectory(root, "ego")
    move(world(vertices[3]), h=3.0)
    caught(folder, root, "xosc.trajectory", "vertex 3")


def test_times_that_fall(folder, root):
    _, vertices = trajectory(root, "ego")
    vertices[-1].set("time", "0")
    vertices[-2].set("time", "5")
    caught(folder, root, "xosc.trajectory", "times")


def test_missing_trajectory(folder, root):
    polyline, _ = trajectory(root, "car")
    event = next(e for e in polyline.iterancestors("Event"))
    event.getparent().remove(event)
    caught(folder, root, "xosc.missing_trajectory", "car")


def test_wrong_exit(folder):
    """The file leads to one arm, concrete.yaml says another."""
    path = folder / "concrete.yaml"
    concrete = load(path, ConcreteScenario)
    ego = concrete.ego
    assert isinstance(ego.motion, DriveMotion)
    other = next(
        a.id for a in concrete.road.arms if a.id not in {ego.motion.entry, ego.motion.exit}
    )
    changed = ego.model_copy(update={"motion": ego.motion.model_copy(update={"exit": other})})
    everyone = tuple(changed if p.id == ego.id else p for p in concrete.participants)
    edited = concrete.model_copy(update={"participants": everyone})
    path.write_text(to_yaml(edited), encoding="utf-8")
    result = check_folder(folder, OWN).result("openscenario")
    assert [(f.rule, f.place) for f in result.findings] == [("xosc.exit", "ego")]
    assert f"arm {other}" in result.findings[0].message


def test_trajectory_that_ends_early(folder, root):
    polyline, vertices = trajectory(root, "ego")
    for vertex in vertices[len(vertices) // 3 :]:
        polyline.remove(vertex)
    caught(folder, root, "xosc.exit", "ego")


def test_crosser_who_does_not_cross(folder, root):
    _, vertices = trajectory(root, "walker")
    for vertex in vertices:
        move(world(vertex), x=300.0, y=300.0)
    caught(folder, root, "xosc.crossing", "walker")


def test_road_of_another_scenario(folder, straight):
    (folder / "road.xodr").write_bytes(straight)
    report = check_folder(folder, OWN)
    assert {f.rule for f in report.result("opendrive").findings} == {"xodr.arms"}


def test_road_with_another_number_of_lanes(folder, road_file):
    wider = Junction(kind=JunctionKind.FOUR_WAY, arms=4, lanes=(1, 2, 1, 1))
    (folder / "road.xodr").write_bytes(road_file(wider))
    findings = check_folder(folder, OWN).result("opendrive").findings
    assert any(f.rule == "xodr.described" and "arm 1" in f.place for f in findings)


@pytest.mark.parametrize(
    ("path", "attribute", "value", "words"),
    [
        ("type/speed", "max", "99", "speed limit"),
        ("type/speed", "unit", "mph", "speed limit"),
        ("objects/object", "type", "tree", "no crosswalk"),
        ("objects/object", "s", "500", "outside the road"),
    ],
)
def test_road_that_is_not_as_described(make_folder, tmp_path, path, attribute, value, words):
    junction = Junction(kind=JunctionKind.T, arms=3, crosswalks=frozenset({0}))
    folder = shutil.copytree(make_folder(junction), tmp_path / "scenario")
    road = etree.parse(folder / "road.xodr").getroot()
    road.find(f"road/{path}").set(attribute, value)
    (folder / "road.xodr").write_bytes(etree.tostring(road))
    findings = check_folder(folder, OWN).result("opendrive").findings
    assert [(f.rule, words in f.message) for f in findings] == [("xodr.described", True)]


@pytest.mark.parametrize(
    ("content", "rule"),
    [
        (b"", "xml.well_formed"),
        (b"<OpenDRIVE/>", "xml.root"),
        (b"<!DOCTYPE a []><OpenSCENARIO/>", "xml.no_doctype"),
        (b"<OpenSCENARIO/>", "xosc.road_file"),
    ],
)
def test_broken_files_are_findings(folder, content, rule):
    (folder / "scenario.xosc").write_bytes(content)
    result = check_folder(folder, OWN).result("openscenario")
    assert result.status is CheckStatus.FAILED
    assert rule in {finding.rule for finding in result.findings}


def test_numbers_that_are_none(folder, root):
    _, vertices = trajectory(root, "ego")
    world(vertices[0]).set("x", "inf")
    caught(folder, root, "xosc.readable", "scenario.xosc:")
