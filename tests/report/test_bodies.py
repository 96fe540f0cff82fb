"""Brake lights: on while somebody slows down, and stands after that."""

import numpy as np

from scegen.motion.model import Trace
from scegen.report.bodies import braking
from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ParticipantKind


def trace(speeds):
    steps = np.arange(len(speeds), dtype=float) / 10
    zero = np.zeros(len(speeds))
    return Trace("a", BODIES[ParticipantKind.CAR], steps, zero, zero, zero, zero, np.array(speeds))


def test_brake_lights_are_on_while_slowing_down_and_standing_after_that():
    on = braking(
        trace([5.0] * 5 + [5.0 - 0.5 * n for n in range(11)] + [0.0] * 4 + [1.0, 2.0, 3.0])
    )
    assert not on[:4].any()
    assert on[6:18].all()
    assert not on[-3:].any()


def test_who_stands_all_the_time_shows_none():
    assert not braking(trace([0.0] * 5)).any()
    assert not braking(trace([0.0])).any()
    assert not braking(trace([10.0, 10.02, 10.0, 9.99])).any()  # that is no braking
