"""Junctions with one thing changed: arms, lanes, signs, order, who comes first."""

import pytest
from mutating import changed, later, on_road, phase, start
from saying import made, missed
from sayings import AT_JUNCTIONS, LANES, QUEUE, RED, RING, RUSHES, SKEWED, STRAYS, TURNS_LEFT, ZEBRA

from scegen.scenario.concrete import LaneChange, SpeedPhase, Travelled
from scegen.scenario.vocabulary import Control, DrivingSide


def moved(c, name, metres):
    """Somebody starts farther on, or farther back."""
    return changed(c, name, {"start_m": start(c, name) + metres})


def stops_before(c, name):
    """It stops at the line and drives on."""
    motion = c.participant(name).motion
    gone = motion.turning_starts_m - motion.start_m - 15.0
    slows = SpeedPhase(
        trigger=Travelled(participant=name, distance_m=gone), target_speed_mps=0.5, rate_mps2=4.0
    )
    goes = SpeedPhase(
        trigger=Travelled(participant=name, distance_m=gone + 17.0),
        target_speed_mps=8.0,
        rate_mps2=1.5,
    )
    return changed(c, name, speed_program=(slows, goes))


def swapped(c, one, other):
    """Two of one arm in one another's place."""
    a, b = start(c, one), start(c, other)
    return changed(changed(c, one, {"start_m": b}), other, {"start_m": a})


def in_lane(c, name, lane):
    """It keeps to another lane."""
    return changed(c, name, {"entry_lane": lane, "exit_lane": lane})


def aside(c, name):
    """It changes lane before the junction without being said to."""
    out = LaneChange(position_m=start(c, name) + 20.0, length_m=30.0, lane_after=2)
    return changed(c, name, {"lane_changes": (out,), "exit_lane": 2})


def earlier_astray(c, name):
    """What it is said to do it has done before, and what leads to the contact is not that."""
    out, back = c.participant(name).motion.lane_changes
    early = [
        each.model_copy(update={"position_m": start(c, name) + at_m, "length_m": 10.0})
        for each, at_m in ((out, 1.0), (back, 12.0))
    ]
    unsaid = [each.model_copy(update={"hazard": None}) for each in (out, back)]
    return changed(c, name, {"lane_changes": (*early, *unsaid)})


def signs_elsewhere(c):
    return on_road(c, controlled_arms=frozenset(range(4)) - c.road.controlled_arms)


def turned_road(c):
    """The arms lie as at any crossing."""
    angles = zip(c.road.arms, (0.0, 90.0, 180.0, 270.0), strict=True)
    arms = tuple(
        arm.model_copy(update={"angle_deg": angle, "angle_to_previous_deg": 90.0})
        for arm, angle in angles
    )
    return on_road(c, arms=arms)


MUTATIONS = {
    "it turns the other way": (
        TURNS_LEFT,
        lambda c: changed(c, "car", {"exit": 3}),
        "maneuver.turn.car",
    ),
    "it has come back before it hits": (
        STRAYS,
        lambda c: earlier_astray(c, "van"),
        "hazard.0.oncoming_lane",
    ),
    "it leaves by another arm": (
        TURNS_LEFT,
        lambda c: changed(c, "car", {"exit": 0}),
        "exit.car",
    ),
    "it turns behind the other": (
        TURNS_LEFT,
        lambda c: moved(c, "car", -35.0),
        "hazard.0.unprotected_left_turn",
    ),
    "it comes from another arm": (
        RUSHES,
        lambda c: changed(c, "van", {"entry": 3, "exit": 1}),
        "approach.van.ego",
    ),
    "it comes by another arm than is listed": (
        RUSHES,
        lambda c: changed(c, "van", {"entry": 3, "exit": 1}),
        "entry.van",
    ),
    "their ways do not cross": (
        RUSHES,
        lambda c: changed(c, "van", {"exit": 2}),
        "exit.van",
    ),
    "it yields": (RUSHES, lambda c: stops_before(c, "van"), "hazard.0.failure_to_yield"),
    "it comes behind the one with priority": (
        RUSHES,
        lambda c: moved(c, "van", -25.0),
        "hazard.0.failure_to_yield",
    ),
    "the signs stand at the other road": (RUSHES, signs_elsewhere, "road.control"),
    "lights instead of signs": (
        RUSHES,
        lambda c: on_road(c, control=Control.SIGNALS),
        "road.control",
    ),
    "traffic keeps to the other side": (
        RUSHES,
        lambda c: on_road(c, driving_side=DrivingSide.LEFT),
        "road.driving_side",
    ),
    "the queue is the other way round": (
        QUEUE,
        lambda c: swapped(c, "ego", "bus"),
        "order.bus.ego",
    ),
    "the one ahead comes by another arm": (
        QUEUE,
        lambda c: changed(c, "bus", {"entry": 1, "exit": 3}),
        "approach.bus.ego",
    ),
    "it takes another exit of the ring": (
        RING,
        lambda c: changed(c, "ego", {"exit": 3}),
        "exit.ego",
    ),
    "it enters the ring by another arm": (
        RING,
        lambda c: changed(c, "car", {"entry": 2}),
        "entry.car",
    ),
    "walks over another arm": (
        ZEBRA,
        lambda c: changed(c, "walker", {"arm": 0}),
        "entry.walker",
    ),
    "steps out after, not before": (
        ZEBRA,
        lambda c: later(c, "walker", 22.0),
        "hazard.0.crossing_pedestrian",
    ),
    "there is no crosswalk": (
        ZEBRA,
        lambda c: on_road(c, crosswalks=frozenset()),
        "road.crosswalks",
    ),
    "the ego goes straight on": (
        ZEBRA,
        lambda c: changed(c, "ego", {"exit": 2}),
        "maneuver.turn.ego",
    ),
    "it stops at the red light": (
        RED,
        lambda c: stops_before(c, "truck"),
        "hazard.0.red_light_running",
    ),
    "they miss one another": (RED, lambda c: moved(c, "truck", -30.0), "outcome.kind"),
    "the ego is slower": (
        RED,
        lambda c: changed(c, "ego", speed_mps=c.ego.speed_mps - 0.4),
        "speed.ego",
    ),
    "another touches as well": (
        QUEUE,
        lambda c: changed(c, "bus", {"start_m": start(c, "ego") + 5.0}),
        "contacts",
    ),
    "the arms lie otherwise": (SKEWED, turned_road, "road.arm_angles_deg"),
    "another lane": (LANES, lambda c: in_lane(c, "ego", 2), "lane.ego"),
    "on the other side of the ego": (
        LANES,
        lambda c: in_lane(in_lane(c, "ego", 2), "car", 1),
        "beside.car.ego",
    ),
    "it changes lane unsaid": (LANES, lambda c: aside(c, "ego"), "maneuver.lane.ego"),
    "it jumps the start": (TURNS_LEFT, lambda c: phase(c, "car", rate_mps2=20.0), "body.car"),
}


@pytest.mark.parametrize("functional", AT_JUNCTIONS, ids=lambda f: f.participants[1].id)
def test_as_it_was_made_everything_holds(functional):
    result = made(functional)
    assert [claim.statement for claim in result.proof.missed] == []
    assert missed(functional, result.concrete) == set()


@pytest.mark.parametrize("name", MUTATIONS)
def test_one_thing_changed_is_noticed(name):
    functional, change, expected = MUTATIONS[name]
    logical = made(functional).concrete.logical
    concrete = change(made(functional).concrete)
    concrete = type(concrete).model_validate(concrete.model_dump())
    assert expected in missed(functional, concrete, logical)
