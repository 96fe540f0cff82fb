"""Right of way in listed scenarios: phases, those on foot, queues, deadlocks."""

from __future__ import annotations

import pytest
from clorm import ConstantStr, Predicate
from hypothesis import given, settings
from hypothesis import strategies as st

from scegen.enumeration import enumerate_scenarios, plain_crossing
from scegen.enumeration.conflicts import deadlock_among
from scegen.enumeration.programs import Part, consequences
from scegen.enumeration.right_of_way import road_rules
from scegen.enumeration.wide_curves import curves_that_meet
from scegen.scenario.control import signal_phases
from scegen.scenario.junction import ARM_COUNTS, Junction
from scegen.scenario.logical import Conflict, ConflictKind
from scegen.scenario.vocabulary import Control, DrivingSide, JunctionKind, Reduction

EAST, NORTH, WEST, SOUTH = range(4)
EGO = {"id": "ego", "role": "ego", "entries": [0], "maneuvers": ["straight"]}


# --- phases -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "arms", "phases"),
    [
        ("four_way", 4, (0, 1, 0, 1)),
        ("t", 3, (0, 0, 1)),
        ("y", 3, (0, 1, 2)),  # no two face each other
        ("skewed", 4, (0, 1, 0, 1)),
        ("multi_way", 6, (0, 1, 2, 0, 1, 2)),
        ("straight", 2, (0, 0)),
    ],
)
def test_arms_that_face_each_other_have_green_together(kind, arms, phases):
    assert signal_phases(Junction(kind=kind, arms=arms, control="signals")) == phases


# --- those who cross an arm ---------------------------------------------------------------------

#             the driver comes from the south; on foot: across the south arm, across the exit arm
#                                    turns right     straight on     turns left
ON_FOOT = {
    ("four_way", "uncontrolled"): ("drv drv",      "drv drv",      "drv drv"),  # VC 21.2b
    ("four_way", "stop"):         ("drv drv",      "drv drv",      "drv drv"),
    ("four_way", "signals"):      ("light drv",    "light light",  "light drv"),  # VC 21.2a
    ("roundabout", "yield"):      ("drv drv",      "drv drv",      "drv drv"),
    ("roundabout", "signals"):    ("light drv",    "light drv",    "light drv"),
}  # fmt: skip


def who_waits(rules, way, arm):
    told = {
        "drv": rules.lets_cross.get((*way, arm)),
        "foot": rules.waits_to_cross.get((*way, arm)),
        "light": rules.open_to_cross.get((*way, arm)),
    }
    (who,) = [name for name, rule in told.items() if rule is not None]
    return who


@pytest.mark.parametrize("side", ["right", "left"])
@pytest.mark.parametrize(("kind", "control"), ON_FOOT)
def test_those_on_a_crosswalk(kind, control, side):
    rules = road_rules(Junction(kind=kind, arms=4, control=control, driving_side=side))
    ways = [(SOUTH, EAST), (SOUTH, NORTH), (SOUTH, WEST)]
    found = tuple(f"{who_waits(rules, w, w[0])} {who_waits(rules, w, w[1])}" for w in ways)
    assert found == ON_FOOT[kind, control]


@pytest.mark.parametrize(("crosswalks", "who"), [([], "foot"), ([1], "drv")])
def test_on_an_open_road_only_a_crosswalk_gives_priority(crosswalks, who):
    """VC 20.6: elsewhere one may not step out in the way of vehicles."""
    rules = road_rules(Junction(kind="straight", arms=2, crosswalks=crosswalks))
    assert who_waits(rules, (0, 1), 1) == who


# --- in a listed scenario -----------------------------------------------------------------------


def told(functional):
    """(first, second, yields, rule) of the conflicts of the one scenario."""
    (scenario,) = enumerate_scenarios(functional).scenarios
    return [(c.first, c.second, c.yields, c.rule and c.rule.value) for c in scenario.conflicts]


def test_the_one_from_the_right_goes_first(describe):
    car = {"id": "car", "approaches": ["right"], "maneuvers": ["straight"]}
    assert told(describe("four_way", 4, [EGO, car])) == [("ego", "car", "ego", "priority_to_right")]


def test_a_left_turn_waits_for_the_oncoming(describe):
    car = {"id": "car", "approaches": ["opposite"], "maneuvers": ["straight"]}
    turning = EGO | {"maneuvers": ["left"]}
    assert told(describe("four_way", 4, [turning, car], control="signals")) == [
        ("ego", "car", "ego", "oncoming")
    ]


def test_one_behind_keeps_its_distance(describe):
    car = {"id": "car", "approaches": ["ahead"], "maneuvers": ["right"]}
    assert told(describe("four_way", 4, [EGO, car])) == [("ego", "car", "ego", "ahead")]


def test_who_changes_lane_lets_the_other_pass(describe):
    car = {"id": "car", "approaches": ["ahead"], "maneuvers": ["lane_change"], "entries": [0]}
    act = {"id": "change", "participant": "car", "kind": "change_lane", "side": "left"}
    functional = describe("straight", 2, [EGO, car], more={"acts": [act]})
    assert told(functional) == [("ego", "car", "car", "lane_change")]


def test_side_by_side_neither_waits(describe):
    car = {"id": "car", "approaches": ["adjacent", "left"], "maneuvers": ["straight"]}
    assert told(describe("straight", 2, [EGO, car], lanes=[2, 2])) == [("ego", "car", None, None)]


