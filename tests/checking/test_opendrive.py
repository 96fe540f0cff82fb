"""Good files are clean; each way of breaking one is caught, with its place."""

from __future__ import annotations

import copy

import pytest
from lxml import etree

from scegen.checking.opendrive import check_opendrive
from scegen.checking.results import CheckStatus, Severity
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import DrivingSide, JunctionKind


def arm(root):
    return next(road for road in root.iterfind("road") if road.get("junction") == "-1")


def bend(root):
    """A connecting road with an arc."""
    return next(
        road
        for road in root.iterfind("road")
        if road.get("junction") != "-1" and road.find("planView/geometry/arc") is not None
    )


def driving_lane(road):
    return next(lane for lane in road.iter("lane") if lane.get("type") == "driving")


def shift(element, name, by):
    element.set(name, repr(float(element.get(name)) + by))


def caught(root, rule, place, severity=Severity.ERROR):
    """The file fails by this rule at this place, and says something.

    A convention of ours binds roads of ours; on a road alone it is a remark.
    """
    result = check_opendrive("road.xodr", etree.tostring(root)).result
    assert severity is not Severity.ERROR or result.status is CheckStatus.FAILED
    found = [f for f in result.findings if (f.rule, f.severity) == (rule, severity)]
    assert found, [(f.rule, f.place, f.message) for f in result.findings]
    assert any(place in f.place or place in f.message for f in found), [f.place for f in found]
    assert all(f.message for f in found)
    return found


def test_good_files_are_clean(junction, road_file):
    result = check_opendrive("road.xodr", road_file(junction)).result
    assert result.findings == ()
    assert result.status is CheckStatus.PASSED


@pytest.mark.parametrize("side", DrivingSide)
def test_u_turns_and_parking_lanes_are_clean(side, road_file):
    junction = Junction(kind=JunctionKind.T, arms=3, driving_side=side)
    content = road_file(junction, u_turns=frozenset(range(3)), parking_lanes=frozenset({1}))
    assert check_opendrive("road.xodr", content).result.findings == ()


def test_gap_at_a_junction(tree):
    road = bend(tree)
    for geometry in road.iterfind("planView/geometry"):
        shift(geometry, "x", 0.02)
    found = caught(tree, "xodr.lane_gap", f"road {road.get('id')} lane")
    assert "0.020 m" in found[0].message


def test_gap_inside_a_road(winding):
    road = max(winding.iterfind("road"), key=lambda r: len(r.findall("planView/geometry")))
    shift(road.findall("planView/geometry")[1], "y", 26.0)
    caught(winding, "xodr.road_gap", f"road {road.get('id')} s = ")


def test_a_gap_within_tolerance_is_none(tree):
    for geometry in bend(tree).iterfind("planView/geometry"):
        shift(geometry, "x", 0.004)
    assert check_opendrive("road.xodr", etree.tostring(tree)).result.findings == ()


def test_kink_inside_a_road(winding):
    road = max(winding.iterfind("road"), key=lambda r: len(r.findall("planView/geometry")))
    shift(road.findall("planView/geometry")[1], "hdg", 0.02)
    found = caught(winding, "xodr.road_kink", f"road {road.get('id')}")
    assert "1.15°" in found[0].message


def test_kink_at_a_junction(tree):
    road = arm(tree)
    shift(road.findall("planView/geometry")[-1], "hdg", 0.0175)
    caught(tree, "xodr.lane_kink", f"road {road.get('id')} lane")


def test_stations_that_do_not_add_up(tree):
    road = bend(tree)
    shift(road, "length", 1.0)
    caught(tree, "xodr.stations", f"road {road.get('id')}")


def test_folded_lane(tree):
    road = bend(tree)
    lane = driving_lane(road)
    for width in lane.iterfind("width"):
        width.set("a", "40")
    caught(tree, "xodr.lane_fold", f"road {road.get('id')} lane {lane.get('id')}")


def test_lane_over_itself(tree):
    road = bend(tree)
    plan = road.find("planView")
    first = copy.deepcopy(plan[0])
    del plan[:]
    plan.append(first)
    for shape in list(first):
        first.remove(shape)
    etree.SubElement(first, "arc", curvature="0.1")
    first.set("length", "90")
    road.set("length", "90")
    caught(tree, "xodr.lane_overlap", f"road {road.get('id')}")


def test_width_step_at_a_junction(tree):
    road = arm(tree)
    lane = driving_lane(road)
    lane.find("width").set("a", "3.6")
    caught(tree, "xodr.lane_step", f"road {road.get('id')} lane {lane.get('id')}")


def test_width_step_inside_a_road(tree):
    road = arm(tree)
    lane = driving_lane(road)
    width = lane.find("width")
    wider = copy.deepcopy(width)
    wider.set("sOffset", "20")
    wider.set("a", "3.2")
    width.addnext(wider)
    caught(tree, "xodr.width_step", f"road {road.get('id')} lane {lane.get('id')}")


def test_width_that_is_not_positive(tree):
    road = arm(tree)
    lane = driving_lane(road)
    lane.find("width").set("b", "-0.1")
    caught(tree, "xodr.lane_width", f"road {road.get('id')} lane {lane.get('id')}")


def test_missing_elevation(tree):
    road = bend(tree)
    road.remove(road.find("elevationProfile"))
    caught(tree, "xodr.elevation", f"road {road.get('id')}", Severity.WARNING)


def test_height_step(tree):
    road = bend(tree)
    road.find("elevationProfile/elevation").set("a", "0.5")
    caught(tree, "xodr.lane_step", f"road {road.get('id')}")


def test_wrong_version(tree):
    tree.find("header").set("revMinor", "5")
    caught(tree, "xodr.version", "header", Severity.WARNING)


