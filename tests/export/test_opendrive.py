"""The OpenDRIVE text says what the network says."""

import shutil
import subprocess
from math import isclose
from pathlib import Path

import pytest
from lxml import etree

from scegen.export.opendrive import write_opendrive
from scegen.road import build_network, plan_road
from scegen.road.fillet import wrapped
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import Control

SCHEMAS = sorted(
    (Path(__file__).parents[2] / ".venv/asam").glob(
        "lib/python*/site-packages/qc_opendrive/schema/1.7.0/*ore.xsd"
    )
)
SHAPES = [
    ("straight", 2, {"lanes": (2, 2)}),
    ("straight", 2, {"arm_angles_deg": (0, 150)}),
    ("t", 3, {"driving_side": "left"}),
    ("y", 3, {"lanes": (1, 2, 3)}),
    ("four_way", 4, {"lanes": (2,) * 4}),
    ("skewed", 4, {}),
    ("multi_way", 6, {}),
    ("roundabout", 4, {"ring_lanes": 2, "lanes": (2,) * 4}),
    ("roundabout", 3, {"driving_side": "left"}),
]


def network_of(shape):
    kind, arms, more = shape
    junction = Junction(kind=kind, arms=arms, crosswalks={1}, **more)
    turns = () if kind == "straight" else {0}
    return build_network(plan_road(junction, parking_lanes={0}, u_turns=turns), "sample")


@pytest.fixture(params=SHAPES, ids=lambda shape: f"{shape[0]}-{shape[1]}")
def network(request):
    return network_of(request.param)


@pytest.fixture
def root(network):
    return etree.fromstring(write_opendrive(network))


def test_same_input_same_text(network):
    first = write_opendrive(network, control=Control.STOP)
    assert write_opendrive(network, control=Control.STOP) == first
    assert first.startswith("<?xml")


def test_header(root):
    header = root.find("header")
    assert (header.get("revMajor"), header.get("revMinor")) == ("1", "7")
    assert (header.get("name"), header.get("vendor")) == ("sample", "ML-SceGen")
    assert float(header.get("west")) < 0 < float(header.get("east"))


def test_plan_view_is_the_reference_line(network, root):
    for road in network.roads:
        element = root.find(f"road[@id='{road.id}']")
        assert isclose(float(element.get("length")), road.length_m, abs_tol=1e-6)
        assert element.get("junction") == str(-1 if road.junction is None else road.junction)
        assert element.get("rule") == ("RHT" if road.driving_side == "right" else "LHT")
        assert element.find("elevationProfile/elevation") is not None
        assert float(element.find("type/speed").get("max")) == road.speed_limit_mps
        geometries = element.findall("planView/geometry")
        s = 0.0
        for geometry, segment in zip(geometries, road.line.segments, strict=True):
            pose = segment.start
            numbers = [float(geometry.get(name)) for name in ("s", "x", "y", "hdg", "length")]
            assert numbers == pytest.approx(
                [s, pose.x_m, pose.y_m, wrapped(pose.heading_rad), segment.length_m], abs=1e-6
            )
            arc = geometry.find("arc")
            curvature = 0.0 if arc is None else float(arc.get("curvature"))
            assert curvature == pytest.approx(segment.curvature_1pm, abs=1e-8)
            s += segment.length_m


def test_lanes_and_links(network, root):
    for road in network.roads:
        element = root.find(f"road[@id='{road.id}']")
        offset = element.find("lanes/laneOffset")
        assert (0.0 if offset is None else float(offset.get("a"))) == road.lane_offset_m
        written = {int(lane.get("id")): lane for lane in element.iterfind(".//lane")}
        assert written.keys() == {0} | {lane.id for lane in road.lanes}
        for lane in road.lanes:
            assert written[lane.id].get("type") == lane.type
            assert float(written[lane.id].find("width").get("a")) == lane.width_m
            for name in ("predecessor", "successor"):
                link = written[lane.id].find(f"link/{name}")
                found = None if link is None else int(link.get("id"))
                assert found == getattr(lane, name)
        for name in ("predecessor", "successor"):
            wanted, link = getattr(road, name), element.find(f"link/{name}")
            if wanted is None:
                assert link is None
            else:
                attributes = (link.get("elementType"), int(link.get("elementId")))
                assert attributes == (wanted.element, wanted.id)
                assert link.get("contactPoint") == wanted.contact


