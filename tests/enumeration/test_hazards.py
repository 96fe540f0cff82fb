"""What hazards imply for entries and moves."""

from __future__ import annotations

import pytest

from scegen.enumeration import enumerate_scenarios
from scegen.errors import NoScenarioError
from scegen.scenario.logical import ConflictKind
from scegen.scenario.vocabulary import DrivingSide, Maneuver, Reduction

EGO = {"id": "ego", "role": "ego"}
CAR = {"id": "car"}


def hazard(kind, by="car", to="ego"):
    return {"kind": kind, "by": [by] if by else [], "to": [to] if to else []}


def listed(functional):
    found = enumerate_scenarios(functional, reduction=Reduction.NONE).scenarios
    assert found
    return [(s, s.assignment("car"), s.assignment("ego")) for s in found]


def met(scenario):
    return scenario.conflicts[0].kind if scenario.conflicts else ConflictKind.NONE


@pytest.mark.parametrize("kind", ["tailgating", "overtaking", "delayed_braking"])
def test_behind(describe, kind):
    for _, car, ego in listed(describe("four_way", 4, [EGO, CAR], [hazard(kind)])):
        assert (car.entry, car.rank, ego.rank) == (ego.entry, 1, 0)


@pytest.mark.parametrize("kind", ["hard_braking", "stopping", "slow_driving"])
def test_ahead(describe, kind):
    for _, car, ego in listed(describe("four_way", 4, [EGO, CAR], [hazard(kind)])):
        assert (car.entry, car.rank, ego.rank) == (ego.entry, 0, 1)


def test_braking_of_one_from_the_side_needs_a_conflict(describe):
    functional = describe(
        "four_way", 4, [EGO, CAR | {"approaches": ["left"]}], [hazard("hard_braking")]
    )
    assert all(met(s) is not ConflictKind.NONE for s, _, _ in listed(functional))


@pytest.mark.parametrize(
    ("car", "relations"),
    [
        ({"entries": [1, 2]}, []),  # the ego's arm is not among them
        ({}, [{"participant": "car", "reference": "ego", "approaches": ["right"]}]),
        ({}, [{"participant": "ego", "reference": "car", "approaches": ["right"]}]),
    ],
)
def test_words_that_keep_them_apart(describe, car, relations):
    functional = describe(
        "four_way", 4, [EGO | {"entries": [0]}, CAR | car], [hazard("stopping")], relations
    )
    for scenario, car_drive, ego in listed(functional):
        assert car_drive.entry != ego.entry
        assert met(scenario) is not ConflictKind.NONE


def test_beside_is_not_behind(describe):
    functional = describe(
        "four_way", 4, [EGO, CAR | {"approaches": ["adjacent"]}], [hazard("tailgating")]
    )
    with pytest.raises(NoScenarioError, match=r"adjacent.*tailgating"):
        enumerate_scenarios(functional)


def test_a_tailgater_who_brakes_stays_behind(describe):
    both = [hazard("tailgating"), hazard("hard_braking")]
    for _, car, ego in listed(describe("four_way", 4, [EGO, CAR], both)):
        assert (car.rank, ego.rank) == (1, 0)


def test_cut_in_comes_from_the_next_lane(describe):
    for _, car, ego in listed(describe("four_way", 4, [EGO, CAR], [hazard("cut_in")])):
        assert car.entry == ego.entry
        assert car.beside == "ego"


def test_cut_in_by_the_one_behind_keeps_the_order(describe):
    """The van is between the two, so the car cannot be beside the ego at first."""
    functional = describe(
        "straight",
        2,
        [CAR, EGO, {"id": "van", "kind": "van", "approaches": ["behind"]}],
        [hazard("cut_in")],
        [{"participant": "car", "reference": "van", "approaches": ["behind"]}],
    )
    for scenario, car, ego in listed(functional):
        assert [ego.rank, scenario.assignment("van").rank, car.rank] == [0, 1, 2]
        assert car.beside is None


