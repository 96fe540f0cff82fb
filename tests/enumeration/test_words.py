"""What maneuvers, entries, approaches and relations allow."""

from __future__ import annotations

import pytest

from scegen.enumeration import count_scenarios, enumerate_scenarios
from scegen.errors import NoScenarioError
from scegen.scenario.vocabulary import ArmsMode, Maneuver

EGO = {"id": "ego", "role": "ego"}


def drives(functional, name, **options):
    found = enumerate_scenarios(functional, **options).scenarios
    return [scenario.assignment(name) for scenario in found]


def test_fixed_maneuver(describe):
    made = drives(describe("four_way", 4, [EGO | {"maneuvers": ["left"]}]), "ego")
    assert [(d.entry, d.move, d.exit, d.turn) for d in made] == [(0, 3, 3, Maneuver.LEFT)]


def test_alternatives(describe):
    made = drives(describe("four_way", 4, [EGO | {"maneuvers": ["left", "straight"]}]), "ego")
    assert {d.turn for d in made} == {Maneuver.LEFT, Maneuver.STRAIGHT}


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["lane_change"], {(1, "lane_change"), (2, "lane_change"), (3, "lane_change")}),
        (["straight", "overtake"], {(2, "straight")} | {(d, "overtake") for d in (1, 2, 3)}),
        (["u_turn"], {(0, "u_turn")}),
        (["stay"], {(2, "stay")}),
        ([], {(1, "right"), (2, "straight"), (3, "left")}),
    ],
)
def test_manners(describe, words, expected):
    made = drives(describe("four_way", 4, [EGO | {"maneuvers": words, "entries": [0]}]), "ego")
    assert {(d.move, d.maneuver.value) for d in made} == expected


@pytest.mark.parametrize(
    ("side", "word", "move"),
    [("right", "exit_1", 1), ("right", "exit_3", 3), ("left", "exit_1", 3), ("left", "exit_3", 1),
     ("right", "exit_4", 0), ("left", "exit_4", 0)],
)  # fmt: skip
def test_exits_count_in_driving_direction(describe, side, word, move):
    functional = describe("roundabout", 4, [EGO | {"maneuvers": [word]}], driving_side=side)
    assert [d.move for d in drives(functional, "ego")] == [move]


def test_an_exit_that_is_not_there(describe):
    with pytest.raises(NoScenarioError, match="ego does: exit_5"):
        enumerate_scenarios(describe("roundabout", 4, [EGO | {"maneuvers": ["exit_5"]}]))


@pytest.mark.parametrize(("kind", "arms"), [("straight", 2), ("four_way", 4)])
def test_exits_are_of_a_roundabout_alone(describe, kind, arms):
    with pytest.raises(NoScenarioError, match="ego does: exit_1"):
        enumerate_scenarios(describe(kind, arms, [EGO | {"maneuvers": ["exit_1"]}]))


def test_a_straight_road_has_one_way_on(describe):
    made = drives(describe("straight", 2, [EGO]), "ego")
    assert [(d.move, d.exit, d.turn) for d in made] == [(1, 1, Maneuver.STRAIGHT)]


@pytest.mark.parametrize(
    ("word", "arm"), [("opposite", 2), ("left", 3), ("right", 1)]
)  # the ego enters from the east, heading west: left of it is south
def test_approach(describe, word, arm):
    functional = describe(
        "four_way", 4, [EGO | {"entries": [0]}, {"id": "other", "approaches": [word]}]
    )
    assert {d.entry for d in drives(functional, "other")} == {arm}


def test_behind_and_ahead_are_ranks(describe):
    functional = describe(
        "four_way",
        4,
        [EGO, {"id": "tail", "approaches": ["behind"]}, {"id": "front", "approaches": ["ahead"]}],
    )
    for scenario in enumerate_scenarios(functional).scenarios:
        ranks = [scenario.assignment(n).rank for n in ("front", "ego", "tail")]
        assert ranks == [0, 1, 2]
        assert len({d.entry for d in scenario.drives}) == 1


def test_ahead_or_behind_are_two_scenarios(describe):
    functional = describe("straight", 2, [EGO, {"id": "other", "approaches": ["ahead", "behind"]}])
    assert sorted(d.rank for d in drives(functional, "other")) == [0, 1]


def test_adjacent_is_beside(describe):
    others = [{"id": "other", "approaches": ["adjacent"]}]
    made = drives(describe("four_way", 4, [EGO, *others]), "other")
    assert {d.beside for d in made} == {"ego"}
    assert {d.rank for d in made} == {0}
    two = describe("four_way", 4, [EGO, *others], lanes=[1, 2, 1, 1])
    assert {d.entry for d in drives(two, "other")} == {1}
    with pytest.raises(NoScenarioError, match="adjacent"):
        enumerate_scenarios(describe("four_way", 4, [EGO, *others], lanes=[1, 1, 1, 1]))