def test_junctions(network, root):
    written = [
        (int(j.get("id")), *(int(c.get(k)) for k in ("id", "incomingRoad", "connectingRoad")), link)
        for j in root.iterfind("junction")
        for c in j.iterfind("connection")
        for link in [(int(x.get("from")), int(x.get("to"))) for x in c.iterfind("laneLink")]
    ]
    assert written == [
        (j.id, c.id, c.incoming_road, c.connecting_road, (c.from_lane, c.to_lane))
        for j in network.junctions
        for c in j.connections
    ]


def test_crosswalk_for_both_readers(network, root):
    (item,) = root.iterfind(".//object")
    (crosswalk,) = network.arm_road(1).crosswalks
    assert float(item.get("s")) == pytest.approx(crosswalk.s_m)
    inner = item.findall("outlines/outline/cornerLocal")
    outer = item.findall("outline/cornerLocal")
    middle = float(item.get("t"))
    assert max(float(c.get("v")) for c in inner) + middle == pytest.approx(crosswalk.t_max_m)
    assert min(float(c.get("v")) for c in inner) + middle == pytest.approx(crosswalk.t_min_m)
    places = [(c.get("u"), c.get("v")) for c in outer]
    assert places == [(c.get("u"), c.get("v")) for c in inner] + places[:1]


def marks(root, road):
    lanes = root.iterfind(f"road[@id='{road}']//lane")
    return {int(lane.get("id")): lane.find("roadMark").get("type") for lane in lanes}


def test_road_marks():
    net = network_of(("four_way", 4, {"lanes": (2, 1, 1, 1)}))
    root = etree.fromstring(write_opendrive(net))
    wide = {2: "solid", 1: "broken", 0: "solid", -1: "broken", -2: "solid"}
    assert marks(root, net.arm_roads[0]).items() >= wide.items()
    assert marks(root, net.arm_roads[1]).items() >= {1: "solid", 0: "broken", -1: "solid"}.items()
    inside = next(road for road in net.roads if road.junction is not None)
    assert set(marks(root, inside.id).values()) == {"none"}


@pytest.mark.parametrize(
    ("control", "kind", "dynamic"),
    [
        (Control.STOP, "206", "no"),
        (Control.YIELD, "205", "no"),
        (Control.SIGNALS, "1000001", "yes"),
    ],
)
@pytest.mark.parametrize(("side", "lane"), [("right", -1), ("left", 1)])
def test_signs_face_entering_traffic(control, kind, dynamic, side, lane):
    net = network_of(("t", 3, {"driving_side": side}))
    root = etree.fromstring(write_opendrive(net, control=control, controlled_arms=[2]))
    (signal,) = root.iterfind(".//signal")
    assert signal.getparent().getparent().get("id") == str(net.arm_roads[2])
    assert (signal.get("type"), signal.get("dynamic")) == (kind, dynamic)
    assert signal.get("orientation") == "+"
    assert float(signal.get("t")) * lane == pytest.approx(4.0)
    assert signal.find("validity").get("fromLane") == str(lane)


def test_no_signs_without_control(network):
    assert "<signal " not in write_opendrive(network)
    assert "<signal " not in write_opendrive(network, control=Control.PRIORITY_TO_RIGHT)


@pytest.mark.asam
@pytest.mark.skipif(not SCHEMAS, reason="the ASAM checkers' environment is not installed")
@pytest.mark.parametrize("control", [Control.UNCONTROLLED, Control.STOP, Control.SIGNALS])
def test_valid_against_the_schema(network, control):
    schema = etree.XMLSchema(etree.parse(SCHEMAS[-1]))
    document = etree.fromstring(write_opendrive(network, control=control))
    assert schema.validate(document), schema.error_log