def test_geometry_that_is_neither_line_nor_arc(tree):
    road = bend(tree)
    geometry = next(g for g in road.iterfind("planView/geometry") if g.find("arc") is not None)
    geometry.remove(geometry.find("arc"))
    etree.SubElement(geometry, "spiral", curvStart="0", curvEnd="0.1")
    caught(tree, "xodr.geometry_kind", f"road {road.get('id')}", Severity.WARNING)


def test_deleted_connection(tree):
    junction = tree.find("junction")
    gone = junction.find("connection")
    junction.remove(gone)
    caught(tree, "xodr.connecting_road", f"road {gone.get('connectingRoad')}")
    caught(tree, "xodr.reachable", "no way leads to", Severity.WARNING)


def test_deleted_connection_and_its_road(tree):
    """Nothing dangles, yet one can no longer drive from one arm to another."""
    junction = tree.find("junction")
    gone = junction.find("connection")
    junction.remove(gone)
    road = tree.find(f"road[@id='{gone.get('connectingRoad')}']")
    tree.remove(road)
    place = f"road {gone.get('incomingRoad')}"
    found = caught(tree, "xodr.reachable", place, Severity.WARNING)
    left = road.find("link/successor").get("elementId")
    assert f"road {left}" in found[0].message


def test_all_connections_of_an_arm_deleted(tree):
    junction = tree.find("junction")
    incoming = junction.find("connection").get("incomingRoad")
    for connection in junction.findall("connection"):
        if connection.get("incomingRoad") == incoming:
            junction.remove(connection)
    caught(tree, "xodr.dead_end", f"road {incoming} lane", Severity.WARNING)


def test_connection_of_an_unknown_road(tree):
    connection = tree.find("junction/connection")
    connection.set("incomingRoad", "4711")
    caught(tree, "xodr.connection", "road 4711")


def test_two_connections_of_one_id(tree):
    first, second = tree.findall("junction/connection")[:2]
    second.set("id", first.get("id"))
    caught(tree, "xodr.connection", f"connection {first.get('id')}")


def test_wrong_lane_link_of_a_connection(tree):
    link = tree.find("junction/connection/laneLink")
    link.set("from", str(-int(link.get("from"))))
    caught(tree, "xodr.connection", "leaves the junction")


@pytest.mark.parametrize("lane", ["-9", "0"])
def test_connection_from_a_lane_that_does_not_exist(tree, lane):
    connection = tree.find("junction/connection")
    connection.find("laneLink").set("from", lane)
    caught(tree, "xodr.connection", f"road {connection.get('incomingRoad')} lane {lane}")


def test_wrong_lane_link_of_a_connecting_road(tree):
    road = bend(tree)
    driving_lane(road).find("link/successor").set("id", "-9")
    caught(tree, "xodr.lane_link", f"road {road.get('id')} lane")


def test_lane_link_of_another_type(tree):
    road = bend(tree)
    driving_lane(road).set("type", "sidewalk")
    caught(tree, "xodr.lane_link", f"road {road.get('id')} lane")


def test_road_link_that_does_not_hold_both_ways(straight):
    root = etree.fromstring(straight)
    road, other = root.findall("road")[:2]
    road.remove(road.find("link"))
    caught(root, "xodr.road_link", f"road {other.get('id')}")


def test_connecting_road_that_leads_elsewhere(tree):
    road = bend(tree)
    others = {r.get("id") for r in tree.iterfind("road") if r.get("junction") == "-1"}
    link = road.find("link/successor")
    link.set("elementId", min(others - {link.get("elementId")}))
    caught(tree, "xodr.lane_gap", f"road {road.get('id')}")


def test_lane_link_that_does_not_hold_both_ways(straight):
    root = etree.fromstring(straight)
    road = root.find("road")
    lane = driving_lane(road)
    lane.remove(lane.find("link"))
    caught(root, "xodr.lane_link", f"road {road.get('id')} lane {lane.get('id')}")


def test_driving_side_that_does_not_fit_its_links(tree):
    road = arm(tree)
    road.set("rule", "LHT")
    caught(tree, "xodr.connection", f"road {road.get('id')}")


@pytest.mark.parametrize(
    ("content", "rule"),
    [
        (b"", "xml.well_formed"),
        (b"<OpenDRIVE><road></OpenDRIVE>", "xml.well_formed"),
        (b"<OpenSCENARIO/>", "xml.root"),
        (b'<!DOCTYPE a [<!ENTITY b "c">]><OpenDRIVE>&b;</OpenDRIVE>', "xml.no_doctype"),
        (b"<OpenDRIVE><header/></OpenDRIVE>", "xodr.readable"),
        (b'<OpenDRIVE><road id="1" length="ten"/></OpenDRIVE>', "xodr.readable"),
        (b'<OpenDRIVE><road id="1" length="nan"/></OpenDRIVE>', "xodr.readable"),
        (b"\x00\xff\xfe", "xml.well_formed"),
    ],
)
def test_broken_files_are_findings(content, rule):
    result = check_opendrive("road.xodr", content).result
    assert result.status is CheckStatus.FAILED
    assert rule in {finding.rule for finding in result.findings}
    assert "<string>" not in "".join(finding.message for finding in result.findings)


def test_entities_are_not_expanded():
    lols = "".join(f'<!ENTITY l{i} "&l{i - 1};&l{i - 1};">' for i in range(1, 40))
    content = f'<!DOCTYPE x [<!ENTITY l0 "lol">{lols}]><OpenDRIVE>&l39;</OpenDRIVE>'.encode()
    result = check_opendrive("road.xodr", content).result
    assert result.status is CheckStatus.FAILED