def test_cut_in_from_another_arm_takes_the_same_exit(describe):
    functional = describe(
        "four_way", 4, [EGO, CAR | {"approaches": ["left", "opposite"]}], [hazard("cut_in")]
    )
    for _, car, ego in listed(functional):
        assert car.entry != ego.entry
        assert car.exit == ego.exit


@pytest.mark.parametrize("kind", ["cut_in", "sudden_acceleration"])
def test_on_a_ring_they_share_a_stretch(describe, kind):
    functional = describe("roundabout", 4, [EGO, CAR], [hazard(kind)])
    ways = {(car.entry, car.exit, ego.entry, ego.exit) for _, car, ego in listed(functional)}
    assert (0, 1, 2, 3) not in ways
    assert (0, 3, 2, 3) in ways
    assert (0, 3, 1, 2) in ways


def test_merging(describe):
    for scenario, car, ego in listed(describe("t", 3, [EGO, CAR], [hazard("merging_conflict")])):
        assert car.entry != ego.entry
        assert car.exit == ego.exit
        assert met(scenario) is ConflictKind.MERGING


def test_merging_of_two_is_between_them(describe):
    functional = describe(
        "four_way",
        4,
        [EGO, CAR, {"id": "van", "kind": "van"}],
        [{"kind": "merging_conflict", "by": ["car", "van"]}],
    )
    for scenario, car, _ in listed(functional):
        assert car.exit == scenario.assignment("van").exit


@pytest.mark.parametrize("kind", ["failure_to_yield", "red_light_running"])
def test_paths_clash(describe, kind):
    kinds = {met(s) for s, _, _ in listed(describe("four_way", 4, [EGO, CAR], [hazard(kind)]))}
    assert kinds == {ConflictKind.CROSSING, ConflictKind.MERGING}


def test_unprotected_left_turn(describe):
    functional = describe("four_way", 4, [EGO, CAR], [hazard("unprotected_left_turn")])
    for scenario, car, ego in listed(functional):
        assert car.turn is Maneuver.LEFT
        assert (car.entry - ego.entry) % 4 == 2
        assert met(scenario) in {ConflictKind.CROSSING, ConflictKind.MERGING}


def test_an_unsaid_other_is_the_only_other(describe):
    named = describe("four_way", 4, [EGO, CAR], [hazard("unprotected_left_turn")])
    unnamed = describe("four_way", 4, [EGO, CAR], [hazard("unprotected_left_turn", to=None)])
    assert [s for s, _, _ in listed(named)] == [s for s, _, _ in listed(unnamed)]


def test_with_three_an_unsaid_other_is_the_ego(describe):
    functional = describe(
        "four_way",
        4,
        [EGO, CAR, {"id": "van", "kind": "van"}],
        [hazard("unprotected_left_turn", to=None)],
    )
    found = listed(functional)
    assert {car.turn for _, car, _ in found} == {Maneuver.LEFT}
    assert {(car.entry - ego.entry) % 4 for _, car, ego in found} == {2}
    assert {s.hazards[0].to for s, _, _ in found} == {("ego",)}


def test_oncoming(describe):
    for _, car, ego in listed(describe("straight", 2, [EGO, CAR], [hazard("oncoming_lane")])):
        assert car.entry != ego.entry


def test_oncoming_at_a_crossing(describe):
    """From the opposite arm, or one comes in where the other goes out."""
    for _, car, ego in listed(describe("four_way", 4, [EGO, CAR], [hazard("oncoming_lane")])):
        opposite = (car.entry - ego.entry) % 4 == 2
        assert opposite or car.exit == ego.entry or ego.exit == car.entry


@pytest.mark.parametrize("kind", ["speeding", "swerving", "loss_of_control"])
def test_alone_it_implies_nothing(describe, kind):
    with_it = describe("four_way", 4, [EGO, CAR], [hazard(kind, to=None)])
    without = describe("four_way", 4, [EGO, CAR])
    assert [s.assignments for s, _, _ in listed(with_it)] == [
        s.assignments for s, _, _ in listed(without)
    ]


