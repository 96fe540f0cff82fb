"""Turning back on a road without a junction: wide enough, or refused with the numbers."""

import numpy as np
import pytest
from told import first, told, who

from scegen.errors import MotionInfeasibleError
from scegen.motion import build_paths
from scegen.road import build_network
from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ParticipantKind

EGO = who("ego", maneuvers=["straight"])


def turns_back(kind, lanes=0, approach="opposite", **more):
    other = who("x", kind, [approach], ["u_turn"])
    return first(told("straight", [EGO, other], lanes=lanes, **more))


def path_of(concrete, name="x"):
    return build_paths(concrete, build_network(concrete.road))[name]


@pytest.mark.parametrize(
    ("kind", "lanes"), [("car", 2), ("van", 2), ("motorcycle", 2), ("truck", 3), ("bus", 3)]
)
def test_the_road_is_as_wide_as_the_vehicle_needs(kind, lanes):
    concrete = turns_back(kind)
    assert {arm.lanes_in for arm in concrete.road.arms} == {lanes}
    path = path_of(concrete)
    turned = abs(path.heading_rad[-1] - path.heading_rad[0])
    assert turned == pytest.approx(np.pi, abs=1e-6)
    radius = np.diff(path.s_m) / np.maximum(np.abs(np.diff(path.heading_rad)), 1e-9)
    wheelbase = BODIES[ParticipantKind(kind)].wheelbase_m
    assert radius.min() > 1.25 * wheelbase


def test_from_kerb_to_kerb_on_either_side():
    right, left = path_of(turns_back("car")), path_of(turns_back("car", side="left"))
    for path in (right, left):
        assert abs(path.y_m[0] - path.y_m[-1]) == pytest.approx(10.5, abs=1e-6)
    assert np.sign(right.heading_rad[-1] - right.heading_rad[0]) == -np.sign(
        left.heading_rad[-1] - left.heading_rad[0]
    )


def test_a_car_swings_out_on_a_narrow_road_and_a_bus_cannot():
    concrete = turns_back("car", lanes=1)
    assert concrete.road.turns[0].radius_m == 4.0
    assert concrete.road.parking_lanes == {0, 1}
    message = r"a bus turns back on a circle of 14\.8 m .* 1 lane per direction .* 8\.0 m"
    with pytest.raises(MotionInfeasibleError, match=message):
        turns_back("bus", lanes=1)


@pytest.mark.parametrize("approach", ["ahead", "behind"])
def test_one_ahead_or_behind_turns_back_from_the_lane_of_the_ego(approach):
    concrete = turns_back("car", approach=approach)
    assert concrete.participant("ego").motion.entry_lane == 2
    assert concrete.participant("x").motion.entry_lane == 2
