"""Sizes that are said are those of the files, of the road, and of everything that is measured."""

import pytest
from lxml import etree
from mutating import changed, on_road
from pydantic import ValidationError
from saying import missed
from told import act, apart, first, raised, told, who

from scegen.checking import check_folder
from scegen.errors import MotionInfeasibleError
from scegen.export.opendrive import write_opendrive
from scegen.export.openscenario import write_openscenario
from scegen.motion import build_paths
from scegen.road import build_network
from scegen.scenario.bodies import BODIES
from scegen.scenario.files import to_yaml
from scegen.scenario.vocabulary import ParticipantKind

EGO = who("ego", maneuvers=["straight"], speed=15.0)
TRUCK = who("truck", "truck", ["ahead"], ["straight"], speed=15.0)
LONG, WIDE = {"length_m": 16.5}, {"width_m": 2.3}
BRAKES = act("brakes", "truck", "brake", rate_mps2=4.0)


def following(truck, **road):
    return told(
        "straight", [EGO, truck], acts=[BRAKES], spacings=[apart("ego", "truck", "gap_m", 30.0)],
        **road,
    )  # fmt: skip


def test_a_long_truck_is_long_in_the_file_and_in_every_gap(tmp_path):
    raised_ = raised(following(TRUCK | LONG | WIDE))
    concrete, claims = raised_.concrete, {c.id: c for c in raised_.proof.claims}
    assert all(claim.holds for claim in claims.values())
    assert claims["size.truck.length_m"].measured == pytest.approx(16.5)
    assert claims["size.truck.width_m"].measured == pytest.approx(2.3)
    usual, body = BODIES[ParticipantKind.TRUCK], concrete.participant("truck").body
    assert body.mass_kg / usual.mass_kg == pytest.approx(16.5 / 7.9 * 2.3 / 2.5, rel=1e-3)
    starts = [concrete.participant(name).motion.start_m for name in ("truck", "ego")]
    bumpers = body.rear_m + concrete.ego.body.front_m
    assert starts[0] - starts[1] - bumpers == pytest.approx(30.0, abs=0.5)
    network = build_network(concrete.road, concrete.name)
    (tmp_path / "road.xodr").write_text(write_opendrive(network))
    text = write_openscenario(concrete, build_paths(concrete, network))
    (tmp_path / "concrete.yaml").write_text(to_yaml(concrete))
    root = etree.fromstring(text)
    box = root.find(".//ScenarioObject[@name='truck']//Dimensions")
    assert (box.get("length"), box.get("width")) == ("16.5", "2.3")
    for length, rules in (("16.5", set()), ("7.9", {("xosc.size", "truck")})):
        box.set("length", length)
        (tmp_path / "scenario.xosc").write_bytes(etree.tostring(root))
        found = check_folder(tmp_path, ["openscenario"]).result("openscenario").errors
        assert {(error.rule, error.place) for error in found} == rules


def test_a_truck_that_is_shorter_than_is_said_is_noticed():
    functional = following(TRUCK | LONG)
    concrete = first(functional)
    shorter = changed(concrete, "truck", length_m=12.0)
    assert "size.truck.length_m" not in missed(functional, concrete)
    assert "size.truck.length_m" in missed(functional, shorter)


def test_a_thing_is_as_large_as_is_said():
    for sizes, box in (
        ({"kind": "box", "length_m": 1.4}, (1.4, 1.4)),
        ({"kind": "box", "width_m": 2.0, "length_m": 1.0}, (1.0, 2.0)),
        ({"kind": "plank", "length_m": 3.0}, (1.0, 3.0)),
        ({"kind": "container", "width_m": 2.2}, (4.0, 2.2)),
    ):
        thing = {"id": "thing", "in_way_of": "ego", **sizes}
        functional = told("straight", [EGO], objects=[thing])
        concrete = first(functional)
        (made,) = concrete.objects
        assert (made.length_m, made.width_m) == box
        assert not {claim for claim in missed(functional, concrete) if claim.startswith("size")}


@pytest.mark.parametrize("width_m", [2.75, 4.0])
def test_lanes_are_as_wide_as_is_said(width_m):
    van = who("van", "van", ["adjacent", "left"], ["straight"], speed=15.0)
    functional = told("straight", [EGO, van], lanes=2, lane_width_m=width_m)
    concrete = first(functional)
    assert {arm.lane_width_m for arm in concrete.road.arms} == {width_m}
    paths = build_paths(concrete, build_network(concrete.road))
    assert abs(paths["van"].start.y_m - paths["ego"].start.y_m) == pytest.approx(width_m)
    assert not missed(functional, concrete)
    arms = tuple(arm.model_copy(update={"lane_width_m": 3.5}) for arm in concrete.road.arms)
    usual = concrete.road.model_copy(update={"arms": arms})
    assert "road.lane_width_m" in missed(functional, concrete.model_copy(update={"road": usual}))


def with_a_ramp(kind, length_m):
    leaves = kind == "off_ramp"
    place, does = (["ahead"], "exit") if leaves else (["adjacent", "right"], "merge")
    van = who("van", "van", place, [does], speed=25.0)
    return told(
        "straight", [EGO | {"speed_mps": 25.0}, van], lanes=2, carriageway="divided",
        auxiliary=kind, auxiliary_length_m=length_m,
    )  # fmt: skip


@pytest.mark.parametrize("length_m", [110.0, 400.0])
@pytest.mark.parametrize("kind", ["on_ramp", "off_ramp", "lane_drop"])
def test_a_lane_for_a_part_of_the_road_is_as_long_as_is_said(kind, length_m):
    functional = with_a_ramp(kind, length_m)
    concrete = first(functional)
    assert concrete.road.auxiliary.length_m == length_m
    assert not missed(functional, concrete)
    other = concrete.road.auxiliary.model_copy(update={"length_m": length_m + 20})
    assert "road.auxiliary_length_m" in missed(functional, on_road(concrete, auxiliary=other))


def test_a_lane_that_is_too_short_for_those_who_use_it_is_told():
    with pytest.raises(MotionInfeasibleError, match="would need"):
        first(with_a_ramp("on_ramp", 40.0))


def test_nobody_is_longer_than_what_may_be_on_the_road():
    with pytest.raises(ValidationError, match=r"between 0.1 and 25.25"):
        following(TRUCK | {"length_m": 60.0})