def test_a_clash_names_the_hazard_and_what_it_clashes_with(describe):
    functional = describe(
        "four_way",
        4,
        [
            EGO | {"maneuvers": ["right"]},
            CAR | {"approaches": ["left"]},
            {"id": "bus", "kind": "bus"},
        ],
        [hazard("tailgating"), {"kind": "speeding", "by": ["bus"]}],
    )
    with pytest.raises(NoScenarioError) as caught:
        enumerate_scenarios(functional)
    assert "tailgating" in caught.value.message
    assert "car comes from left" in caught.value.message
    assert "speeding" not in caught.value.message
    assert "right" not in caught.value.message


@pytest.mark.parametrize("kind", ["merging_conflict", "failure_to_yield"])
def test_on_a_road_without_a_junction_one_merges_from_beside(describe, kind):
    found = listed(describe("straight", 2, [EGO, CAR], [hazard(kind)]))
    assert found
    for _, car, ego in found:
        assert car.entry == ego.entry
        assert car.beside == "ego"


def test_who_comes_the_other_way_cannot_merge(describe):
    car = CAR | {"approaches": ["opposite"]}
    with pytest.raises(NoScenarioError, match="merging_conflict"):
        enumerate_scenarios(describe("straight", 2, [EGO, car], [hazard("merging_conflict")]))


def test_who_brakes_beside_the_ego_stays_beside_it(describe):
    car = CAR | {"approaches": ["adjacent"]}
    found = listed(describe("straight", 2, [EGO, car], [hazard("hard_braking")]))
    assert found
    assert all(drive.beside == "ego" for _, drive, _ in found)


def test_across_one_beside(describe):
    """Beside each other, one turns across the other: that is how it fails to yield."""
    car = CAR | {"approaches": ["adjacent"], "maneuvers": ["left", "straight"]}
    functional = describe("four_way", 4, [EGO, car], [hazard("failure_to_yield")])
    for _, one, ego in listed(functional):
        assert one.entry == ego.entry
        assert {one.turn, ego.turn} != {Maneuver.STRAIGHT}


def test_both_turn_left_if_both_are_said_to(describe):
    turning = {"approaches": ["opposite"], "maneuvers": ["left"]}
    functional = describe(
        "four_way",
        4,
        [EGO | {"maneuvers": ["left"]}, CAR | turning],
        [hazard("unprotected_left_turn", "ego", "car")],
    )
    for _, car, ego in listed(functional):
        assert (car.entry - ego.entry) % 4 == 2
    free = describe("four_way", 4, [EGO, CAR | turning], [hazard("failure_to_yield", "ego", "car")])
    for _, _, ego in listed(free):
        assert ego.turn is not Maneuver.LEFT


@pytest.mark.parametrize("kind", ["failure_to_yield", "delayed_braking", "hard_braking"])
def test_from_the_other_end_where_somebody_strays(describe, kind):
    car = CAR | {"approaches": ["opposite"]}
    around = EGO | {"maneuvers": ["overtake"]}
    van = {"id": "van", "parked": True, "approaches": ["ahead"], "maneuvers": ["stay"]}
    for people, more in (([around, car], []), ([EGO, car, van], [hazard("obstacle", "van")])):
        functional = describe("straight", 2, people, [hazard(kind), *more])
        for _, one, ego in listed(functional):
            assert one.entry != ego.entry
    with pytest.raises(NoScenarioError):
        enumerate_scenarios(describe("straight", 2, [EGO, car], [hazard(kind)]))


@pytest.mark.parametrize("place", ["opposite", "ahead"])
def test_one_who_turns_back_cuts_off_those_who_come(describe, place):
    car = CAR | {"approaches": [place], "maneuvers": ["u_turn"]}
    functional = describe("straight", 2, [EGO, car], [hazard("failure_to_yield")])
    for _, one, ego in listed(functional):
        assert one.turn is Maneuver.U_TURN
        assert (one.entry == ego.entry) == (place == "ahead")


def manners(describe, kind, arms, car=None, extra=()):
    functional = describe(kind, arms, [EGO, CAR | (car or {})], [hazard("reversing"), *extra])
    return {
        (drive.reverses.value, drive.entry == ego.entry) for _, drive, ego in listed(functional)
    }


