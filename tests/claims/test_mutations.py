"""Concrete scenarios with one thing changed: claims, which know only what was said, notice."""

import pytest
from mutating import changed, later, phase, start
from saying import made, missed
from sayings import (
    BRAKES,
    CROSSES,
    CUTS_AND_BRAKES,
    CUTS_IN,
    EVERY,
    HIDES,
    IGNORES,
    PASSES,
    RUNS_INTO,
    STANDS,
    WALKS,
)

from scegen.scenario.concrete import AtTime, ConcreteParticipant, SpeedPhase, Travelled
from scegen.scenario.environment import Weather
from scegen.scenario.vocabulary import Control, ParticipantKind, Side


def swapped_starts(c):
    return changed(
        changed(c, "ego", {"start_m": start(c, "car")}), "car", {"start_m": start(c, "ego")}
    )


def other_culprit(c):
    braking = c.participant("car").speed_program
    return changed(changed(c, "ego", speed_program=braking), "car", speed_program=())


def stops_short(c):
    trigger = Travelled(participant="ego", distance_m=20.0)
    phase = SpeedPhase(trigger=trigger, target_speed_mps=0.0, rate_mps2=5.0)
    return changed(c, "ego", speed_program=(phase,))


def slows(c, name):
    return gains_speed(c, name, by_mps=-2.0)


def gains_speed(c, name, by_mps=1.0):
    after = SpeedPhase(
        trigger=AtTime(time_s=0.5),
        target_speed_mps=c.participant(name).speed_mps + by_mps,
        rate_mps2=1.0,
    )
    return changed(c, name, speed_program=(*c.participant(name).speed_program, after))


def other_signs(c):
    road = {"control": Control.UNCONTROLLED, "controlled_arms": frozenset()}
    return c.model_copy(update={"road": c.road.model_copy(update=road)})


def earlier_change(c, metres):
    (change,) = c.participant("van").motion.lane_changes
    moved = change.model_copy(update={"position_m": change.position_m - metres})
    return changed(c, "van", {"lane_changes": (moved,)})


def comes_in_behind(c):
    """As far behind as it was ahead, and the ego drives on."""
    (change,) = c.participant("van").motion.lane_changes
    van, ego = c.participant("van").body, c.ego.body
    back = 2 * 15.0 + van.length_m + ego.length_m
    moved = change.model_copy(update={"position_m": change.position_m - back})
    c = changed(c, "van", {"start_m": start(c, "van") - back, "lane_changes": (moved,)})
    return changed(c, "ego", speed_program=())


def other_lane(c):
    (change,) = c.participant("van").motion.lane_changes
    out = change.model_copy(update={"lane_after": 2})
    motion = {"entry_lane": 1, "lane_changes": (out,), "exit_lane": 2}
    return changed(c, "van", motion)


def bumper_to_bumper(c):
    """At one speed, a hand's breadth apart, and both brake alike."""
    near = start(c, "ego") + c.ego.body.length_m + 0.05
    braking = c.participant("car").speed_program
    return changed(changed(c, "car", {"start_m": near}), "ego", speed_program=braking)


def one_more(c):
    other = c.participant("car")
    motion = other.motion.model_copy(update={"entry": 1, "exit": 0, "start_m": 5.0})
    more = ConcreteParticipant(id="stranger", kind=other.kind, speed_mps=5.0, motion=motion)
    return c.model_copy(update={"participants": (*c.participants, more)})


