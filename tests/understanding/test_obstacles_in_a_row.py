"""Several in the way, told one after the other with their distances."""

from __future__ import annotations

import pytest

from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.reader import read


@pytest.mark.parametrize(
    ("text", "gaps"),
    [
        (
            "The ego approaches two obstacles at 50 km/h: a stopped bus 80 m ahead and a stopped "
            "car 100 m ahead.",
            {"bus_1": 80.0, "car_1": 100.0},
        ),
        (
            "Two things block the lane of the ego: a stationary car 50 m ahead and a standing "
            "pedestrian 70 m ahead.",
            {"car_1": 50.0, "pedestrian_1": 70.0},
        ),
        (
            "A pedestrian stands in the ego's lane 90 m ahead, and a stopped van 120 m ahead.",
            {"pedestrian_1": 90.0, "van_1": 120.0},
        ),
    ],
)
def test_each_stands_so_far_ahead_of_the_ego(text, gaps):
    scenario = read(text)
    found = {s.participant: s.value.low for s in scenario.spacings if s.reference == "ego"}
    assert found == gaps
    for name in gaps:
        member = scenario.participant(name)
        assert member.approaches == {Approach.AHEAD}
        assert member.maneuvers == {Maneuver.STAY}


def test_behind_somebody_on_foot_is_farther_on():
    scenario = read(
        "Two obstacles block the ego's lane: a standing pedestrian 60 m ahead of the ego and, "
        "behind the pedestrian, a stationary bus 70 m ahead."
    )
    (relation,) = scenario.relations
    assert (relation.participant, relation.reference) == ("bus_1", "pedestrian_1")
    assert relation.approaches == {Approach.AHEAD}
