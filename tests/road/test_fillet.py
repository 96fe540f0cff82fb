from math import cos, degrees, hypot, inf, pi, radians, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scegen.road.fillet import connect, smallest_radius_m, turn_back, wrapped
from scegen.road.geometry import Pose


def assert_same(pose, wanted):
    assert hypot(pose.x_m - wanted.x_m, pose.y_m - wanted.y_m) < 1e-6
    assert abs(wrapped(pose.heading_rad - wanted.heading_rad)) < 1e-7


def test_in_line_is_one_line():
    line = connect(Pose(0, 0, 0), Pose(12, 0, 0))
    assert [(s.length_m, s.curvature_1pm) for s in line.segments] == [(12, 0)]
    assert smallest_radius_m(line) == inf


def test_nothing_leads_straight_back():
    assert connect(Pose(0, 0, 0), Pose(-12, 0, 0)) is None


def test_quarter_turn_is_one_arc():
    line = connect(Pose(0, 0, 0), Pose(10, 10, pi / 2))
    assert [s.length_m for s in line.segments] == pytest.approx([5 * pi])
    assert smallest_radius_m(line) == pytest.approx(10)


def test_unequal_legs_put_the_line_on_the_longer_one():
    line = connect(Pose(0, 0, 0), Pose(20, -8, -pi / 2))
    assert [s.curvature_1pm for s in line.segments] == pytest.approx([0, -1 / 8])
    assert line.segments[0].length_m == pytest.approx(12)


def test_offset_lanes_are_joined_by_an_s_curve():
    line = connect(Pose(0, 0, 0), Pose(20, 3.5, 0))
    assert [s.curvature_1pm > 0 for s in line.segments] == [True, False]
    # Two equal arcs over 20 m and 3.5 m sideways: R = (20² + 3.5²) / (4 · 3.5).
    assert smallest_radius_m(line) == pytest.approx((400 + 12.25) / 14)


@settings(max_examples=300, derandomize=True)
@given(st.floats(3, 60), st.floats(-30, 30), st.floats(-170, 170))
def test_every_curve_arrives(ahead, left, turn_deg):
    start = Pose(5, -7, radians(33))
    place = start.shifted(ahead, left)
    end = Pose(place.x_m, place.y_m, start.heading_rad + radians(turn_deg))
    line = connect(start, end)
    if line is not None:
        assert_same(line.start, start)
        assert_same(line.end, end)
        for before, after in zip(line.segments, line.segments[1:], strict=False):
            assert_same(before.end, after.start)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("separation", [2.75, 3.5, 8.0, 10.5])
def test_turning_back_ends_beside_the_start(sign, separation):
    start = Pose(1, 2, radians(70))
    line = turn_back(start, separation, 4.0, sign)
    beside = start.shifted(left_m=sign * separation)
    assert_same(line.end, beside.reversed())
    assert smallest_radius_m(line) >= 4.0 - 1e-9


def test_wrapped_keeps_the_direction():
    for angle in (-7.0, -pi, 0.0, 3.0, 12.5):
        assert -pi < wrapped(angle) <= pi
        assert cos(wrapped(angle)) == pytest.approx(cos(angle))
        assert sin(wrapped(angle)) == pytest.approx(sin(angle), abs=1e-12)
    assert degrees(wrapped(radians(190))) == pytest.approx(-170)
