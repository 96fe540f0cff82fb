"""Files from elsewhere get a verdict on what they break; conventions of ours are remarks."""

from __future__ import annotations

from cmath import exp

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.checking import CheckStatus, Severity, check_files
from scegen.checking.opendrive import check_opendrive
from scegen.checking.opendrive.curves import Arc, Cubic, Poly3, Spiral
from scegen.checking.opendrive.lanes import reference
from scegen.checking.opendrive.locate import lanes_at
from scegen.checking.openscenario import CHECKER, check_openscenario

bends = st.floats(-0.02, 0.02, allow_subnormal=False)
lengths = st.floats(5.0, 200.0)

LANES = """<lanes><laneSection s="0">
  <left><lane id="1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></left>
  <center><lane id="0" type="driving"/></center>
  <right><lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right>
</laneSection></lanes>"""
LENGTH, LAST = 60.0, 0.02
CLOTHOID = Spiral(0.0, LAST / LENGTH)


def road(*geometries, version="4"):
    """A road of geometries: each what stands in one, and its length; joined as the curves say."""
    s, at, heading, written = 0.0, 0j, 0.0, ""
    for inner, curve, length in geometries:
        written += (
            f'<geometry s="{s!r}" x="{at.real!r}" y="{at.imag!r}" hdg="{heading!r}" '
            f'length="{length!r}">{inner}</geometry>'
        )
        at += exp(1j * heading) * curve.point(length)
        heading += curve.heading(length)
        s += length
    return (
        f'<OpenDRIVE><header revMajor="1" revMinor="{version}"/>'
        f'<road id="1" junction="-1" length="{s!r}"><planView>{written}</planView>{LANES}</road>'
        "</OpenDRIVE>"
    ).encode()


LINE = ("<line/>", Arc(), 40.0)
BENDS_IN = (f'<spiral curvStart="0" curvEnd="{LAST}"/>', CLOTHOID, LENGTH)
ALONG = Poly3(0.0, 0.0, 1.0, 0.0, 0.0)
V = (0.0, 0.0, 4e-3, -3e-5)
POLYNOMIAL = (
    '<paramPoly3 pRange="arcLength" aU="0" bU="1" cU="0" dU="0" '
    f'aV="{V[0]}" bV="{V[1]}" cV="{V[2]}" dV="{V[3]}"/>',
    Cubic(ALONG, Poly3(0.0, *V), 1.0),
    30.0,
)


@given(bends, bends, lengths)
def test_curves_run_where_they_head(first, last, length):
    """The derivative of the point is the heading, that of the heading the curvature."""
    cubic = Cubic(ALONG, Poly3(0.0, 0.0, 0.0, first / 2, last / 300), 1.0)
    for curve in (Arc(first), Spiral(first, (last - first) / length)):
        for ds in (0.0, 0.3 * length, length):
            step = (curve.point(ds + 1e-4) - curve.point(ds - 1e-4)) / 2e-4
            assert abs(step - exp(1j * curve.heading(ds))) < 1e-6
            turn = (curve.heading(ds + 1e-4) - curve.heading(ds - 1e-4)) / 2e-4
            assert turn == pytest.approx(curve.curvature(ds), abs=1e-6)
    step = cubic.point(3.0 + 1e-4) - cubic.point(3.0 - 1e-4)
    assert step / abs(step) == pytest.approx(exp(1j * cubic.heading(3.0)), abs=1e-6)


@given(bends, lengths)
def test_a_clothoid_that_does_not_change_is_an_arc(bend, length):
    assert Spiral(bend, 0.0).point(length) == pytest.approx(Arc(bend).point(length), abs=1e-9)


def test_spirals_and_polynomials_are_measured():
    content = road(LINE, BENDS_IN, (f'<arc curvature="{LAST}"/>', Arc(LAST), 20.0))
    result = check_opendrive("road.xodr", content).result
    assert result.status is CheckStatus.PASSED, result.findings
    assert {f.severity for f in result.findings} == {Severity.WARNING}
    remarks = {f.rule for f in result.findings}
    assert remarks == {"xodr.version", "xodr.elevation", "xodr.geometry_kind"}
    assert check_opendrive("road.xodr", road(LINE, POLYNOMIAL)).result.errors == ()


def test_a_step_after_a_spiral_is_an_error():
    whole = road(LINE, BENDS_IN, LINE)
    shorter = whole.replace(b'curvEnd="0.02"', b'curvEnd="0.015"')
    result = check_opendrive("road.xodr", shorter).result
    assert {f.rule for f in result.errors} == {"xodr.road_gap", "xodr.road_kink"}


def test_what_is_not_read_is_not_passed():
    content = road(LINE, ('<poly3 a="0" b="0" c="0.001" d="0"/>', Arc(), 30.0))
    result = check_opendrive("road.xodr", content).result
    assert result.status is CheckStatus.NOT_RUN
    (found,) = (f for f in result.findings if f.severity is Severity.UNCHECKED)
    assert "poly3" in found.message
    assert found.place == "road 1"


