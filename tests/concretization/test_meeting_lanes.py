"""Where each would have a lane of its own, lanes are chosen in which those meet who are to."""

import pytest
from shapely import LineString

from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.enumeration import enumerate_scenarios
from scegen.motion import build_paths
from scegen.road import build_network
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import DrivingSide, JunctionKind, Maneuver, Role


def merging(kind, arms, ego, other, *, more=(), side=DrivingSide.RIGHT):
    """The ego and another on roads of two lanes, each (entry, manoeuvre)."""
    people = {"ego": ego, "other": other, **dict(more)}
    functional = FunctionalScenario(
        description="by hand",
        junction=Junction(kind=kind, arms=arms, lanes=(2,) * arms, driving_side=side),
        participants=tuple(
            Participant(
                id=name,
                role=Role.EGO if name == "ego" else Role.OTHER,
                entries=frozenset({entry}),
                maneuvers=frozenset({maneuver}),
            )
            for name, (entry, maneuver) in people.items()
        ),
    )
    return functional, concretize(functional, enumerate_scenarios(functional).scenarios[0])


def apart_m(concrete, first="ego", second="other"):
    """How near the lines of two ways come, by shapely."""
    paths = build_paths(concrete, build_network(concrete.road))
    one, two = (
        LineString(list(zip(paths[n].x_m, paths[n].y_m, strict=True))) for n in (first, second)
    )
    return one.distance(two)


def said(concrete):
    return {c.parameter for c in concrete.provenance if c.reason.endswith("meet")}


@pytest.mark.parametrize(
    ("kind", "ego", "other", "side", "changed"),
    [
        (
            JunctionKind.T,
            (2, Maneuver.RIGHT),
            (1, Maneuver.STRAIGHT),
            DrivingSide.LEFT,
            {"entry_lane", "exit_lane"},
        ),
        (
            JunctionKind.FOUR_WAY,
            (1, Maneuver.LEFT),
            (3, Maneuver.RIGHT),
            DrivingSide.RIGHT,
            {"exit_lane"},
        ),
        (
            JunctionKind.FOUR_WAY,
            (3, Maneuver.RIGHT),
            (1, Maneuver.LEFT),
            DrivingSide.RIGHT,
            {"exit_lane"},
        ),
    ],
)
def test_those_who_leave_by_one_arm_meet_there(kind, ego, other, side, changed):
    arms = 3 if kind is JunctionKind.T else 4
    functional, concrete = merging(kind, arms, ego, other, side=side)
    assert apart_m(concrete) < 1.0
    assert said(concrete) == {f"other.{name}" for name in changed}
    for target in ("near-miss", "collision"):
        assert raise_criticality(functional, concrete, target=target).proof.reached


def test_the_ego_keeps_to_the_way_of_the_text():
    _, concrete = merging(JunctionKind.FOUR_WAY, 4, (1, Maneuver.LEFT), (3, Maneuver.RIGHT))
    assert not concrete.participant("ego").motion.lane_changes
    assert concrete.participant("other").motion.lane_changes


def test_lanes_stay_as_they_are_where_those_in_conflict_meet_anyway():
    _, concrete = merging(JunctionKind.FOUR_WAY, 4, (0, Maneuver.LEFT), (2, Maneuver.STRAIGHT))
    assert apart_m(concrete) < 1.0
    assert not said(concrete)


def test_nobody_moves_over_where_the_ego_meets_somebody_else():
    _, concrete = merging(
        JunctionKind.FOUR_WAY,
        4,
        (1, Maneuver.LEFT),
        (3, Maneuver.RIGHT),
        more=[("third", (3, Maneuver.STRAIGHT))],
    )
    assert apart_m(concrete, "ego", "third") < 1.0
    assert not any(p.motion.lane_changes for p in concrete.participants)


@pytest.mark.parametrize("lane", [1, 2])
def test_a_lane_that_is_said_is_driven_in(lane):
    functional, _ = merging(
        JunctionKind.FOUR_WAY, 4, (0, Maneuver.STRAIGHT), (1, Maneuver.STRAIGHT)
    )
    people = tuple(
        p.model_copy(update={"lanes": frozenset({lane})}) if p.id == "other" else p
        for p in functional.participants
    )
    said = functional.model_copy(update={"participants": people})
    concrete = concretize(said, enumerate_scenarios(said).scenarios[0])
    assert concrete.participant("other").motion.entry_lane == lane