MUTATIONS = {
    "order of the starts swapped": (BRAKES, swapped_starts, "approach.car.ego"),
    "two bodies in one place": (
        BRAKES,
        lambda c: changed(c, "car", {"start_m": start(c, "ego")}),
        "contacts",
    ),
    "the ego is faster": (
        BRAKES,
        lambda c: changed(c, "ego", speed_mps=c.ego.speed_mps + 0.5),
        "speed.ego",
    ),
    "the ego is faster later than at first": (
        BRAKES,
        lambda c: gains_speed(c, "ego"),
        "steady.ego",
    ),
    "it is level, not behind": (
        PASSES,
        lambda c: changed(c, "car", {"start_m": start(c, "ego")}),
        "approach.car.ego",
    ),
    "bumper to bumper": (RUNS_INTO, bumper_to_bumper, "opening.apart"),
    "bumper to bumper, no collision": (RUNS_INTO, bumper_to_bumper, "outcome.kind"),
    "the leader is slower": (
        BRAKES,
        lambda c: changed(c, "car", speed_mps=c.participant("car").speed_mps - 0.5),
        "speed.car",
    ),
    "it brakes harder": (BRAKES, lambda c: phase(c, "car", rate_mps2=6.0), "act.brake.rate_mps2"),
    "it brakes to another speed": (
        BRAKES,
        lambda c: phase(c, "car", target_speed_mps=4.0),
        "act.brake.target_speed_mps",
    ),
    "it does not brake": (BRAKES, lambda c: changed(c, "car", speed_program=()), "act.brake"),
    "it brakes at once": (
        CUTS_AND_BRAKES,
        lambda c: phase(c, "car", trigger=AtTime(time_s=0.4)),
        "opening.car",
    ),
    "it brakes before it cuts in": (
        CUTS_AND_BRAKES,
        lambda c: phase(c, "car", trigger=AtTime(time_s=1.5)),
        "act.brake.order",
    ),
    "the gap is longer": (
        BRAKES,
        lambda c: changed(c, "car", {"start_m": start(c, "car") + 2.0}),
        "spacing.0",
    ),
    "the culprit is another": (BRAKES, other_culprit, "hazard.0.hard_braking"),
    "it ends at the climax": (
        BRAKES,
        lambda c: c.model_copy(update={"duration_s": c.duration_s - 2.0}),
        "ending.goes_on",
    ),
    "the weather is another": (
        BRAKES,
        lambda c: c.model_copy(
            update={"environment": c.environment.model_copy(update={"weather": Weather.CLEAR})}
        ),
        "road.environment.weather",
    ),
    "somebody is there too many": (BRAKES, one_more, "road.participants"),
    "from the other lane, to the other side": (CUTS_IN, other_lane, "approach.van.ego"),
    "it stays in its lane": (
        CUTS_IN,
        lambda c: changed(c, "van", {"lane_changes": (), "exit_lane": 2}),
        "act.cut.side",
    ),
    "it comes in as far behind": (CUTS_IN, comes_in_behind, "spacing.0"),
    "who cuts in does so behind": (CUTS_IN, comes_in_behind, "hazard.0.cut_in"),
    "it cuts in earlier": (CUTS_IN, lambda c: earlier_change(c, 15.0), "spacing.0"),
    "the ego reacts": (IGNORES, lambda c: slows(c, "ego"), "unresponsive.ego"),
    "it is another kind of vehicle": (
        CUTS_IN,
        lambda c: changed(c, "van", kind=ParticipantKind.TRUCK),
        "body.van",
    ),
    "from the other side": (
        CROSSES,
        lambda c: changed(c, "car", {"entry": 1, "exit": 3}),
        "approach.car.ego",
    ),
    "it turns": (CROSSES, lambda c: changed(c, "car", {"exit": 2}), "exit.car"),
    "the ego turns": (CROSSES, lambda c: changed(c, "ego", {"exit": 1}), "exit.ego"),
    "other signs": (CROSSES, other_signs, "road.control"),
    "walks from the other side": (
        WALKS,
        lambda c: changed(c, "walker", {"start_side": Side.LEFT}),
        "approach.walker.ego",
    ),
    "walks faster": (
        WALKS,
        lambda c: phase(c, "walker", target_speed_mps=2.0),
        "speed.walker",
    ),
    "walks later": (WALKS, lambda c: later(c, "walker", 3.0), "outcome.impact_percent"),
    "does not walk": (WALKS, lambda c: changed(c, "walker", speed_program=()), "outcome.kind"),
    "stops on its way": (
        WALKS,
        lambda c: changed(c, "walker", {"stops_after_m": 3.0}),
        "outcome.impact_percent",
    ),
    "who stands drives": (STANDS, lambda c: changed(c, "car", speed_mps=3.0), "stands.car"),
    "it is offset in its lane": (
        STANDS,
        lambda c: changed(c, "car", {"offset_m": 1.0}),
        "spacing.0",
    ),
    "the ego stops short": (STANDS, stops_short, "outcome.kind"),
    "what hides is on the other side": (
        HIDES,
        lambda c: changed(c, "van", {"side": Side.LEFT}),
        "approach.van.ego",
    ),
    "what hides is far away": (
        HIDES,
        lambda c: changed(c, "van", {"from_junction_m": 80.0}),
        "hazard.1.occlusion",
    ),
}


@pytest.mark.parametrize("functional", EVERY, ids=lambda f: f.participants[1].id)
def test_as_it_was_made_everything_holds(functional):
    result = made(functional)
    assert [claim.statement for claim in result.proof.missed] == []
    assert missed(functional, result.concrete) == set()


@pytest.mark.parametrize("name", MUTATIONS)
def test_one_thing_changed_is_noticed(name):
    functional, change, expected = MUTATIONS[name]
    concrete = change(made(functional).concrete)
    concrete = type(concrete).model_validate(concrete.model_dump())
    assert expected in missed(functional, concrete, made(functional).concrete.logical)


def test_there_are_enough_of_them():
    assert len(MUTATIONS) >= 20