@given(st.floats(1.0, 59.0), st.floats(-3.0, 3.0))
def test_points_on_a_spiral_are_found(along, aside):
    network = check_opendrive("road.xodr", road(LINE, BENDS_IN)).network
    at, heading, _ = reference(network.roads["1"], 40.0 + along)
    found = lanes_at(network, np.array([at + 1j * aside * exp(1j * heading)]))[0]
    lane = next(x for x in found if x.lane == (1 if aside > 0 else -1))
    assert lane.s_m == pytest.approx(40.0 + along, abs=0.02)
    assert lane.t_m == pytest.approx(aside - (1.75 if aside > 0 else -1.75), abs=0.01)


def joined(number, x, link):
    """A straight road of 50 m from x on, linked to junction 9."""
    return (
        f'<road id="{number}" junction="-1" length="50"><link><{link} elementType="junction" '
        f'elementId="9"/></link><planView><geometry s="0" x="{x}" y="0" hdg="0" length="50">'
        f"<line/></geometry></planView>{LANES}</road>"
    )


DIRECT = """<junction id="9" type="direct">
<connection id="0" incomingRoad="1" linkedRoad="2" contactPoint="start">
<laneLink from="-1" to="-1"/></connection>
<connection id="1" incomingRoad="2" linkedRoad="1" contactPoint="end">
<laneLink from="1" to="1"/></connection></junction>"""


@pytest.mark.parametrize(("x", "rules"), [(50.0, set()), (50.2, {"xodr.lane_gap"})])
def test_a_direct_junction_joins_roads_themselves(x, rules):
    roads = joined(1, 0.0, "successor") + joined(2, x, "predecessor")
    content = f'<OpenDRIVE><header revMajor="1" revMinor="7"/>{roads}{DIRECT}</OpenDRIVE>'
    assert {f.rule for f in check_opendrive("road.xodr", content.encode()).result.errors} == rules


SCENARIO = """<OpenSCENARIO><FileHeader revMajor="1" revMinor="2"/>
<ParameterDeclarations><ParameterDeclaration name="far" parameterType="double" value="20"/>
</ParameterDeclarations><RoadNetwork><LogicFile filepath="road.xodr"/></RoadNetwork>
<Entities><ScenarioObject name="Ego"><Vehicle vehicleCategory="car"/></ScenarioObject></Entities>
<Storyboard><Init><Actions><Private entityRef="Ego"><PrivateAction><TeleportAction><Position>
{position}</Position></TeleportAction></PrivateAction></Private></Actions></Init></Storyboard>
</OpenSCENARIO>"""
ON_ROAD = '<LanePosition roadId="1" laneId="{lane}" s="{s}" offset="0"/>'


@pytest.mark.parametrize(
    ("position", "status"),
    [
        (ON_ROAD.format(lane="-1", s="$far"), CheckStatus.PASSED),
        (ON_ROAD.format(lane="-1", s="${$far + 1}"), CheckStatus.NOT_RUN),
        ('<RelativeLanePosition entityRef="Ego" ds="5" dLane="0"/>', CheckStatus.NOT_RUN),
        (ON_ROAD.format(lane="-4", s="$far"), CheckStatus.FAILED),
    ],
)
def test_a_scenario_from_elsewhere(position, status):
    network = check_opendrive("road.xodr", road(LINE)).network
    result = check_openscenario(
        "their.xosc",
        SCENARIO.format(position=position).encode(),
        road_file="road.xodr",
        network=network,
    )
    assert result.status is status, result.findings
    assert "xosc.ego" in {f.rule for f in result.findings if f.severity is Severity.WARNING}


def test_a_road_may_be_named_by_a_parameter(tmp_path):
    (tmp_path / "maps").mkdir()
    (tmp_path / "maps" / "road.xodr").write_bytes(road(LINE))
    text = SCENARIO.format(position=ON_ROAD.format(lane="-1", s="$far"))
    text = text.replace('filepath="road.xodr"', 'filepath="$map"').replace(
        "<ParameterDeclarations>",
        '<ParameterDeclarations><ParameterDeclaration name="map" parameterType="string" '
        'value="./maps/road.xodr"/>',
    )
    scenario = tmp_path / "their.xosc"
    scenario.write_text(text)
    (report,) = check_files([scenario], (CHECKER,))
    assert not [f for r in report.results for f in r.findings if f.rule == "xosc.road_file"]
    assert {r.checker: r.status for r in report.results}[CHECKER] is CheckStatus.PASSED


def test_our_own_conventions_bind_our_own(folder):
    """The same road is a remark by itself and an error where it is to serve a scenario of ours."""
    path = folder / "road.xodr"
    path.write_bytes(
        path.read_bytes()
        .replace(b"<elevationProfile>", b"<x>")
        .replace(b"</elevationProfile>", b"</x>")
    )
    alone, served = (check_files([p], ["opendrive"])[0].result("opendrive") for p in (path, folder))
    assert alone.status is CheckStatus.PASSED
    assert served.status is CheckStatus.FAILED
