"""Car following: what a driver does behind another, against its own promise and the sources'."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.motion.following import (
    REACTIONS_S,
    SOFTEST_MPS2,
    STANDS_BEHIND_M,
    TIME_GAPS_S,
    Change,
    Driver,
    brakes,
    driver_of,
    goes_on,
)

STEP_S = 0.005


def way(speed_mps, change, times):
    """The way travelled by one who changes its speed once."""
    after = np.maximum(times - change.begins_s, 0.0)
    sign = np.sign(change.to_mps - speed_mps)
    speed = speed_mps + sign * np.minimum(change.rate_mps2 * after, abs(change.to_mps - speed_mps))
    return np.concatenate(([0.0], np.cumsum((speed[1:] + speed[:-1]) / 2 * STEP_S)))


@given(
    speed=st.floats(5, 40),
    share=st.floats(0, 0.9),
    rate=st.floats(1, 9),
    reaction=st.floats(0.5, 1.5),
    gap_s=st.floats(0.3, 3),
)
def test_who_follows_keeps_its_time_gap_and_never_comes_nearer(speed, share, rate, reaction, gap_s):
    ahead = Change(1.0, share * speed, rate)
    gap = STANDS_BEHIND_M + gap_s * speed
    found = brakes(Driver(reaction, gap_s), speed, gap, speed, ahead)
    if found is None:
        assert gap_s < reaction + 1e-9 or (1 - share) * speed < 0.31
        return
    assert found.begins_s >= ahead.begins_s + reaction - 1e-9
    assert found.rate_mps2 <= rate + 1e-9
    times = np.arange(0.0, 1.0 + gap_s + 2 * speed / min(rate, SOFTEST_MPS2) + 5.0, STEP_S)
    free = gap + way(speed, ahead, times) - way(speed, found, times)
    ends = STANDS_BEHIND_M + gap_s * ahead.to_mps
    assert free[-1] == pytest.approx(ends, abs=0.1)
    assert free.min() > ends - 0.1


def test_whose_time_gap_is_its_reaction_time_does_what_the_one_ahead_did():
    ahead = Change(3.0, 5.0, 6.0)
    found = brakes(Driver(1.2, 1.2), 20.0, STANDS_BEHIND_M + 24.0, 20.0, ahead)
    assert (found.begins_s, found.rate_mps2) == (pytest.approx(4.2), pytest.approx(6.0))


def test_braking_grows_softer_from_car_to_car_and_later():
    change, rates = Change(0.0, 0.0, 7.0), [7.0]
    for number in range(6):
        driver = driver_of(0, number)
        gap = STANDS_BEHIND_M + 14.0 * driver.time_gap_s
        after = brakes(driver, 14.0, gap, 14.0, change)
        assert after.begins_s > change.begins_s + 0.7
        change = after
        rates.append(change.rate_mps2)
    assert rates == sorted(rates, reverse=True)
    assert rates[-1] == SOFTEST_MPS2


def test_drivers_differ_and_are_the_same_each_time():
    drivers = [driver_of(3, number) for number in range(50)]
    assert drivers == [driver_of(3, number) for number in range(50)]
    assert len({driver.reaction_s for driver in drivers}) > 20
    for driver in drivers:
        assert REACTIONS_S[0] <= driver.reaction_s <= REACTIONS_S[1]
        assert TIME_GAPS_S[0] <= driver.time_gap_s <= TIME_GAPS_S[1]


def test_who_goes_on_with_another_is_no_faster_than_before():
    found = goes_on(Driver(1.0, 1.5), 12.0, Change(8.0, 30.0, 3.0))
    assert found == Change(9.0, 12.0, 2.0)
