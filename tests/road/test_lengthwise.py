"""Roads along their length: medians, one direction only, hard shoulders, bends."""

from math import degrees, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.errors import RoadInfeasibleError
from scegen.road import build_network, plan_road
from scegen.road.fillet import wrapped
from scegen.road.model import LaneType
from scegen.road.straight import curve_of
from scegen.scenario.bends import usual_radius_m
from scegen.scenario.junction import Junction


def planned(**junction):
    return plan_road(Junction(kind="straight", arms=2, **junction))


def strips(road, sign):
    lanes = sorted((x for x in road.lanes if x.id * sign > 0), key=lambda x: abs(x.id))
    return [lane.type.value for lane in lanes]


def test_a_motorway_has_a_median_and_shoulders():
    network = build_network(planned(lanes=(3, 3), carriageway="divided", strips=["hard_shoulder"]))
    for arm in (0, 1):
        road = network.arm_road(arm)
        wanted = ["median", "driving", "driving", "driving", "shoulder", "border"]
        assert strips(road, 1) == strips(road, -1) == wanted
    road = network.arm_road(0)
    first, third = (
        road.lane_centre_t_m(lane) for lane in (road.driving(-1)[0], road.driving(-1)[2])
    )
    assert (first, third) == pytest.approx((-2.5 - 1.75, -2.5 - 8.75))
    assert [r.entry_lane for r in network.routes[0, 1]] == [1, 2, 3]


@pytest.mark.parametrize(("side", "sign"), [("right", -1), ("left", 1)])
def test_a_one_way_road_leads_from_arm_0_to_arm_1(side, sign):
    network = build_network(planned(lanes=(2, 2), carriageway="one_way", driving_side=side))
    assert set(network.routes) == {(0, 1)}
    road = network.arm_road(0)
    assert (len(road.driving(sign)), road.driving(-sign)) == (2, [])
    assert road.edge_t_m(-sign) == 0.0
    assert LaneType.SIDEWALK in {lane.type for lane in road.lanes if lane.id * sign < 0}


def test_what_cannot_be_built_is_refused():
    one_way = planned(carriageway="one_way")
    both = one_way.model_copy(update={"arms": planned().arms})
    with pytest.raises(RoadInfeasibleError, match="one-way road leads in at arm 0"):
        build_network(both)
    with pytest.raises(RoadInfeasibleError, match="no lanes one way"):
        build_network(one_way.model_copy(update={"carriageway": planned().carriageway}))
    back = planned(carriageway="divided").model_copy(update={"u_turns": frozenset({0})})
    with pytest.raises(RoadInfeasibleError, match="nobody turns back"):
        build_network(back)


@pytest.mark.parametrize("kind", ["four_way", "roundabout"])
@pytest.mark.parametrize(
    "more", [{"carriageway": "divided"}, {"strips": ["hard_shoulder"]}, {"bend": {"side": "left"}}]
)
def test_only_roads_without_a_junction_have_them(kind, more):
    with pytest.raises(ValueError, match="only for a road without a junction"):
        Junction(kind=kind, arms=4, **more)


@given(
    st.sampled_from([None, "left", "right"]),
    st.one_of(st.none(), st.floats(25, 2000)),
    st.floats(8, 40),
    st.sampled_from(["undivided", "divided"]),
)
def test_a_bend_turns_to_its_side_with_its_radius(side, radius, limit, carriageway):
    bend = {"side": side, "radius_m": radius}
    parameters = planned(bend=bend, speed_limit_mps=limit, carriageway=carriageway)
    curve = curve_of(parameters)
    assert curve is not None
    wanted = radius or usual_radius_m(limit)
    assert abs(1 / curve.curvature_1pm) == pytest.approx(wanted)
    assert (curve.curvature_1pm < 0) == (side == "right")
    network = build_network(parameters)
    into, out = network.arm_road(0).line, network.arm_road(1).line.reversed()
    turned = wrapped(out.end.heading_rad - into.start.heading_rad)
    assert turned == pytest.approx(2 * curve.half_arc_m * curve.curvature_1pm, abs=1e-6)
    assert abs(degrees(turned)) <= 90.05
    joint, begin = into.end, out.start
    assert (joint.x_m, joint.y_m) == pytest.approx((begin.x_m, begin.y_m), abs=1e-6)
    assert abs(wrapped(joint.heading_rad - begin.heading_rad)) < 1e-6 < pi


def test_wider_bends_for_faster_roads():
    radii = [usual_radius_m(kph / 3.6) for kph in (30, 50, 80, 100, 130)]
    assert radii == sorted(radii)
    # AASHTO, table 3-7: 79, 252 and 437 m for 50, 80 and 100 km/h at 6 %.
    assert radii[1:4] == [80, 260, 440]
