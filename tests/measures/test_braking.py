"""Required decelerations against brute force: a little less hits, a little more does not."""

import numpy as np
import pytest

from scegen.measures.drac import deceleration_to_avoid
from scegen.measures.headway import time_headway
from scegen.measures.required_braking import before_area, behind_leader

DT = 1e-3


def travelled(speed, deceleration, times):
    """Distance travelled while braking to a stop."""
    t = np.minimum(times, speed / deceleration if deceleration > 0 else np.inf)
    return speed * t - deceleration * t * t / 2


def hits_leader(gap, speed, leader, braking, own):
    t = np.linspace(0.0, 500.0, 500_000)
    return bool(np.any(gap + travelled(leader, braking, t) - travelled(speed, own, t) < 0.0))


@pytest.mark.parametrize("seed", range(60))
def test_behind_a_leader_who_brakes_or_not(seed):
    rng = np.random.default_rng(seed)
    gap, speed, leader = rng.uniform(1, 60), rng.uniform(1, 35), rng.uniform(0, 35)
    braking = rng.choice([0.0, rng.uniform(0.5, 9)])
    needed = behind_leader(gap, speed, leader, braking)
    if needed > 0.0:
        assert hits_leader(gap, speed, leader, braking, needed * 0.99)
        assert not hits_leader(gap, speed, leader, braking, needed * 1.01)
    else:
        assert not hits_leader(gap, speed, leader, braking, 0.0)


@pytest.mark.parametrize("seed", range(40))
def test_drac_behind_a_leader_at_constant_speed(seed):
    rng = np.random.default_rng(seed)
    gap, speed, leader = rng.uniform(1, 60), rng.uniform(1, 35), rng.uniform(0, 35)
    drac = deceleration_to_avoid(gap, speed, leader)
    if speed <= leader:
        assert drac == 0.0
    else:
        assert hits_leader(gap, speed, leader, 0.0, drac * 0.99)
        assert not hits_leader(gap, speed, leader, 0.0, drac * 1.01)


def share_area(ahead, speed, length, other_ahead, other, other_to_leave, own):
    """Whether both are in the area at once, one braking until the other has left."""
    t = np.arange(0.0, 80.0, DT)
    s, s_other = travelled(speed, own, t), other * t
    inside = (s > ahead) & (s < ahead + length)
    return bool(np.any(inside & (s_other > other_ahead) & (s_other < other_to_leave)))


@pytest.mark.parametrize("seed", range(120))
def test_before_a_conflict_area(seed):
    rng = np.random.default_rng(seed)
    ahead, length, speed = rng.uniform(2, 60), rng.uniform(3, 12), rng.uniform(2, 25)
    other = rng.choice([0.0, rng.uniform(1, 25), rng.uniform(1, 25)])
    other_ahead = rng.uniform(-5, 60)
    other_to_leave = max(other_ahead + rng.uniform(6, 15), 0.1)
    case = (ahead, speed, length, other_ahead, other, other_to_leave)
    needed = before_area(*case)
    conflict = share_area(*case, 0.0)
    if needed == 0.0:
        assert not conflict
    else:
        assert conflict
        assert share_area(*case, needed * 0.99)
        assert not share_area(*case, needed * 1.01)


def test_nothing_is_needed_inside_or_after_the_other():
    assert before_area(-0.1, 10.0, 5.0, 0.0, 1.0, 4.0) == 0.0
    assert before_area(10.0, 10.0, 5.0, -9.0, 1.0, -1.0) == 0.0


def test_headway_is_undefined_at_a_creep():
    assert time_headway(10.0, 5.0) == 2.0
    assert np.isnan(time_headway(10.0, 0.05))
    assert np.isnan(time_headway(np.nan, 5.0))
