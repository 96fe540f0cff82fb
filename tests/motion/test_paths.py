from __future__ import annotations

from math import pi

import numpy as np
import pytest

from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import is_ring, ring_lane_number
from scegen.motion.model import Path
from scegen.motion.paths import END_MARGIN_M, build_path, lay_drive
from scegen.road import build_network, plan_road
from scegen.road.model import RoadNetwork, Route
from scegen.scenario.concrete import CrossingMotion, DriveMotion, LaneChange, StandingMotion
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import DrivingSide, JunctionKind, ParticipantKind, Side

CAR = ParticipantKind.CAR
ARM_M = 80.0


def network(kind="four_way", arms=4, lanes=1, side="right", ring_radius=None, **junction):
    place = Junction(kind=kind, arms=arms, driving_side=side, **junction)
    parameters = plan_road(place, arm_length_m=ARM_M, min_lanes=lanes)
    if ring_radius is not None:
        parameters = parameters.model_copy(update={"ring_radius_m": ring_radius})
    return build_network(parameters)


def motion(route: Route, start_m: float = 10.0, **more) -> DriveMotion:
    numbers = {
        "entry": route.entry,
        "entry_lane": route.entry_lane,
        "exit": route.exit,
        "exit_lane": route.exit_lane,
        "ring_lane": route.ring_lane,
        "start_m": start_m,
        "turning_starts_m": 0,
        "turning_ends_m": 0,
    }
    return DriveMotion(**(numbers | more))


def routes(net: RoadNetwork) -> list[Route]:
    return [route for found in net.routes.values() for route in found]


def wrapped(angle):
    return (angle + pi) % (2 * pi) - pi


def assert_smooth(path: Path, sharpest_radius_m: float = 4.0) -> None:
    steps = np.diff(path.s_m)
    chords = np.hypot(np.diff(path.x_m), np.diff(path.y_m))
    assert path.s_m[0] == 0.0
    assert (steps > 0).all()
    np.testing.assert_allclose(steps, chords, atol=1e-9)
    assert steps.max() <= 4.0 + 1e-6
    turns = np.diff(path.heading_rad)
    assert np.abs(turns).max() <= 0.25 / sharpest_radius_m + 1e-6, "a kink in the heading"
    middle = (path.heading_rad[1:] + path.heading_rad[:-1]) / 2
    chord = np.arctan2(np.diff(path.y_m), np.diff(path.x_m))
    assert np.abs(wrapped(chord - middle)).max() < 0.01, "the heading is not that of the way"
    curved = np.abs(turns) > 1e-3
    assert steps[curved].max(initial=0.0) <= 0.3


NETWORKS = [
    ("straight", 2, 1, "right"),
    ("straight", 2, 2, "left"),
    ("t", 3, 2, "right"),
    ("y", 3, 1, "left"),
    ("four_way", 4, 3, "right"),
    ("skewed", 4, 1, "right"),
    ("multi_way", 5, 1, "right"),
    ("roundabout", 4, 2, "right"),
    ("roundabout", 3, 1, "left"),
]


@pytest.mark.parametrize("shape", NETWORKS, ids=str)
def test_every_route_is_smooth_and_joins_its_arms(shape):
    kind, arms, lanes, side = shape
    net = network(kind, arms, lanes, side)
    for route in routes(net):
        laid = lay_drive(net, motion(route), "car")
        path = laid.path
        assert_smooth(path)
        entry, leaving = net.arm_road(route.entry), net.arm_road(route.exit)
        first, last = route.steps[0], route.steps[-1]
        start = entry.line.pose(10.0, entry.lane_centre_t_m(first.lane))
        end = leaving.line.pose(END_MARGIN_M, leaving.lane_centre_t_m(last.lane)).reversed()
        for wanted, got in ((start, path.start), (end, path.pose(path.length_m))):
            assert got.x_m == pytest.approx(wanted.x_m, abs=1e-3)
            assert got.y_m == pytest.approx(wanted.y_m, abs=1e-3)
            assert wrapped(got.heading_rad - wanted.heading_rad) == pytest.approx(0, abs=1e-6)
        assert [span.road for span in path.spans] == [step.road for step in route.steps]
        assert path.spans[0].start_m == 0.0
        assert path.spans[-1].end_m == pytest.approx(path.length_m)
        for before, after in zip(path.spans[:-1], path.spans[1:], strict=True):
            assert before.end_m == pytest.approx(after.start_m)


def test_a_lane_change_follows_half_a_cosine():
    net = network("straight", 2, lanes=2)
    route = next(r for r in net.routes[0, 1] if r.entry_lane == 2)
    change = LaneChange(position_m=30, length_m=40, lane_after=1)
    path = lay_drive(net, motion(route, exit_lane=1, lane_changes=(change,)), "car").path
    assert_smooth(path)
    y0 = path.y_m[0]
    offsets = np.abs(path.y_m - y0)
    assert offsets.max() == pytest.approx(3.5, abs=1e-9)
    at = np.interp([20.0, 40.0, 60.0], np.abs(path.x_m - path.x_m[0]), offsets)
    np.testing.assert_allclose(at, [0.0, 1.75, 3.5], atol=1e-3)
    assert [span.lane for span in path.spans] == [-2, -1, 1]


