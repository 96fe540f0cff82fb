"""On a bend, what is said of the road is judged along it."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from scegen.claims.straightened import Axis, straightened
from scegen.motion.batch.arrays import COS, HEADING, SIN, TRACK_ROWS, X, Y
from scegen.road import build_network, plan_road
from scegen.road.geometry import ReferenceLine
from scegen.scenario.junction import Junction


def centre_line(side, radius):
    bend = {"side": side, "radius_m": radius}
    network = build_network(plan_road(Junction(kind="straight", arms=2, bend=bend)))
    second = network.arm_road(1).line.reversed()
    return ReferenceLine((*network.arm_road(0).line.segments, *second.segments))


@given(
    st.sampled_from(["left", "right"]),
    st.floats(40, 500),
    st.lists(st.tuples(st.floats(0, 1), st.floats(-12, 12)), min_size=1, max_size=8),
    st.floats(-3, 3),
)
def test_places_along_the_road_are_found_again(side, radius, places, turned):
    line = centre_line(side, radius)
    tracks = np.zeros((1, 1, TRACK_ROWS, len(places)))
    for n, (share, left) in enumerate(places):
        pose = line.pose(share * line.length_m, left)
        heading = pose.heading_rad + turned
        tracks[0, 0, [X, Y, HEADING], n] = pose.x_m, pose.y_m, heading
        tracks[0, 0, [COS, SIN], n] = np.cos(heading), np.sin(heading)
    told = straightened(Axis(line, 0.0), tracks)[0, 0]
    wanted = np.array([(share * line.length_m, left) for share, left in places])
    np.testing.assert_allclose(told[[X, Y]].T, wanted, atol=1e-6)
    np.testing.assert_allclose(told[COS], np.cos(turned), atol=1e-6)
    np.testing.assert_allclose(told[SIN], np.sin(turned), atol=1e-6)


@given(st.sampled_from(["left", "right"]), st.floats(60, 500), st.floats(-6, 6))
def test_lengths_are_those_of_the_lane(side, radius, beside):
    """Two in the lane of the ego are as far apart as its middle is long between them."""
    line = centre_line(side, radius)
    begin, end = 0.3 * line.length_m, 0.7 * line.length_m
    steps = np.linspace(begin, end, 2001)
    poses = [line.pose(s, beside) for s in steps]
    walked = np.hypot(np.diff([p.x_m for p in poses]), np.diff([p.y_m for p in poses])).sum()
    tracks = np.zeros((1, 1, TRACK_ROWS, 2))
    for n, pose in enumerate((poses[0], poses[-1])):
        tracks[0, 0, [X, Y, HEADING], n] = pose.x_m, pose.y_m, pose.heading_rad
    told = straightened(Axis(line, beside), tracks)[0, 0]
    assert abs(told[X, 1] - told[X, 0] - walked) < 0.01
