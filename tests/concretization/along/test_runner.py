"""Movements in time: way, speed and time say the same thing."""

from __future__ import annotations

from itertools import accumulate

import numpy as np
import pytest
from gaps import gap_m
from hypothesis import given
from hypothesis import strategies as st

from scegen.concretization.along.runner import Move, Runner
from scegen.concretization.profile import NEVER_S, Profile, SpeedChange
from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ParticipantKind

SPEEDS = st.floats(0.0, 40.0)
TIMES = st.floats(0.0, 60.0)


@st.composite
def profiles(draw):
    waits = draw(st.lists(st.floats(0.0, 8.0), max_size=4))
    profile = Profile(draw(SPEEDS))
    for begins in accumulate(waits):
        profile.change(begins, draw(SPEEDS), draw(st.floats(0.5, 9.0)))
    return profile


@given(profiles(), TIMES)
def test_the_way_is_the_speed_summed_up(profile, time_s):
    half = 1e-3
    rate = (profile.way_m(time_s + half) - profile.way_m(time_s)) / half
    assert rate == pytest.approx(profile.speed_mps(time_s), abs=0.02)
    assert profile.speed_mps(time_s) >= -1e-9


@given(profiles(), TIMES)
def test_time_and_way_are_inverse_while_it_moves(profile, time_s):
    way = profile.way_m(time_s)
    if profile.speed_mps(time_s) > 0.1:
        assert profile.time_s(way) == pytest.approx(time_s, abs=1e-5)
    reached = profile.time_s(way + 1.0)
    if reached < NEVER_S:
        assert profile.way_m(reached) == pytest.approx(way + 1.0, abs=1e-6)
    else:
        assert profile.way_m(200.0) < way + 1.0


@given(profiles(), TIMES)
def test_after_it_has_settled_the_speed_is_held(profile, time_s):
    settled = profile.settles_s(time_s)
    assert settled >= time_s or profile.speed_mps(time_s) == profile.speed_mps(settled)


@given(SPEEDS, SPEEDS, st.floats(0.5, 9.0), st.floats(0.0, 10.0))
def test_a_step_takes_its_change_by_its_rate(speed, target, rate, begins):
    profile = Profile(speed)
    profile.change(begins, target, rate)
    ends = begins + abs(target - speed) / rate
    assert profile.speed_mps(ends + 0.01) == pytest.approx(target, abs=1e-6)
    assert profile.settles_s(begins) == pytest.approx(ends, abs=1e-6)
    middle = profile.speed_mps((begins + ends) / 2)
    assert middle == pytest.approx((speed + target) / 2, abs=1e-6)


def test_what_begins_later_gives_up_what_is_under_way():
    profile = Profile(20.0)
    profile.change(1.0, 0.0, 4.0)
    profile.change(2.0, 20.0, 2.0)
    assert profile.speed_mps(2.0) == pytest.approx(16.0)
    assert profile.speed_mps(10.0) == 20.0


def runner(forward, **more):
    found = Runner("x", ParticipantKind.CAR, BODIES[ParticipantKind.CAR], forward, 1, 10.0, **more)
    found.at_m = 0.0
    return found


@pytest.mark.parametrize("keeps_left", [False, True])
@pytest.mark.parametrize("forward", [True, False])
def test_it_is_in_its_lane_and_ends_in_the_one_it_moves_to(forward, keeps_left):
    own = runner(forward, keeps_left=keeps_left)
    own.moves = [Move(2.0, 3.0, 2), Move(8.0, 3.0, 1, offset_m=0.5)]
    side = (1 if keeps_left else -1) * own.sign
    assert own.y_m(0.0) == pytest.approx(side * 1.75)
    assert own.y_m(3.5) == pytest.approx(side * 3.5)
    assert own.y_m(6.0) == pytest.approx(side * 5.25)
    assert own.y_m(20.0) == pytest.approx(side * 1.75 + own.sign * 0.5)
    assert [own.lane_at(t) for t in (0.0, 3.0, 9.0)] == [1, 2, 1]


@pytest.mark.parametrize("forward", [True, False])
def test_the_gap_is_between_the_nearer_ends(forward):
    first, second = runner(True), runner(forward)
    second.at_m = 40.0
    body = BODIES[ParticipantKind.CAR]
    near = body.rear_m if forward else body.front_m
    assert gap_m(first, second, 0.0) == pytest.approx(40.0 - body.front_m - near)
    assert gap_m(second, first, 0.0) == gap_m(first, second, 0.0)


def test_its_way_follows_steps_that_are_added_later():
    own = runner(True)
    assert own.x_m(10.0) == pytest.approx(100.0)
    own.steps.append(SpeedChange(20.0, 5.0))
    assert own.x_m(10.0) > 150.0
    own.steps.clear()
    assert own.x_m(10.0) == pytest.approx(100.0)


@given(st.data(), st.booleans(), st.booleans())
def test_boxes_over_time_are_where_it_is_and_turned_as_it_goes(data, forward, backs):
    own = runner(forward, backs=backs)
    own.steps = [SpeedChange(data.draw(st.floats(3.0, 30.0)), 2.0, 2.0)]
    own.moves = [Move(1.0, 3.0, 2), Move(data.draw(st.floats(4.5, 8.0)), 2.5, 1, offset_m=0.5)]
    times = np.linspace(0.0, 15.0, 61)
    boxes, speeds = own.track(times)
    ahead = own.body.centre_ahead_m
    assert [own.x_m(t) for t in times] == pytest.approx(list(boxes.x - ahead * boxes.cos))
    assert [own.y_m(t) for t in times] == pytest.approx(list(boxes.y - ahead * boxes.sin))
    assert [own.speed_at_mps(t) for t in times] == pytest.approx(list(speeds))
    assert list(np.hypot(boxes.cos, boxes.sin)) == pytest.approx([1.0] * 61)
    half = 1e-4
    for time_s, sin, speed in zip(times, boxes.sin, speeds, strict=True):
        aside = (own.y_m(time_s + half) - own.y_m(time_s - half)) / (2 * half)
        assert sin * speed * (-1 if backs else 1) == pytest.approx(aside, abs=0.02)