def test_who_reverses_on_a_plain_road_is_ahead_or_beside_it(describe):
    ways = {("backs_up", True), ("from_right", True), ("from_left", True)}
    assert manners(describe, "straight", 2) == ways
    assert manners(describe, "straight", 2, {"approaches": ["ahead"]}) == {("backs_up", True)}
    left = {"approaches": ["left"]}
    assert manners(describe, "straight", 2, left) == {("from_left", True)}
    stops = [hazard("stopping")]
    assert manners(describe, "straight", 2, left, stops) == {("backs_up", True)}
    for _, car, ego in listed(describe("straight", 2, [EGO, CAR], [hazard("reversing")])):
        assert (car.rank, ego.rank) == (0, 1)


def test_who_reverses_at_a_junction_is_ahead_or_comes_from_an_arm(describe):
    ways = {("backs_up", True), ("backs_up", False), ("out_of_arm", False)}
    assert manners(describe, "t", 3) == ways
    apart = {("backs_up", False), ("out_of_arm", False)}
    assert manners(describe, "four_way", 4, {"approaches": ["left"]}) == apart
    ring = {("backs_up", True), ("backs_up", False)}
    assert manners(describe, "roundabout", 4) == ring


@pytest.mark.parametrize(
    ("approach", "side", "same"),
    [
        ("left", "right", False),
        ("right", "right", True),
        ("left", "left", True),
    ],
)
def test_who_comes_past_behind_one_that_stands_square_to_a_plain_road(
    describe, approach, side, same
):
    """It faces away from the road, beside the lane by which it would come in."""
    car = CAR | {"approaches": [approach]}
    danger = hazard("reversing", by="ego", to="car")
    functional = describe("straight", 2, [EGO, car], [danger])
    junction = functional.junction.model_copy(update={"driving_side": DrivingSide(side)})
    functional = functional.model_copy(update={"junction": junction})
    for _, past, ego in listed(functional):
        assert ego.reverses == "square"
        assert (past.entry == ego.entry) == same


def test_who_stops_first_does_not_come_out_backwards(describe):
    found = manners(describe, "t", 3, extra=[hazard("stopping")])
    assert {how for how, _ in found} == {"backs_up"}


def test_ways_of_one_that_reverses_into_another_cross_or_merge(describe):
    for scenario, car, ego in listed(describe("four_way", 4, [EGO, CAR], [hazard("reversing")])):
        if car.reverses.value == "backs_up" and car.entry != ego.entry:
            assert met(scenario) in {ConflictKind.CROSSING, ConflictKind.MERGING}
        if car.reverses.value == "out_of_arm":
            assert car.exit != ego.entry


def test_nobody_else_reverses(describe):
    for _, _, ego in listed(describe("t", 3, [EGO, CAR], [hazard("reversing")])):
        assert ego.reverses is None


def test_one_behind_cannot_reverse_towards_the_ego(describe):
    car = CAR | {"approaches": ["behind"]}
    with pytest.raises(NoScenarioError, match="reversing"):
        enumerate_scenarios(describe("straight", 2, [EGO, car], [hazard("reversing")]))


@pytest.mark.parametrize(("kind", "arms"), [("straight", 2), ("four_way", 4), ("roundabout", 4)])
def test_as_many_are_counted_as_listed_where_somebody_reverses(describe, kind, arms):
    bystanders = [{"id": "one"}, {"id": "two"}]
    functional = describe(kind, arms, [EGO, CAR, *bystanders], [hazard("reversing")])
    every = enumerate_scenarios(functional, reduction=Reduction.NONE)
    assert len(every.scenarios) == every.certificate.total
    found = enumerate_scenarios(functional)
    assert sum(s.class_size for s in found.scenarios) == found.certificate.total


def test_where_knows_how_one_reverses(describe):
    functional = describe("t", 3, [EGO, CAR], [hazard("reversing")])
    for how in ("backs_up", "out_of_arm"):
        found = enumerate_scenarios(functional, where=f"car.reverses == {how}").scenarios
        assert {s.assignment("car").reverses.value for s in found} == {how}
    assert not enumerate_scenarios(functional, where="ego.reverses == backs_up").scenarios


