"""Lanes for a part of the road: on-ramps, exits and lanes that end, as geometry."""

from itertools import product
from math import hypot

import pytest

from scegen.checking.opendrive import check_opendrive
from scegen.errors import RoadInfeasibleError
from scegen.export.opendrive import write_opendrive
from scegen.road import build_network, plan_road
from scegen.road.sections import sections
from scegen.scenario.junction import Junction

KINDS = ("on_ramp", "off_ramp", "lane_drop")
CASES = list(product(KINDS, ("right", "left"), ("divided", "undivided", "one_way"), (1, 3)))


def network(kind, side="right", carriageway="divided", lanes=2, length_m=500.0):
    strips = ["hard_shoulder"] if carriageway == "divided" else []
    junction = Junction(
        kind="straight", arms=2, lanes=(lanes, lanes), carriageway=carriageway, strips=strips,
        auxiliary=kind, driving_side=side,
    )  # fmt: skip
    return build_network(plan_road(junction, arm_length_m=length_m))


@pytest.mark.parametrize(("kind", "side", "carriageway", "lanes"), CASES)
def test_the_written_road_has_no_fault(kind, side, carriageway, lanes):
    text = write_opendrive(network(kind, side, carriageway, lanes))
    checked = check_opendrive("road.xodr", text.encode()).result
    assert [f"{f.rule} {f.place} {f.message}" for f in checked.errors] == []


@pytest.mark.parametrize(("kind", "side", "carriageway", "lanes"), CASES)
def test_every_route_runs_on_without_a_step(kind, side, carriageway, lanes):
    made = network(kind, side, carriageway, lanes)
    assert made.plain
    for routes in made.routes.values():
        for route in routes:
            for step, following in zip(route.steps, route.steps[1:], strict=False):
                end = made.pose_at(step, made.road(step.road).length_m)
                begin = made.pose_at(following, 0.0)
                assert hypot(end.x_m - begin.x_m, end.y_m - begin.y_m) < 1e-6
                assert abs((end.heading_rad - begin.heading_rad + 3.14) % 6.283185307 - 3.14) < 1e-6


@pytest.mark.parametrize("kind", KINDS[:2])
def test_the_ramp_is_as_long_as_the_road_beside_it(kind):
    made = network(kind)
    lengths = {
        route.entry_lane: sum(made.road(step.road).length_m for step in route.steps)
        for route in made.routes[0, 1]
    }
    assert lengths[3] == pytest.approx(lengths[1], abs=1e-6)


@pytest.mark.parametrize("kind", KINDS[:2])
def test_the_ramp_is_clear_of_the_road_beside_it_where_it_is_a_road_of_its_own(kind):
    made = network(kind)
    ramp = next(road for road in made.roads if road.name == "ramp")
    main = made.arm_road(0 if kind == "on_ramp" else 1)
    outermost = max(abs(lane.id) for lane in main.lanes)
    sign = 1 if kind == "off_ramp" else -1
    edge = (
        abs(main.lane_centre_t_m(sign * outermost, 0.0)) + main.lane(sign * outermost).width_m / 2
    )
    inner_t = ramp.lane_centre_t_m(1) + ramp.lane(1).width_m / 2
    at = ramp.length_m if kind == "on_ramp" else 0.0
    corner = ramp.line.pose(at, inner_t)
    assert abs(corner.y_m) > edge


@pytest.mark.parametrize("kind", KINDS)
def test_a_lane_widens_or_narrows_without_a_kink_and_is_gone_beyond(kind):
    made = network(kind)
    road = made.arm_road(0 if kind == "off_ramp" else 1)
    lane = next(x for x in road.lanes if x.extent is not None)
    assert road.length_m - lane.extent.from_m == pytest.approx(310.0)
    assert lane.width_at_m(lane.extent.from_m) == pytest.approx(0.0, abs=1e-9)
    assert lane.width_at_m(lane.extent.from_m + 30.0) == pytest.approx(lane.width_m / 2)
    assert lane.width_at_m(lane.extent.from_m + 60.0) == pytest.approx(lane.width_m)
    assert lane.width_at_m(lane.extent.from_m - 1.0) == 0.0
    first, second = sections(road)
    assert len(second.lanes) == len(first.lanes) + 1


def test_who_stands_on_the_shoulder_stands_farther_out_beside_the_lane():
    road = network("on_ramp").arm_road(1)
    shoulder = max(lane.id for lane in road.lanes if lane.type == "shoulder")
    beside, before = (road.lane_centre_t_m(shoulder, s) for s in (road.length_m - 10.0, 10.0))
    assert beside - before == pytest.approx(3.5)


def test_an_arm_too_short_for_its_lane_is_refused():
    with pytest.raises(RoadInfeasibleError, match=r"needs 315 m of arm 1"):
        network("on_ramp", length_m=200.0)


def test_a_bend_and_an_auxiliary_lane_are_not_built_together():
    with pytest.raises(ValueError, match="a bend or an auxiliary lane"):
        Junction(kind="straight", arms=2, bend={}, auxiliary="on_ramp")