def test_overtaking_through_the_oncoming_lane_may_cross_the_joint_of_a_straight():
    net = network("straight", 2)
    route = net.routes[0, 1][0]
    out = LaneChange(position_m=60, length_m=30, lane_after=0)
    back = LaneChange(position_m=110, length_m=30, lane_after=1)
    laid = lay_drive(net, motion(route, lane_changes=(out, back)), "car")
    assert_smooth(laid.path)
    assert [(s.road, s.lane) for s in laid.path.spans] == [(1, -1), (1, 1), (2, -1), (2, 1)]


def test_a_ring_lane_change_leaves_from_the_new_lane():
    net = network("roundabout", 4, ring_lanes=2, ring_radius=32.0)
    route = next(r for r in net.routes[0, 2] if r.ring_lane == 1)
    plain = lay_drive(net, motion(route), "car")
    piece = [p for p in plain.stretches if is_ring(p.road)][-1]
    change = LaneChange(position_m=piece.start_m + 0.5, length_m=12.0, lane_after=2)
    laid = lay_drive(net, motion(route, lane_changes=(change,)), "car")
    assert_smooth(laid.path)
    last_ring = [s for s in laid.path.spans if is_ring(net.road(s.road))][-1]
    assert ring_lane_number(net.road(last_ring.road), last_ring.lane) == 2
    before, after = plain.path.spans[-2].road, laid.path.spans[-2].road
    assert before != after, "it must take the connecting road of the outer lane"


def test_a_ring_lane_change_without_room_says_how_much_there_is():
    net = network("roundabout", 4, ring_lanes=2)
    route = next(r for r in net.routes[0, 2] if r.ring_lane == 1)
    start = lay_drive(net, motion(route), "car").turning_starts_m
    change = LaneChange(position_m=start + 1, length_m=12.0, lane_after=2)
    with pytest.raises(MotionInfeasibleError, match="room from"):
        lay_drive(net, motion(route, lane_changes=(change,)), "car")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"entry_lane": 3}, "no lane 3"),
        ({"exit": 0}, "no route leads"),
        ({"start_m": 300.0}, "starts 300"),
        ({"exit_lane": 2}, "ends in lane 1"),
        ({"lane_changes": [{"position_m": 60, "length_m": 30, "lane_after": 2}]}, "wholly on"),
        ({"lane_changes": [{"position_m": 20, "length_m": 30, "lane_after": 0}]}, "oncoming"),
        ({"lane_changes": [{"position_m": 2, "length_m": 30, "lane_after": 2}]}, "before"),
        ({"lane_changes": [{"position_m": 999, "length_m": 3, "lane_after": 2}]}, "wholly on"),
    ],
)
def test_what_cannot_be_driven_is_refused_with_its_reason(change, message):
    net = network("four_way", 4, lanes=2)
    route = next(r for r in net.routes[0, 2] if r.entry_lane == 1)
    broken = DriveMotion.model_validate(motion(route).model_dump() | change)
    with pytest.raises(MotionInfeasibleError, match=message):
        lay_drive(net, broken, "car")


@pytest.mark.parametrize("side", ["right", "left"])
def test_crossing_runs_straight_from_side_to_side(side):
    net = network("four_way", 4)
    crossing = CrossingMotion(arm=1, start_side=Side(side), from_junction_m=5, setback_m=2)
    path = build_path(crossing, ParticipantKind.PEDESTRIAN, net, "ped")
    road = net.arm_road(1)
    assert path.length_m == pytest.approx(2 * 3.5 + 2 * 2)
    begin = road.line.pose(road.length_m - 5, 5.5 if side == "left" else -5.5)
    assert (path.start.x_m, path.start.y_m) == pytest.approx((begin.x_m, begin.y_m))
    chord = np.arctan2(np.diff(path.y_m), np.diff(path.x_m))[0]
    assert wrapped(chord - path.heading_rad[0]) == pytest.approx(0, abs=1e-9)
    stopped = crossing.model_copy(update={"stops_after_m": 4.0})
    assert build_path(stopped, ParticipantKind.PEDESTRIAN, net, "p").length_m == pytest.approx(4)


@pytest.mark.parametrize("driving_side", list(DrivingSide))
def test_those_who_stand_head_the_way_of_their_side(driving_side):
    place = Junction(kind=JunctionKind.FOUR_WAY, arms=4, driving_side=driving_side)
    net = build_network(plan_road(place, arm_length_m=ARM_M, parking_lanes={0}))
    road = net.arm_road(0)
    keeps = Side(driving_side.value)
    for side, forward in ((keeps, True), (next(s for s in Side if s is not keeps), False)):
        standing = StandingMotion(arm=0, side=side, from_junction_m=20)
        path = build_path(standing, CAR, net, "parked")
        assert path.length_m == 0.0
        turn = 0.0 if forward else pi
        assert wrapped(path.heading_rad[0] - road.line.start.heading_rad - turn) == pytest.approx(
            0, abs=1e-9
        )
        assert path.spans[0].lane * (1 if side is Side.LEFT else -1) == 2
        blocking = build_path(standing.model_copy(update={"in_lane": True}), CAR, net, "parked")
        assert abs(blocking.spans[0].lane) == 1


def test_standing_beyond_the_arm_is_refused():
    net = network()
    standing = StandingMotion(arm=0, side=Side.RIGHT, from_junction_m=ARM_M + 10)
    with pytest.raises(MotionInfeasibleError, match="beyond the outer end"):
        build_path(standing, CAR, net, "parked")
