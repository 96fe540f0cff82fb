"""A danger happens after a lead-in; between steady followers because the leader brakes."""

import numpy as np
import pytest

from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.criticality.raising.braking_leader import REASON
from scegen.criticality.search.lead_in import second_enters_s
from scegen.criticality.search.proving import examine
from scegen.criticality.search.variables import LEAD_IN_S
from scegen.criticality.target import COLLISION, NEAR_MISS, parse_target
from scegen.enumeration import enumerate_scenarios
from scegen.motion.friction import friction_of
from scegen.motion.trigger_steps import STEP_S
from scegen.pipeline.picking import pick
from scegen.road import build_network
from scegen.scenario.bodies import BODIES
from scegen.scenario.concrete import ArrivalBelow, Travelled
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import HazardKind, JunctionKind, Maneuver, Role
from scegen.understanding import read


def in_line(ego_rank=1, **more):
    """Two cars that follow each other on a straight road, the ego behind or ahead."""
    functional = FunctionalScenario(
        description="by hand",
        junction=Junction(kind=JunctionKind.STRAIGHT, arms=2, lanes=(1, 1)),
        participants=(
            Participant(id="ego", role=Role.EGO, entries={0}, maneuvers={Maneuver.STRAIGHT}),
            Participant(id="other", entries={0}, maneuvers={Maneuver.STRAIGHT}),
        ),
        **more,
    )
    listed = enumerate_scenarios(functional).scenarios
    logical = listed[0]
    drives = {d.participant: d for d in logical.drives}
    ranks = {"ego": ego_rank, "other": 1 - ego_rank}
    drives = tuple(
        drives[name].model_copy(update={"rank": ranks[name]})
        for name in sorted(ranks, key=ranks.get)
    )
    logical = logical.model_copy(update={"assignments": drives})
    return functional, concretize(functional, logical)


def shown(concrete, pair):
    network = build_network(concrete.road, name=concrete.name)
    return examine(concrete, network, [pair], friction_of(concrete.environment))


def bumper_to_bumper(concrete, gap_m=0.5):
    """The follower moved up until its front is so far behind the leader, both equally fast."""
    ego, other = concrete.participant("ego"), concrete.participant("other")
    speed = 10.0
    bodies = other.body.rear_m + ego.body.front_m
    start = other.motion.start_m - bodies - gap_m
    moved = {
        "ego": ego.model_copy(
            update={
                "speed_mps": speed,
                "motion": ego.motion.model_copy(update={"start_m": start}),
            }
        ),
        "other": other.model_copy(update={"speed_mps": speed}),
    }
    people = tuple(moved[p.id] for p in concrete.participants)
    return concrete.model_copy(update={"participants": people})


@pytest.mark.parametrize("target", [NEAR_MISS, "distance=0.3..0.8", "headway=0.03..0.08"])
def test_what_stands_at_the_start_does_not_happen(target):
    _, concrete = in_line()
    evidence = shown(bumper_to_bumper(concrete), ("ego", "other"))
    assert float(evidence.view.of_pair("distance_m", "ego", "other")[0]) == pytest.approx(
        0.5, abs=0.01
    )
    assert not evidence.meets(parse_target(target), ("ego", "other"))


def test_one_who_tailgates_may_be_close_from_the_start():
    functional, concrete = in_line(
        hazards=(Hazard(kind=HazardKind.TAILGATING, by=("ego",), to=("other",)),)
    )
    close = bumper_to_bumper(concrete, gap_m=5.0)
    assert shown(close, ("ego", "other")).meets(parse_target("headway=0.3..0.6"), ("ego", "other"))
    _, plain = in_line()
    apart = bumper_to_bumper(plain, gap_m=5.0)
    assert not shown(apart, ("ego", "other")).meets(
        parse_target("headway=0.3..0.6"), ("ego", "other")
    )
    raised = raise_criticality(functional, concrete)
    assert raised.proof.reached
    assert not [c for c in raised.concrete.provenance if c.reason.startswith("added")]


@pytest.mark.parametrize("target", [NEAR_MISS, COLLISION, "ttc=0.8..1.2", "headway=0.2..0.4"])
@pytest.mark.parametrize("ego_rank", [0, 1])
def test_between_steady_followers_the_leader_brakes(target, ego_rank):
    functional, concrete = in_line(ego_rank)
    raised = raise_criticality(functional, concrete, target=target)
    assert raised.proof.reached
    evidence = shown(raised.concrete, raised.proof.pair)
    closest = float(evidence.view.of_pair("closest_s", *raised.proof.pair)[0])
    assert closest > LEAD_IN_S
    added = [c for c in raised.concrete.provenance if c.reason.startswith(REASON)]
    leader = "other" if ego_rank else "ego"
    program = raised.concrete.participant(leader).speed_program
    if target == COLLISION and not added:
        return  # a faster follower runs into the one ahead by itself
    assert added
    assert {c.parameter.split(".")[0] for c in added} == {leader}
    assert len(program) == 2
    assert program[0].target_speed_mps < raised.concrete.participant(leader).speed_mps
    assert program[0].rate_mps2 <= BODIES["car"].max_deceleration_mps2
    wanted = ArrivalBelow if ego_rank else Travelled
    assert isinstance(program[0].trigger, wanted)
    if ego_rank:
        assert program[0].trigger.participant == "ego"
    fired = evidence.view.traces.fired_step[0] * evidence.view.dt_s
    assert fired.min() >= LEAD_IN_S - STEP_S  # a trigger is moved off the step that it ties with


def test_nothing_is_added_where_the_plain_search_succeeds_or_a_danger_is_stated():
    crossing = read("The ego turns left at a four-way intersection while a car comes towards it.")
    stated, concrete = in_line(
        hazards=(Hazard(kind=HazardKind.HARD_BRAKING, by=("other",), to=("ego",)),)
    )
    logical = enumerate_scenarios(crossing)
    cases = [
        (crossing, concretize(crossing, pick(logical, None)[0])),
        (stated, concrete),
    ]
    for functional, made in cases:
        raised = raise_criticality(functional, made)
        assert raised.proof.reached
        assert not [c for c in raised.concrete.provenance if c.reason.startswith("added")]


def test_a_post_encroachment_time_is_counted_from_the_second_entry():
    functional = read("The ego turns left at a four-way intersection while a car comes towards it.")
    concrete = concretize(functional, pick(enumerate_scenarios(functional), None)[0])
    raised = raise_criticality(functional, concrete, target="pet=0.4..0.9")
    assert raised.proof.in_band
    view = shown(raised.concrete, raised.proof.pair).view
    enters = float(second_enters_s(view, raised.proof.pair)[0])
    found = view.pair(*raised.proof.pair)[0]
    first = view.scene.areas.first[found]
    names = [raised.concrete.participants[i].id for i in view.scene.pairs[found]]
    by_hand = [
        np.argmax(view.place_m(name)[0] >= view.scene.areas.enter_m[first, k]) * view.dt_s
        for k, name in enumerate(names)
    ]
    assert enters == pytest.approx(max(by_hand), abs=2 * view.dt_s)
    assert enters >= LEAD_IN_S