def test_several_beside_one_share_the_other_lane(describe):
    others = [{"id": name, "approaches": ["adjacent"]} for name in ("a", "b", "c")]
    for scenario in enumerate_scenarios(
        describe("straight", 2, [EGO, *others], lanes=[2, 2])
    ).scenarios:
        assert [d.beside for d in scenario.drives] == [None, "ego", "ego", "ego"]


def test_adjacent_with_a_side_is_one_place(describe):
    """The lane to the left, not another arm."""
    others = [{"id": "other", "approaches": ["adjacent", "left"]}]
    made = drives(describe("four_way", 4, [EGO, *others]), "other")
    assert {d.beside for d in made} == {"ego"}


def test_beside_whoever_is_listed_first(describe):
    """Two side by side share a rank, in whatever order the participants are listed."""
    left = {"id": "left_car", "approaches": ["adjacent"]}
    tail = {"id": "tail", "approaches": ["behind"]}
    for scenario in enumerate_scenarios(describe("straight", 2, [tail, left, EGO])).scenarios:
        assert [d.rank for d in scenario.drives] == [1, 0, 0]


def test_relations_to_others(describe):
    functional = describe(
        "four_way",
        4,
        [EGO, {"id": "truck", "kind": "truck", "approaches": ["opposite"]}, {"id": "car"}],
        relations=[{"participant": "car", "reference": "truck", "approaches": ["behind"]}],
    )
    for scenario in enumerate_scenarios(functional).scenarios:
        ego, truck, car = scenario.drives
        assert truck.entry == car.entry == (ego.entry + 2) % 4
        assert (truck.rank, car.rank) == (0, 1)


def test_what_is_not_said_of_entries_is_open(describe):
    """The truck may come from anywhere: from the ego's left, or on its own arm."""
    functional = describe("roundabout", 4, [EGO, {"id": "truck", "kind": "truck"}])
    listed = enumerate_scenarios(functional)
    assert {(t.entry - e.entry) % 4 for e, t in (s.drives for s in listed.scenarios)} == {
        0,
        1,
        2,
        3,
    }
    assert listed.certificate.total == (4 * 3) ** 2
    assert listed.certificate.count == 4 * 3**2
    assert listed.notes == ()


def test_two_from_the_left_share_the_only_arm_there_is(describe):
    functional = describe(
        "four_way", 4, [EGO, *({"id": n, "approaches": ["left"]} for n in ("a", "b"))]
    )
    listed = enumerate_scenarios(functional)
    assert all(s.drives[1].entry == s.drives[2].entry for s in listed.scenarios)
    assert listed.certificate.count == 3 * 6  # two alike among three moves: six multisets


def test_kind_and_speed_tell_vehicles_apart(describe):
    alike = [EGO | {"entries": [0]}, {"id": "a", "entries": [1]}, {"id": "b", "entries": [1]}]
    fast = {"speed_mps": {"low": 20, "high": 20}}
    assert count_scenarios(describe("four_way", 4, alike)).count == 3 * 6
    for change in ({"kind": "truck"}, fast, {"maneuvers": ["left", "right", "straight"]}):
        differ = describe("four_way", 4, [*alike[:2], alike[2] | change])
        assert count_scenarios(differ).count == 27, change


def test_the_ego_is_somebody_where_arms_are_as_built(describe):
    functional = describe("four_way", 4, [EGO, *({"id": f"car_{i}"} for i in range(3))])
    # Multisets of four among 12 ways, up to 4 rotations; 12/4 ways of the ego, multisets of three.
    assert count_scenarios(functional, arms=ArmsMode.EQUAL).count == (1365 + 21 + 3 + 3) // 4
    assert count_scenarios(functional, arms=ArmsMode.DISTINCT).count == 3 * 364


@pytest.mark.parametrize(
    ("kind", "arms", "junction", "rotations"),
    [
        ("four_way", 4, {}, 4),
        ("skewed", 4, {}, 2),
        ("t", 3, {}, 1),
        ("y", 3, {}, 3),
        ("straight", 2, {}, 2),
        ("roundabout", 5, {}, 5),
        ("roundabout", 5, {"control": "yield"}, 5),
        ("four_way", 4, {"control": "stop"}, 2),
        ("four_way", 4, {"control": "all_way_stop"}, 4),
        ("four_way", 4, {"lanes": [2, 1, 2, 1]}, 2),
        ("four_way", 4, {"lanes": [2, 1, 1, 1]}, 1),
        ("four_way", 4, {"crosswalks": [3]}, 1),
        ("four_way", 4, {"arm_angles_deg": [0, 80, 180, 270]}, 1),
    ],
)
def test_rotations_keep_the_road(describe, kind, arms, junction, rotations):
    functional = describe(kind, arms, [EGO | {"maneuvers": ["u_turn"]}], **junction)
    listed = enumerate_scenarios(functional)
    assert listed.certificate.total == arms
    assert [s.class_size for s in listed.scenarios] == [rotations] * (arms // rotations)
