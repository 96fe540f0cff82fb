"""Where somebody is placed for a measure, that measure is found."""

from __future__ import annotations

import numpy as np
import pytest
from gaps import gap_m
from hypothesis import assume, given
from hypothesis import strategies as st

from scegen.concretization.along.runner import Runner
from scegen.concretization.along.spacing import GapAt, level, place
from scegen.concretization.boxes import missing_m
from scegen.concretization.profile import SpeedChange
from scegen.scenario.bodies import BODIES
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import ParticipantKind

KINDS = st.sampled_from(list(ParticipantKind))
MEASURES = st.sampled_from([Measure.GAP_M, Measure.HEADWAY_S, Measure.TTC_S])


@st.composite
def runners(draw, name, forward):
    found = Runner(name, kind := draw(KINDS), BODIES[kind], forward, 1, draw(st.floats(1.0, 40.0)))
    if draw(st.booleans()):
        begins, target = draw(st.floats(0.0, 6.0)), draw(st.floats(0.0, 40.0))
        found.steps.append(SpeedChange(target, draw(st.floats(0.5, 9.0)), begins))
    return found


@given(st.data(), MEASURES, st.floats(0.1, 50.0), st.floats(0.0, 20.0), st.booleans())
def test_the_measure_placed_is_the_measure_found(data, measure, value, time_s, ahead):
    forward, same_way = data.draw(st.booleans()), data.draw(st.booleans())
    other = data.draw(runners("other", forward))
    who = data.draw(runners("who", forward == same_way))
    ahead = ahead or not same_way
    other.at_m = data.draw(st.floats(-100.0, 100.0))
    front, back = (who, other) if ahead else (other, who)
    along = front.speed_at_mps(time_s) * (1 if same_way else -1)
    if measure is Measure.TTC_S:
        assume(back.speed_at_mps(time_s) - along > 0.2)
    if measure is Measure.HEADWAY_S:
        assume(back.speed_at_mps(time_s) > 0.2)
    place(GapAt(who, other, measure, value, time_s, ahead))
    at = np.array([time_s])
    (missing,) = missing_m(measure, value, other.track(at), who.track(at))
    assert missing == pytest.approx(0.0, abs=1e-6)
    gap = gap_m(who, other, time_s)
    closing = back.speed_at_mps(time_s) - along
    speeds = {Measure.GAP_M: 1.0, Measure.TTC_S: closing}
    assert gap == pytest.approx(value * speeds.get(measure, back.speed_at_mps(time_s)), rel=1e-6)


@given(st.data(), st.floats(0.0, 20.0), st.booleans())
def test_who_is_level_has_its_middle_beside_the_others(data, time_s, same_way):
    other = data.draw(runners("other", True))
    who = data.draw(runners("who", same_way))
    other.at_m = 12.0
    who.at_m = level(who, other, time_s)
    least = -(who.body.length_m + other.body.length_m) / 2
    assert gap_m(who, other, time_s) == pytest.approx(least)
