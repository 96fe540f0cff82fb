"""Movements are named by geometry."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.scenario.arms import arm_angles_deg, exit_arm, seen_from, turn_deg, turn_name
from scegen.scenario.junction import Junction

FOUR = (0.0, 90.0, 180.0, 270.0)
T = (0.0, 180.0, 270.0)
Y = (30.0, 150.0, 270.0)


@pytest.mark.parametrize("entry", range(4))
def test_a_four_way_turns_right_goes_straight_turns_left(entry):
    assert [turn_name(FOUR, entry, d) for d in range(4)] == ["u_turn", "right", "straight", "left"]


def test_a_t_has_its_stem_between_the_bars():
    assert [turn_name(T, 0, d) for d in (1, 2)] == ["straight", "left"]
    assert [turn_name(T, 1, d) for d in (1, 2)] == ["right", "straight"]
    assert [turn_name(T, 2, d) for d in (1, 2)] == ["right", "left"]


def test_a_y_has_no_way_straight_on():
    for entry in range(3):
        assert [turn_name(Y, entry, d) for d in (1, 2)] == ["right", "left"]


def test_where_others_come_from():
    assert seen_from(FOUR, 0, 1) == {"right"}
    assert seen_from(FOUR, 0, 2) == {"opposite"}
    assert seen_from(FOUR, 0, 3) == {"left"}
    assert seen_from(FOUR, 0, 0) == {"ahead", "behind", "adjacent"}
    assert seen_from(Y, 0, 1) == {"right", "opposite"}
    # on the stem of a T nobody is opposite: the ends of the bar face each other
    assert seen_from(T, 0, 1) == {"opposite"}
    assert seen_from(T, 2, 0) == {"right"}
    assert seen_from(T, 2, 1) == {"left"}


angles = st.lists(st.integers(0, 359), min_size=2, max_size=8, unique=True).map(
    lambda a: tuple(float(x) for x in sorted(a))
)


@given(angles, st.data())
def test_going_back_turns_the_other_way(at, data):
    entry = data.draw(st.integers(0, len(at) - 1))
    move = data.draw(st.integers(1, len(at) - 1))
    out = exit_arm(entry, move, len(at))
    there, back = turn_deg(at, entry, move), turn_deg(at, out, len(at) - move)
    assert (there + back) % 360 == pytest.approx(0, abs=1e-9)


@given(angles, st.integers(0, 359), st.data())
def test_turning_the_whole_junction_changes_no_name(at, by, data):
    entry = data.draw(st.integers(0, len(at) - 1))
    turned = sorted((a + by) % 360 for a in at)
    shift = turned.index((at[0] + by) % 360)
    new_entry = (entry + shift) % len(at)
    for move in range(len(at)):
        assert turn_name(at, entry, move) == turn_name(tuple(turned), new_entry, move)


def test_templates_give_one_angle_for_each_arm():
    for kind, arms in (("straight", 2), ("t", 3), ("skewed", 4), ("multi_way", 7)):
        at = arm_angles_deg(Junction(kind=kind, arms=arms))
        assert len(at) == arms
        assert list(at) == sorted(at)
