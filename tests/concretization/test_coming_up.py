"""Coming up behind those who are slower or stand, and straying towards those who come."""

import numpy as np
import pytest
import shapely
from told import first, told, who

from scegen.motion import build_paths, simulate
from scegen.motion.footprints import box_corners
from scegen.road import build_network


def traces(concrete):
    paths = build_paths(concrete, build_network(concrete.road))
    return simulate(concrete, paths, dt_s=0.02)


def gap_m(concrete, follower="ego", leader="x"):
    """Clear gap of two in one straight lane, by time."""
    found = traces(concrete)
    one, two = found[follower], found[leader]
    bodies = one.body.front_m + two.body.rear_m
    return np.hypot(one.x_m - two.x_m, one.y_m - two.y_m) - bodies


def distance_m(found, first, second):
    """The least distance of two boxes."""
    boxes = [
        shapely.polygons(box_corners(t.body, t.x_m, t.y_m, t.heading_rad))
        for t in (found[first], found[second])
    ]
    return float(shapely.distance(*boxes).min())


@pytest.mark.parametrize("speed", [3.0, 5.0, 8.0])
def test_it_is_close_behind_when_both_are_equally_fast(speed):
    rider = who("x", "bicycle", ["ahead"], ["straight"], speed=speed)
    concrete = first(told("straight", [who("ego", maneuvers=["straight"]), rider]))
    gap = gap_m(concrete)
    assert 0.3 < gap.min() < 1.2
    after = traces(concrete)["ego"].speed_mps[int(gap.argmin()) :]
    assert after.max() <= speed + 0.5


def test_one_who_is_as_fast_does_not_brake():
    people = [who("ego", speed=10.0), who("x", "car", ["ahead"], speed=10.0)]
    assert first(told("straight", people)).ego.speed_program == ()


def test_a_queue_stands_and_who_stops_behind_it_stays():
    queue = [who(name, "car", ["ahead"], ["stay"]) for name in ("x", "y", "z")]
    concrete = first(told("straight", [who("ego", speed=27.8), *queue]))
    found = traces(concrete)
    assert found["ego"].speed_mps[-1] == 0.0
    for name in ("x", "y", "z"):
        assert concrete.participant(name).speed_program == ()
        assert found[name].speed_mps.max() == 0.0
    nearest = min(("x", "y", "z"), key=lambda name: gap_m(concrete, "ego", name)[0])
    assert 0.3 < gap_m(concrete, "ego", nearest).min() < 1.5


def test_slow_ones_in_a_line_are_equally_slow():
    people = [who("ego", speed=25.0), who("x", "car", ["ahead"]), who("y", "car", ["ahead"])]
    slow = [("slow_driving", "x", "ego"), ("slow_driving", "y", "ego")]
    concrete = first(told("straight", people, slow))
    assert concrete.participant("x").speed_mps == concrete.participant("y").speed_mps
    assert concrete.road.arms[0].length_m < 400.0


@pytest.mark.parametrize("speed", [10.0, 17.0, 25.0, 33.0])
def test_a_stray_is_met_as_it_comes_back(speed):
    people = [who("ego", speed=speed), who("x", "car", ["opposite"], ["straight"])]
    concrete = first(told("straight", people, [("oncoming_lane", "x", "ego")]))
    found = traces(concrete)
    ego, x = found["ego"], found["x"]
    nearest = int(np.hypot(ego.x_m - x.x_m, ego.y_m - x.y_m).argmin())
    back = concrete.participant("x").motion.lane_changes[1]
    place = concrete.participant("x").motion.start_m + x.s_m[nearest]
    assert back.position_m < place < back.position_m + back.length_m + 0.25 * speed + 5.0


@pytest.mark.parametrize("maneuver", ["overtake", "lane_change"])
def test_one_who_stays_is_gone_round_close_by(maneuver):
    people = [who("ego", maneuvers=[maneuver]), who("x", "car", ["ahead"], ["stay"])]
    concrete = first(told("straight", people))
    assert concrete.ego.motion.lane_changes
    x = concrete.participant("x")
    assert (x.speed_mps, x.speed_program) == (0.0, ())
    found = traces(concrete)
    assert found["x"].speed_mps.max() == 0.0
    assert found["ego"].s_m[-1] + concrete.ego.motion.start_m > x.motion.start_m
    assert 0.3 < distance_m(found, "ego", "x") < 0.8
