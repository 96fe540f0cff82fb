from itertools import combinations, product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scegen.road.lane_choice import lane_ways
from scegen.scenario.road_parameters import ArmRoad
from scegen.scenario.vocabulary import DrivingSide

CROSS = (0.0, 90.0, 180.0, 270.0)
TEE = (0.0, 180.0, 270.0)


def arms(angles, lanes):
    return tuple(
        ArmRoad(
            id=i,
            length_m=50,
            angle_deg=angle,
            angle_to_previous_deg=(angle - angles[i - 1]) % 360,
            lanes_in=lanes[i][0],
            lanes_out=lanes[i][1],
            speed_limit_mps=10,
        )
        for i, angle in enumerate(angles)
    )


def ways_from(entry, angles, lanes, side=DrivingSide.RIGHT):
    return {
        (way.lane_in, way.exit, way.lane_out)
        for way in lane_ways(arms(angles, lanes), side)
        if way.entry == entry
    }


def test_two_lanes_at_a_crossing_keep_right():
    # From arm 0 (east): arm 1 is the right turn, 2 straight on, 3 the left turn.
    assert ways_from(0, CROSS, [(2, 2)] * 4) == {(2, 1, 2), (1, 2, 1), (2, 2, 2), (1, 3, 1)}


def test_two_lanes_at_a_crossing_keep_left():
    found = ways_from(0, CROSS, [(2, 2)] * 4, DrivingSide.LEFT)
    assert found == {(2, 3, 2), (1, 2, 1), (2, 2, 2), (1, 1, 1)}


def test_three_lanes_turn_from_the_outer_ones_only():
    found = ways_from(0, CROSS, [(3, 3)] * 4)
    assert {way for way in found if way[1] != 2} == {(3, 1, 3), (1, 3, 1)}
    assert {way for way in found if way[1] == 2} == {(1, 2, 1), (2, 2, 2), (3, 2, 3)}


def test_surplus_lanes_only_turn():
    lanes = [(3, 1), (1, 1), (1, 1), (1, 1)]
    assert ways_from(0, CROSS, lanes) == {(3, 1, 1), (2, 2, 1), (1, 3, 1)}


def test_stem_of_a_tee_splits_its_lanes():
    assert ways_from(2, TEE, [(2, 2)] * 3) == {(2, 0, 2), (1, 1, 1)}


def test_a_wide_exit_is_fanned_into():
    lanes = [(1, 1), (1, 1), (1, 3), (1, 1)]
    reached = {w.lane_out for w in lane_ways(arms(CROSS, lanes), DrivingSide.RIGHT) if w.exit == 2}
    assert reached == {1, 2, 3}
    # Straight on from arm 0 takes the lane that no turn reaches.
    assert ways_from(0, CROSS, lanes) >= {(1, 2, 1), (1, 2, 2)}


@pytest.mark.parametrize("side", list(DrivingSide))
@settings(max_examples=200, derandomize=True)
@given(data=st.data())
def test_complete_and_never_crossing(side, data):
    count = data.draw(st.integers(3, 8))
    weights = data.draw(st.lists(st.integers(1, 5), min_size=count, max_size=count))
    angles = [360 * sum(weights[:i]) / sum(weights) for i in range(count)]
    lane = st.integers(1, 3)
    lanes = [(data.draw(lane), data.draw(lane)) for _ in range(count)]
    ways = lane_ways(arms(angles, lanes), side)
    assert len(set(ways)) == len(ways)
    assert {(w.entry, w.exit) for w in ways} == {
        (e, x) for e, x in product(range(count), repeat=2) if e != x
    }
    assert {(w.entry, w.lane_in) for w in ways} == {
        (arm, k) for arm in range(count) for k in range(1, lanes[arm][0] + 1)
    }
    assert {(w.exit, w.lane_out) for w in ways} == {
        (arm, k) for arm in range(count) for k in range(1, lanes[arm][1] + 1)
    }
    sign = 1 if side is DrivingSide.RIGHT else -1
    for a, b in combinations(ways, 2):
        if a.entry != b.entry or a.lane_in == b.lane_in:
            continue
        outer, inner = (a, b) if a.lane_in > b.lane_in else (b, a)
        target = [(sign * (w.exit - w.entry) % count, -w.lane_out) for w in (outer, inner)]
        assert target[0] <= target[1]