ESMINI = shutil.which("esmini")
SCENE = """<?xml version="1.0"?>
<OpenSCENARIO>
  <FileHeader revMajor="1" revMinor="0" date="2025-01-01T00:00:00" description="" author=""/>
  <ParameterDeclarations/><CatalogLocations/>
  <RoadNetwork><LogicFile filepath="road.xodr"/></RoadNetwork>
  <Entities><ScenarioObject name="car"><Vehicle name="car" vehicleCategory="car">
    <ParameterDeclarations/>
    <BoundingBox><Center x="1.4" y="0" z="0.7"/>
      <Dimensions width="2" length="4.8" height="1.5"/></BoundingBox>
    <Performance maxSpeed="60" maxAcceleration="5" maxDeceleration="9"/>
    <Axles><FrontAxle maxSteering="0.5" wheelDiameter="0.6" trackWidth="1.8" positionX="2.9"
      positionZ="0.3"/><RearAxle maxSteering="0" wheelDiameter="0.6" trackWidth="1.8"
      positionX="0" positionZ="0.3"/></Axles>
    <Properties/></Vehicle></ScenarioObject></Entities>
  <Storyboard><Init><Actions><Private entityRef="car">
    <PrivateAction><TeleportAction><Position>
      <LanePosition roadId="{road}" laneId="{lane}" s="1" offset="0"/>
    </Position></TeleportAction></PrivateAction>
    <PrivateAction><LongitudinalAction><SpeedAction>
      <SpeedActionDynamics dynamicsShape="step" value="0" dynamicsDimension="time"/>
      <SpeedActionTarget><AbsoluteTargetSpeed value="10"/></SpeedActionTarget>
    </SpeedAction></LongitudinalAction></PrivateAction>
  </Private></Actions></Init>
  <StopTrigger><ConditionGroup><Condition name="end" delay="0" conditionEdge="none">
    <ByValueCondition><SimulationTimeCondition value="{end}" rule="greaterThan"/>
    </ByValueCondition></Condition></ConditionGroup></StopTrigger></Storyboard>
</OpenSCENARIO>
"""


@pytest.mark.esmini
@pytest.mark.skipif(ESMINI is None, reason="esmini is not on PATH")
def test_player_drives_where_the_network_says(network, tmp_path):
    # The tightest way of all: a car put on its start must follow its centre line.
    way = max(
        (road for road in network.roads if road.junction is not None),
        key=lambda road: abs(road.line.segments[-1].curvature_1pm),
        default=network.arm_road(0),
    )
    lane = -1 if way.driving_side == "right" else 1
    end = 0.9 * (way.length_m - 1) / 10
    (tmp_path / "road.xodr").write_text(write_opendrive(network), encoding="utf-8")
    scene = SCENE.format(road=way.id, lane=lane, end=end)
    (tmp_path / "scene.xosc").write_text(scene, encoding="utf-8")
    options = "--headless --fixed_timestep 0.05 --csv_logger log.csv --logfile_path log.txt"
    subprocess.run(
        [ESMINI, "--osc", "scene.xosc", "--disable_stdout", *options.split()],
        cwd=tmp_path,
        check=True,
        timeout=60,
        capture_output=True,
    )
    assert "[error]" not in (tmp_path / "log.txt").read_text()
    lines = (tmp_path / "log.csv").read_text().splitlines()
    head = next(i for i, line in enumerate(lines) if line.startswith("Index"))
    names = [name.strip() for name in lines[head].split(",")]
    rows = [dict(zip(names, line.split(","), strict=False)) for line in lines[head + 1 :]]
    # A road that the player takes for one in the opposite direction would end at once.
    assert float(rows[-1]["#1 Current_Speed [m/s]"]) == 10
    assert float(rows[-1]["#1 Distance_Travelled_Along_Road_Segment [m]"]) > way.length_m / 2
    for row in rows:
        s = float(row["#1 Distance_Travelled_Along_Road_Segment [m]"])
        pose = way.line.pose(s, way.lane_centre_t_m(lane))
        assert float(row["#1 World_Position_X [m]"]) == pytest.approx(pose.x_m, abs=0.01)
        assert float(row["#1 World_Position_Y [m]"]) == pytest.approx(pose.y_m, abs=0.01)
