"""Ways beside the usual ones: across other lanes, late, and back on a road without a junction."""

from math import hypot, pi

import pytest

from scegen.road import build_network, plan_road
from scegen.road.fillet import connect, smallest_radius_m
from scegen.road.geometry import Pose
from scegen.scenario.junction import Junction
from scegen.scenario.road_parameters import Turn


def network(kind, arms, turns, **more):
    road = plan_road(Junction(kind=kind, arms=arms, lanes=(2,) * arms), **more)
    return build_network(road.model_copy(update={"turns": tuple(turns)}))


def lanes(built, entry, leaving):
    return {(route.entry_lane, route.exit_lane) for route in built.routes[entry, leaving]}


def radius_m(built, entry, leaving, lane):
    route = next(r for r in built.routes[entry, leaving] if r.entry_lane == lane)
    return smallest_radius_m(built.road(route.steps[1].road).line)


def test_a_turn_from_another_lane_is_one_more_way():
    usual = network("four_way", 4, [])
    assert lanes(usual, 0, 1) == {(2, 2)}
    more = network("four_way", 4, [Turn(entry=0, lane_in=1, exit=1, lane_out=1)])
    assert lanes(more, 0, 1) == {(2, 2), (1, 1)}
    assert all(lanes(more, *pair) == lanes(usual, *pair) for pair in usual.routes if pair != (0, 1))


def test_a_late_turn_takes_the_place_of_the_usual_one():
    late = network("four_way", 4, [Turn(entry=0, lane_in=1, exit=3, lane_out=1, radius_m=6.5)])
    assert lanes(late, 0, 3) == {(1, 1)}
    assert radius_m(late, 0, 3, 1) == pytest.approx(6.5)
    assert radius_m(network("four_way", 4, []), 0, 3, 1) > 10.0


def test_a_tighter_curve_still_joins_both_ends():
    start, end = Pose(0.0, 0.0, 0.0), Pose(20.0, 30.0, pi / 2)
    for most in (None, 8.0, 50.0):
        line = connect(start, end, most)
        assert hypot(line.end.x_m - end.x_m, line.end.y_m - end.y_m) < 1e-6
        assert smallest_radius_m(line) == pytest.approx(min(most or 20.0, 20.0))


@pytest.mark.parametrize("count", [1, 2, 3])
def test_a_straight_road_has_a_place_to_turn_back(count):
    road = plan_road(Junction(kind="straight", arms=2, lanes=(count,) * 2), u_turns={1})
    turn = Turn(entry=1, lane_in=count, exit=1, lane_out=count)
    built = build_network(road.model_copy(update={"turns": (turn,)}))
    assert lanes(built, 1, 1) == {(count, count)}
    half = (2 * count - 1) * 3.5 / 2
    assert radius_m(built, 1, 1, count) == pytest.approx(max(half, 4.0))
    assert lanes(built, 0, 1) == {(n, n) for n in range(1, count + 1)}
    assert (0, 0) not in built.routes