def test_a_pedestrian_at_a_junction_has_a_crosswalk(describe):
    walker = {"id": "walker", "kind": "pedestrian", "entries": [2]}
    for scenario in enumerate_scenarios(describe("four_way", 4, [EGO, walker])).scenarios:
        (conflict,) = scenario.conflicts
        assert (conflict.yields, conflict.rule) == ("ego", "crosswalk")


def test_on_an_open_road_a_pedestrian_waits(describe):
    walker = {"id": "walker", "kind": "pedestrian", "entries": [1]}
    for scenario in enumerate_scenarios(describe("straight", 2, [EGO, walker])).scenarios:
        (conflict,) = scenario.conflicts
        assert (conflict.yields, conflict.rule) == ("walker", "no_crosswalk")


@st.composite
def junctions(draw):
    kind = draw(st.sampled_from(list(JunctionKind)))
    fewest, most = ARM_COUNTS[kind]
    arms = draw(st.integers(fewest, min(most, 6)))
    angles = draw(st.lists(st.integers(0, 359), min_size=arms, max_size=arms, unique=True))
    return Junction(
        kind=kind,
        arms=arms,
        arm_angles_deg=sorted(angles) if draw(st.booleans()) else (),
        control=draw(st.sampled_from(list(Control))),
        driving_side=draw(st.sampled_from(list(DrivingSide))),
    )


@settings(max_examples=40, derandomize=True)
@given(junction=junctions())
def test_every_pair_that_meets_is_decided_once(junction):
    """Only curves that swing over each other without need are nobody's business."""
    rules = road_rules(junction)
    swings = curves_that_meet(junction)
    for (e, x, f, y), kind in rules.kinds.items():
        said = [
            rules.gives_way.get((e, x, f, y)),
            rules.gives_way.get((f, y, e, x)),
            rules.open.get((e, x, f, y)),
        ]
        regulated = e != f and kind in {ConflictKind.CROSSING, ConflictKind.MERGING}
        found = 3 - said.count(None)
        swung = (e, x, f, y) in swings or (f, y, e, x) in swings
        assert found == regulated or (swung and found == 0), (e, x, f, y, said)


# --- deadlocks ----------------------------------------------------------------------------------


def stuck(entries, moves, arms=4, **junction):
    """Who is in a deadlock when car i enters at entries[i] and makes moves[i]."""
    functional = plain_crossing(entries, arms)
    kind = junction.pop("kind", functional.junction.kind)
    changed = functional.junction.model_copy(update={"kind": JunctionKind(kind), **junction})
    functional = functional.model_copy(update={"junction": changed})
    listed = enumerate_scenarios(functional, reduction=Reduction.NONE).scenarios
    (found,) = [s for s in listed if tuple(d.move for d in s.drives) == moves]
    return found.deadlock


ALL_FOUR = ("car_1", "car_2", "car_3", "car_4")


@pytest.mark.parametrize(
    ("control", "expected"),
    [
        ("uncontrolled", ALL_FOUR),
        ("priority_to_right", ALL_FOUR),
        ("all_way_stop", ALL_FOUR),  # if all four arrive at once
        ("yield", ()),
        ("stop", ()),
        ("signals", ()),
        ("signals_off", ALL_FOUR),
    ],
)
@pytest.mark.parametrize("side", list(DrivingSide))
def test_four_cars_each_with_one_to_the_right(control, expected, side):
    found = stuck((0, 1, 2, 3), (2, 2, 2, 2), control=Control(control), driving_side=side)
    assert found == expected


def test_one_that_turns_right_unlocks_it():
    assert stuck((0, 1, 2, 3), (1, 2, 2, 2)) == ()


def test_three_at_a_t():
    """East turns left and lets west pass, west lets the stem pass, the stem lets east pass."""
    assert stuck((0, 1, 2), (2, 2, 2), arms=3, kind="t") == ("car_1", "car_2", "car_3")


def test_those_behind_are_not_at_the_line():
    assert stuck((0, 1, 2, 3, 0), (2, 2, 2, 2, 2)) == ALL_FOUR
    assert stuck((0, 1, 2, 3, 0), (1, 2, 2, 2, 2)) == ()


def test_a_free_ring_holds_nobody_up():
    assert stuck((0, 1, 2, 3), (2, 2, 2, 2), kind="roundabout") == ()


class Waits(Predicate):
    one: ConstantStr
    other: ConstantStr


class Stuck(Predicate):
    one: ConstantStr


@settings(max_examples=60, derandomize=True)
@given(
    st.lists(
        st.tuples(st.integers(0, 5), st.integers(0, 5), st.booleans()), unique_by=lambda w: w[:2]
    )
)
def test_without_the_solver_as_with_it(pairs):
    """deadlock_among finds what deadlock.lp says."""
    names = [f"car_{number}" for number in range(6)]
    pairs = [pair for pair in pairs if pair[0] != pair[1]]
    facts = [Waits(names[one], names[other]) for one, other, _ in pairs]
    said = {fact.one for fact in consequences(facts, (Part.DEADLOCK,), (Stuck,))}
    conflicts = [
        Conflict(
            first=names[other if turned else one],
            second=names[one if turned else other],
            kind="crossing",
            yields=names[one],
        )
        for one, other, turned in pairs
    ]
    assert deadlock_among(names, conflicts) == tuple(n for n in names if n in said)
