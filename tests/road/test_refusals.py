"""What cannot be built is refused with the reason and its numbers."""

import pytest

from scegen.errors import RoadInfeasibleError
from scegen.road import build_network, plan_road
from scegen.scenario.junction import Junction
from scegen.scenario.road_parameters import Turn


def plan(kind="four_way", arms=4, angles=(), **more):
    return plan_road(Junction(kind=kind, arms=arms, arm_angles_deg=angles), **more)


def changed(wanted, arm, **fields):
    arms = list(wanted.arms)
    arms[arm] = arms[arm].model_copy(update=fields)
    return wanted.model_copy(update={"arms": tuple(arms)})


def turned(lane, entry, leaving):
    turn = Turn(entry=entry, lane_in=min(lane, 3), exit=leaving, lane_out=1)
    return plan().model_copy(update={"turns": (turn,)})


CASES = {
    "arms too close": (plan("skewed", 4, (0, 10, 180, 190)), r"arms 0 and 1 lie 10\.0 deg"),
    "radius too large for the angle": (
        plan("skewed").model_copy(update={"corner_radius_m": 60.0}),
        "kerb radius of 60 m",
    ),
    "radius too small to drive": (
        plan().model_copy(update={"corner_radius_m": 1.0}),
        r"2\.75 m, less than 3 m",
    ),
    "ring too small": (
        plan("roundabout", 6).model_copy(update={"ring_radius_m": 9.0}),
        "ring of 9 m radius is too small",
    ),
    "ring arms too close": (plan("roundabout", 3, (0, 6, 180)), r"6\.0 deg apart"),
    "arm too short": (plan(arm_length_m=10), "10 m is too short"),
    "turn of no arm": (turned(1, 7, 1), "there is no arm 7"),
    "turn of no lane": (turned(2, 0, 1), "no way from lane 2 of 1 on arm 0 to lane 1"),
    "turn back where none is allowed": (turned(1, 0, 0), "back to arm 0, where u_turns allows"),
    "lanes end": (
        changed(plan("straight", 2), 0, lanes_in=2),
        "2 lanes in from arm 0 do not continue in 1",
    ),
    "widths differ": (changed(plan("straight", 2), 1, lane_width_m=3.0), "3.5 m wide on arm 0"),
    "bend without room": (
        plan("straight", 2, (0, 90), arm_length_m=30),
        "arm 0 is 30 m long, but its half of the bend needs",
    ),
    "angles contradict": (
        changed(plan(), 2, angle_to_previous_deg=80.0),
        "says 80, but the angles lie 90 deg apart",
    ),
    "angles do not rise": (changed(plan(), 1, angle_deg=200.0), "must rise"),
    "ids out of order": (changed(plan(), 1, id=2), "0 to 3 in order"),
    "too few arms": (
        plan().model_copy(update={"arms": plan().arms[:3]}),
        "four_way has 4 arms, not 3",
    ),
    "unknown arm": (plan(parking_lanes={5}), "there is no arm 5"),
}


@pytest.mark.parametrize("case", CASES)
def test_refused_with_the_reason(case):
    wanted, reason = CASES[case]
    with pytest.raises(RoadInfeasibleError, match=reason):
        build_network(wanted)
