"""What single networks look like."""

from math import hypot

import pytest

from scegen.road import build_network, plan_road
from scegen.road.model import LaneType
from scegen.scenario.junction import Junction


def network(kind, arms, *, plan=None, **junction):
    return build_network(plan_road(Junction(kind=kind, arms=arms, **junction), **(plan or {})))


def road_names(net, route):
    return [net.road(step.road).name for step in route.steps]


def test_defaults():
    town = plan_road(Junction(kind="t", arms=3))
    ring = plan_road(Junction(kind="roundabout", arms=4))
    assert [arm.angle_deg for arm in town.arms] == [0, 180, 270]
    assert [arm.angle_to_previous_deg for arm in town.arms] == [90, 180, 90]
    assert {(a.lanes_in, a.lanes_out, a.lane_width_m, a.length_m) for a in town.arms} == {
        (1, 1, 3.5, 120)
    }
    assert town.arms[0].speed_limit_mps == 13.889
    assert (ring.arms[0].speed_limit_mps, ring.ring_lanes) == (8.333, 1)


def test_what_is_said_overrides_the_defaults():
    said = Junction(kind="t", arms=3, lanes=(1, 3, 2), speed_limit_mps=20, driving_side="left")
    planned = plan_road(said, min_lanes=2, arm_length_m=200, parking_lanes={1}, u_turns={0})
    assert [arm.lanes_in for arm in planned.arms] == [2, 3, 2]
    assert {arm.speed_limit_mps for arm in planned.arms} == {20}
    assert (planned.driving_side, planned.arms[0].length_m) == ("left", 200)
    assert (planned.parking_lanes, planned.u_turns) == ({1}, {0})


def test_lanes_of_an_arm_from_the_centre_outwards():
    net = network("four_way", 4, lanes=(2, 1, 1, 1), plan={"parking_lanes": {0}})
    road = net.arm_road(0)
    for sign in (1, -1):
        side = sorted((lane for lane in road.lanes if lane.id * sign > 0), key=lambda x: abs(x.id))
        assert [lane.type for lane in side] == [
            LaneType.DRIVING,
            LaneType.DRIVING,
            LaneType.PARKING,
            LaneType.SIDEWALK,
        ]
    assert road.lane_centre_t_m(-2) == pytest.approx(-5.25)
    assert [lane.type for lane in net.arm_road(1).lanes].count(LaneType.PARKING) == 0


@pytest.mark.parametrize(("side", "inward"), [("right", -1), ("left", 1)])
def test_incoming_lanes_lie_on_the_side_of_traffic(side, inward):
    net = network("four_way", 4, driving_side=side)
    route = net.routes[0, 2][0]
    assert (route.steps[0].lane, route.steps[0].forward) == (inward, True)
    assert (route.steps[2].lane, route.steps[2].forward) == (-inward, False)
    connecting = net.road(route.steps[1].road)
    assert [lane.id for lane in connecting.lanes] == [inward]
    # Straight on keeps 1.75 m to the driver's own side of the axis y = 0.
    assert net.pose_at(route.steps[1], 5.0).y_m == pytest.approx(-inward * 1.75)


def test_crosswalk_spans_the_carriageway_a_metre_before_the_junction():
    net = network("t", 3, crosswalks={2}, plan={"parking_lanes": {2}})
    (crosswalk,) = net.arm_road(2).crosswalks
    inner_edge = crosswalk.s_m + crosswalk.width_m / 2
    assert net.arm_road(2).length_m - inner_edge == pytest.approx(1.0)
    assert (crosswalk.t_min_m, crosswalk.t_max_m) == pytest.approx((-6.0, 6.0))
    assert net.arm_road(0).crosswalks == ()


def test_right_turn_follows_the_kerb():
    net = network("four_way", 4)
    turn = net.road(net.routes[0, 1][0].steps[1].road)
    (arc,) = turn.line.segments
    # Kerb radius 8 m and half a lane.
    assert arc.curvature_1pm == pytest.approx(-1 / 9.75)


@pytest.mark.parametrize("side", ["right", "left"])
def test_u_turn_comes_back_into_the_own_arm(side):
    net = network("four_way", 4, driving_side=side, plan={"u_turns": {2}})
    (route,) = net.routes[2, 2]
    steps = route.steps
    assert (steps[0].road, steps[0].lane) == (steps[2].road, -steps[2].lane)
    assert (0, 0) not in net.routes