@pytest.mark.parametrize("control", ["yield", "stop", "priority_to_right"])
@pytest.mark.parametrize("kind", ["t", "y", "four_way", "roundabout"])
def test_who_fails_to_yield_is_never_the_one_with_right_of_way(describe, control, kind):
    arms = 3 if kind in {"t", "y"} else 4
    people = [{"id": "ego", "kind": "car", "role": "ego"}, {"id": "car", "kind": "car"}]
    danger = {"kind": "failure_to_yield", "by": ["car"], "to": ["ego"]}
    found = enumerate_scenarios(describe(kind, arms, people, [danger], control=control))
    yields = {c.yields for s in found.scenarios for c in s.conflicts}
    assert "car" in yields
    assert "ego" not in yields
    functional = describe(kind, arms, people, [danger], control=control)
    every = enumerate_scenarios(functional, reduction=Reduction.NONE)
    assert sum(s.class_size for s in found.scenarios) == len(every.scenarios)


def test_where_only_the_one_with_right_of_way_fits_it_is_left_open(describe):
    ego = {"id": "ego", "kind": "car", "role": "ego", "maneuvers": ["straight"]}
    car = {"id": "car", "kind": "car", "approaches": ["right"], "maneuvers": ["straight"]}
    danger = {"kind": "failure_to_yield", "by": ["car"], "to": ["ego"]}
    found = enumerate_scenarios(
        describe("four_way", 4, [ego, car], [danger], control="priority_to_right")
    )
    assert found.scenarios
    assert any(note.startswith("failure_to_yield") for note in found.notes)


@pytest.mark.parametrize("side", ["left", "right"])
def test_who_fails_to_yield_at_a_roundabout_comes_in_before_one_that_is_on_it(describe, side):
    people = [{"id": "ego", "kind": "car", "role": "ego"}, {"id": "car", "kind": "car"}]
    danger = {"kind": "failure_to_yield", "by": ["car"], "to": ["ego"]}
    found = enumerate_scenarios(describe("roundabout", 4, people, [danger], driving_side=side))
    yields = {c.yields for s in found.scenarios for c in s.conflicts}
    assert "car" in yields
    assert "ego" not in yields


@pytest.mark.parametrize(("side", "turn"), [("right", "left"), ("left", "right")])
def test_a_turn_across_the_oncoming_goes_where_the_traffic_does_not_keep(describe, side, turn):
    people = [{"id": "ego", "role": "ego", "maneuvers": [turn]}, {"id": "car"}]
    danger = {"kind": "unprotected_left_turn", "by": ["ego"], "to": ["car"]}
    found = enumerate_scenarios(describe("four_way", 4, people, [danger], driving_side=side))
    assert {(s.assignment("ego").turn, s.assignment("car").entry) for s in found.scenarios} == {
        (turn, 2)
    }


@pytest.mark.parametrize("kind", ["collision", "avoided"])
def test_one_beside_the_lanes_and_a_thing_may_be_who_it_ends_with(describe, kind):
    parked = {"id": "van", "parked": True, "maneuvers": ["stay"]}
    thing = {"id": "crate", "kind": "box", "in_way_of": "ego"}
    for other in ("van", "crate"):
        more = {"outcome": {"kind": kind, "between": ["ego", other]}, "objects": [thing]}
        ego = {"id": "ego", "role": "ego"}
        assert enumerate_scenarios(describe("straight", 2, [ego, parked], more=more)).scenarios


@pytest.mark.parametrize(("approach", "entry"), [("left", 0), ("right", 1)])
def test_who_comes_out_backwards_faces_away_from_the_road(describe, approach, entry):
    """At a T, from the arm that ends there: its left is on the other side."""
    ego = {"id": "ego", "role": "ego", "entries": [2]}
    car = {"id": "car", "maneuvers": ["straight"], "approaches": [approach]}
    danger = {"kind": "reversing", "by": ["ego"], "to": ["car"]}
    found = enumerate_scenarios(describe("t", 3, [ego, car], [danger])).scenarios
    out = [s for s in found if s.assignment("ego").reverses == "square"]
    assert out
    assert {s.assignment("car").entry for s in out} == {entry}
