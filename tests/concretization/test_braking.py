"""Braking begins as late as leaves room, and whoever touches first answers first."""

from __future__ import annotations

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from scegen.concretization.amounts import CLOSEST_M
from scegen.concretization.answering import answer_each, brake_late
from scegen.concretization.traffic import Contact
from scegen.motion.trigger_steps import STEP_S


class Approach:
    """Towards something that stands ``far_m`` ahead."""

    def __init__(self, speed_mps, far_m):
        self.speed_mps, self.far_m = speed_mps, far_m
        self.begins_s, self.rate_mps2 = 0.0, 1.0

    def brake(self, begins_s, rate_mps2):
        self.begins_s, self.rate_mps2 = begins_s, rate_mps2

    @property
    def room_m(self):
        way = self.speed_mps * self.begins_s + self.speed_mps**2 / (2 * self.rate_mps2)
        return self.far_m - way

    def leaves(self, room_m):
        return self.room_m >= room_m


@given(
    st.floats(3.0, 40.0),
    st.floats(5.0, 300.0),
    st.lists(st.floats(2.0, 9.0), min_size=1, max_size=3).map(sorted),
    st.floats(0.0, 3.0),
)
def test_it_begins_as_late_and_brakes_as_hard_as_leaves_a_little_room(speed, far, rates, earliest):
    one = Approach(speed, far)
    found = brake_late(one.leaves, far / speed, rates, earliest, one.brake)
    stops = [far - speed * earliest - speed**2 / (2 * rate) for rate in rates]
    if found is None:
        assert max(stops) < CLOSEST_M / 2 + 1e-6
        return
    assert found == (one.begins_s, one.rate_mps2)
    both = zip(rates, stops, strict=True)
    taken, least_m = next(pair for pair in both if pair[1] >= CLOSEST_M / 2)
    assert one.begins_s >= earliest
    assert one.rate_mps2 <= taken
    assert one.rate_mps2 == taken or len(rates) > 1
    assert one.room_m >= min(CLOSEST_M, least_m) - 1e-6
    assume(least_m > CLOSEST_M)
    later = one.begins_s + 2 * STEP_S + far / speed / 2**12
    one.brake(later, taken)
    assert one.room_m < CLOSEST_M or later >= far / speed


def test_whoever_touches_first_answers_first_and_who_cannot_is_told():
    open_ = [Contact(3.0, "c", "b"), Contact(2.0, "b", "a"), Contact(2.5, "d", "a")]
    asked = []

    def brakes(contact):
        asked.append(contact.who)
        if contact.who != "d":
            open_.remove(contact)
        return contact.who != "d"

    assert answer_each(lambda: open_, brakes, 10) == [("d", "a")]
    assert asked == ["b", "d", "c"]


@pytest.mark.parametrize("rounds", [0, 3])
def test_nobody_is_asked_more_often_than_said(rounds):
    asked = []
    always = [Contact(1.0, "a", "b")]
    answer_each(lambda: always, lambda c: asked.append(c) is None, rounds)
    assert len(asked) == rounds
