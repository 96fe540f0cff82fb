from __future__ import annotations

import itertools

import pytest

from scegen.enumeration.right_of_way import road_rules
from scegen.scenario.junction import Junction
from scegen.scenario.logical import ConflictKind


@pytest.mark.parametrize("side", ["right", "left"])
@pytest.mark.parametrize(
    ("kind", "arms"),
    [("straight", 2), ("t", 3), ("four_way", 4), ("multi_way", 5), ("multi_way", 8),
     ("roundabout", 3), ("roundabout", 4), ("roundabout", 6)],
)  # fmt: skip
def test_every_pair_of_ways_as_drawn(oracle, kind, arms, side):
    junction = Junction(kind=kind, arms=arms, driving_side=side)
    table = road_rules(junction).kinds
    for e, x, f, y in itertools.product(range(arms), repeat=4):
        expected = oracle.ways_meet(junction, (e, x), (f, y))
        assert table.get((e, x, f, y), ConflictKind.NONE) == expected, (e, x, f, y)


@pytest.mark.parametrize(
    ("side", "first", "second", "kind"),
    [
        ("right", (0, 2), (2, 0), "none"),  # oncoming, both straight
        ("right", (0, 3), (2, 0), "crossing"),  # unprotected left turn
        ("right", (0, 3), (2, 1), "none"),  # two left turns pass before each other
        ("right", (0, 1), (2, 1), "merging"),  # right turn and oncoming left turn
        ("right", (0, 2), (1, 3), "crossing"),
        ("right", (0, 1), (1, 3), "none"),  # right turns stay clear of the road they leave
        ("right", (0, 2), (0, 1), "diverging"),
        ("right", (0, 0), (2, 0), "merging"),  # a U-turn meets who comes straight towards it
        ("left", (0, 1), (2, 0), "crossing"),  # in left-hand traffic the right turn crosses
        ("left", (0, 3), (2, 0), "none"),
    ],
)
def test_four_way_by_hand(side, first, second, kind):
    table = road_rules(Junction(kind="four_way", arms=4, driving_side=side)).kinds
    assert table.get((*first, *second), ConflictKind.NONE) == kind
    assert table.get((*second, *first), ConflictKind.NONE) == kind


def test_round_a_ring():
    right = road_rules(Junction(kind="roundabout", arms=4)).kinds
    left = road_rules(Junction(kind="roundabout", arms=4, driving_side="left")).kinds
    assert right[0, 3, 2, 3] == "merging"  # passes arm 2 on its way to arm 3
    assert (0, 1, 2, 3) not in right  # opposite quarters of the ring
    assert (0, 3, 2, 3) in left  # same exit always meets
    assert (0, 3, 2, 1) not in left
    assert right[0, 0, 2, 3] == "merging"  # all the way round meets everybody