def test_straight_lanes_continue_in_the_other_arm():
    net = network("straight", 2, lanes=(2, 2), plan={"parking_lanes": {0}})
    assert net.junctions == ()
    first, second = net.arm_road(0), net.arm_road(1)
    assert (first.successor.id, second.successor.id) == (second.id, first.id)
    for lane in first.lanes:
        opposite = second.lane(lane.successor)
        assert opposite.successor == lane.id
        assert opposite.width_m == lane.width_m
        assert first.lane_centre_t_m(lane.id) == -second.lane_centre_t_m(opposite.id)
    assert {lane.type for lane in second.lanes} == {
        LaneType.DRIVING,
        LaneType.SHOULDER,
        LaneType.SIDEWALK,
    }
    assert [route.exit_lane for route in net.routes[0, 1]] == [1, 2]


def test_a_bend_is_an_arc_shared_by_both_arms():
    net = network("straight", 2, arm_angles_deg=(0, 130))
    for arm in (0, 1):
        line, arc = net.arm_road(arm).line.segments
        assert line.curvature_1pm == 0
        assert abs(arc.curvature_1pm) == pytest.approx(1 / 50)
        assert net.arm_road(arm).length_m == pytest.approx(120)


def test_route_through_a_ring_lists_every_road():
    net = network("roundabout", 4)
    (route,) = net.routes[0, 3]
    assert road_names(net, route) == [
        "arm_0",
        "arm_0_1_to_ring_0_1",
        "ring_0",
        "ring_0_1_to_ring_1_1",
        "ring_1",
        "ring_1_1_to_ring_2_1",
        "ring_2",
        "ring_2_1_to_arm_3_1",
        "arm_3",
    ]
    assert (0, 0) not in net.routes


def test_left_hand_rings_run_clockwise():
    net = network("roundabout", 4, driving_side="left")
    (route,) = net.routes[0, 3]
    assert road_names(net, route)[2] == "ring_0"
    assert len(route.steps) == 5


def test_full_circle_passes_every_other_arm():
    net = network("roundabout", 5, plan={"u_turns": {1}})
    (route,) = net.routes[1, 1]
    rings = [name for name in road_names(net, route) if name.count("ring") == 1 and name[0] == "r"]
    assert [name for name in rings if "arm" not in name] == [f"ring_{k}" for k in (1, 2, 3, 4, 0)]


@pytest.mark.parametrize("side", ["right", "left"])
@pytest.mark.parametrize("lanes", [1, 2, 3])
def test_both_ring_lanes_lead_from_everywhere_to_everywhere(side, lanes):
    net = network("roundabout", 4, lanes=(lanes,) * 4, ring_lanes=2, driving_side=side)
    for routes in net.routes.values():
        assert {route.ring_lane for route in routes} == {1, 2}
        assert {route.entry_lane for route in routes} == set(range(1, lanes + 1))
        assert {route.exit_lane for route in routes} == set(range(1, lanes + 1))
    radii = {}
    for route in net.routes[0, 2]:
        ring = next(step for step in route.steps if net.road(step.road).name == "ring_0")
        pose = net.pose_at(ring, 1.0)
        radii.setdefault(route.ring_lane, set()).add(round(hypot(pose.x_m, pose.y_m), 6))
        assert abs(ring.lane) == route.ring_lane
    ((inner,), (outer,)) = (radii[1], radii[2])
    assert outer - inner == pytest.approx(3.5)


def test_ring_radius_is_kept():
    wanted = plan_road(Junction(kind="roundabout", arms=4)).model_copy(
        update={"ring_radius_m": 26.0}
    )
    ring = next(road for road in build_network(wanted).roads if road.name == "ring_0")
    assert abs(ring.line.segments[0].curvature_1pm) == pytest.approx(1 / 26)


def test_speed_limits_are_those_of_the_slower_arm():
    wanted = plan_road(Junction(kind="four_way", arms=4))
    slow = wanted.arms[1].model_copy(update={"speed_limit_mps": 5.0})
    wanted = wanted.model_copy(update={"arms": (wanted.arms[0], slow, *wanted.arms[2:])})
    net = build_network(wanted)
    limits = {
        pair: net.road(routes[0].steps[1].road).speed_limit_mps
        for pair, routes in net.routes.items()
    }
    assert limits[0, 1] == limits[1, 3] == 5.0
    assert limits[0, 2] == 13.889


def test_parking_strips_and_sidewalks_of_neighbours_stay_apart():
    wanted = plan_road(Junction(kind="four_way", arms=4), parking_lanes={0, 1, 2, 3})
    net = build_network(wanted.model_copy(update={"corner_radius_m": 2.0}))
    end = net.arm_road(0).line.end
    # Lane, parking strip, sidewalk, and half a metre between the corners.
    assert end.x_m == pytest.approx(3.5 + 2.5 + 2.0 + 0.5)
