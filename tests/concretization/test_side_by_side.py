"""Lanes of those beside each other, and who comes into whose."""

from itertools import pairwise

import pytest
from shapely import LineString
from told import first, told, who

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.errors import MotionInfeasibleError
from scegen.motion import build_paths
from scegen.road import build_network
from scegen.scenario.vocabulary import HazardKind

EGO = who("ego", maneuvers=["straight"])


def motion(concrete, name):
    return concrete.participant(name).motion


def lines(concrete):
    paths = build_paths(concrete, build_network(concrete.road))
    return {
        name: LineString(list(zip(path.x_m, path.y_m, strict=True))) for name, path in paths.items()
    }


@pytest.mark.parametrize("side", ["right", "left"])
@pytest.mark.parametrize(("word", "outward"), [("right", True), ("left", False)])
def test_the_side_said_is_the_side_taken(side, word, outward):
    outward = outward == (side == "right")
    other = who("x", "car", ["adjacent", word])
    concrete = first(told("straight", [EGO, other], [("swerving", "x", "ego")], side=side))
    ego, x = motion(concrete, "ego"), motion(concrete, "x")
    assert x.entry_lane - ego.entry_lane == (1 if outward else -1)
    out, back = x.lane_changes
    assert (out.lane_after, back.lane_after) == (ego.entry_lane, x.entry_lane)
    assert {out.hazard, back.hazard} == {HazardKind.SWERVING}


def test_with_one_on_either_side_the_ego_is_in_the_middle():
    people = [who("ego"), who("a", "truck", ["adjacent"]), who("b", "car", ["adjacent"])]
    functional = told("straight", people, lanes=3)
    concrete = next(
        concretize(functional, logical)
        for logical in enumerate_scenarios(functional).scenarios
        if logical.assignment("a").beside_on != logical.assignment("b").beside_on
    )
    assert motion(concrete, "ego").entry_lane == 2
    assert {motion(concrete, n).entry_lane for n in ("a", "b")} == {1, 3}


def test_the_sides_of_two_are_kept():
    people = [
        who("ego"),
        who("a", "truck", ["adjacent", "left"]),
        who("b", "car", ["adjacent", "right"]),
    ]
    concrete = first(told("straight", people, lanes=3))
    assert [motion(concrete, n).entry_lane for n in ("a", "ego", "b")] == [1, 2, 3]


@pytest.mark.parametrize(("kind", "arms"), [("four_way", 4), ("t", 3), ("skewed", 4)])
def test_turning_across_a_rider_beside(kind, arms):
    rider = who("x", "bicycle", ["adjacent"], ["straight"])
    concrete = first(told(kind, [who("ego", maneuvers=["right"]), rider]))
    assert motion(concrete, "x").entry_lane == motion(concrete, "ego").entry_lane + 1
    made = lines(concrete)
    assert made["ego"].crosses(made["x"])
    (turn,) = concrete.road.turns
    assert (turn.entry, turn.lane_in) == (motion(concrete, "ego").entry, 1)


def test_without_a_danger_between_them_markings_are_kept():
    people = [
        who("ego", maneuvers=["left"]),
        who("x", "car", ["adjacent"], ["straight"]),
        who("y", "car", ["opposite"], ["straight"]),
    ]
    concrete = first(told("four_way", people, [("unprotected_left_turn", "ego", "y")]))
    assert concrete.road.turns == ()
    assert (motion(concrete, "ego").entry_lane, motion(concrete, "x").entry_lane) == (1, 2)


def test_both_turn_left_behind_each_other():
    people = [who("ego", maneuvers=["left"]), who("x", "car", ["opposite"], ["left"])]
    concrete = first(told("four_way", people))
    assert {turn.radius_m for turn in concrete.road.turns} == {6.5}
    made = lines(concrete)
    assert made["ego"].distance(made["x"]) < 2.16
    others = told("four_way", [*people, who("y", "car", ["left"])])
    assert first(others).road.turns == ()


def test_behind_in_the_next_lane_is_in_the_next_lane():
    people = [who("ego"), who("x", "car", ["adjacent", "behind"], ["straight"])]
    functional = told("straight", people, [("speeding", "x", "ego")], lanes=2)
    concrete = first(functional)
    assert abs(motion(concrete, "x").entry_lane - motion(concrete, "ego").entry_lane) == 1


def test_nobody_comes_in_from_a_lane_that_is_not_there():
    people = [EGO, who("x", "car", (), ["straight"])]
    functional = told("straight", people, [("merging_conflict", "x", "ego")], lanes=1)
    with pytest.raises(MotionInfeasibleError, match=r"1 lane.*x changes into the lane of ego"):
        first(functional)


def test_several_in_the_one_lane_beside_drive_in_a_line():
    people = [who("ego", maneuvers=["lane_change"])]
    people += [who(name, "car", ["adjacent"], ["straight"]) for name in "abc"]
    concrete = first(told("straight", people, lanes=2))
    lane = motion(concrete, "ego").entry_lane
    assert {motion(concrete, name).entry_lane for name in "abc"} == {3 - lane}
    starts = sorted(motion(concrete, name).start_m for name in "abc")
    assert all(after - before > 4.79 for before, after in pairwise(starts))
