"""The search: every danger at once, in the band, and proved by another simulator."""

import itertools

import numpy as np
import pytest

from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.criticality.search.rebuild import off_the_steps
from scegen.enumeration import enumerate_scenarios
from scegen.errors import MotionInfeasibleError
from scegen.measures import build_tables, measure
from scegen.motion import build_paths, simulate
from scegen.motion.batch import stack_traces
from scegen.pipeline.picking import pick
from scegen.road import build_network
from scegen.scenario.concrete import ArrivalBelow, DriveMotion, StoodStill
from scegen.scenario.environment import Environment, RoadSurface
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import Control, HazardKind, JunctionKind, Maneuver, Role
from scegen.understanding import read

SENTENCES = {
    "four_way": "The ego turns left at a four-way intersection while an oncoming car goes "
    "straight.",
    "t": "Two speeding vehicles approach a T-intersection simultaneously from opposite directions, "
    "one trying to make an unprotected left turn.",
    "y": "A distracted driver delays braking at a Y-intersection while another car merges "
    "unexpectedly from the right.",
    "skewed": "A car runs a red light at a skewed intersection and another car crosses.",
    "roundabout": "A car abruptly changes lanes in a roundabout while another vehicle accelerates "
    "to exit, causing a near-collision scenario.",
    "walker": "A vehicle tailgating another car at a four-way stop, leading to a sudden braking "
    "event as a pedestrian steps into the crosswalk.",
}


def made(functional, seed=0):
    logical = enumerate_scenarios(functional)
    return functional, concretize(functional, pick(logical, None)[0], seed=seed)


def two_cars(kind=JunctionKind.FOUR_WAY, arms=4, *, limit=None, speed=None, **more):
    return FunctionalScenario(
        description="by hand",
        junction=Junction(kind=kind, arms=arms, speed_limit_mps=limit),
        participants=(
            Participant(id="ego", role=Role.EGO, speed_mps=speed),
            Participant(id="other"),
        ),
        **more,
    )


def independent(concrete, pair):
    """Distances and contacts as simulated on paths built anew, at 0.01 s."""
    paths = build_paths(concrete, build_network(concrete.road))
    traces = simulate(concrete, paths, dt_s=0.01)
    names = [p.id for p in concrete.participants]
    scene = build_tables([paths[n] for n in names], [p.body for p in concrete.participants])
    summary = measure(stack_traces([traces[n] for n in names]), scene)
    wanted = {names.index(n) for n in pair}
    number = next(n for n, p in enumerate(scene.pairs) if set(map(int, p)) == wanted)
    return summary, number


@pytest.mark.parametrize("sentence", SENTENCES.values(), ids=SENTENCES)
def test_dangers_happen_and_the_proof_can_be_repeated(sentence):
    functional, concrete = made(read(sentence))
    raised = raise_criticality(functional, concrete)
    proof = raised.proof
    assert proof.blocked_by is None
    assert proof.reached
    assert all(hazard.happened and hazard.margin >= 0 for hazard in proof.hazards)
    assert len(proof.hazards) == len(concrete.hazards)
    summary, n = independent(raised.concrete, proof.pair)
    assert np.isnan(summary.contact_s).all()
    for name, field in (("distance", "distance_m"), ("pet", "pet_s"), ("ttc", "ttc_s")):
        value = float(getattr(summary, field)[0, n])
        told = proof.of(name).after
        assert (told is None) == (not np.isfinite(value))
        if told is not None:
            assert told == pytest.approx(value, abs=0.02)
    decisive = proof.of(proof.measure).after
    assert proof.band[0] <= decisive <= proof.band[1]


def test_the_same_seed_gives_the_same_and_changes_are_accounted_for():
    functional, concrete = made(read(SENTENCES["t"]))
    first, second = (raise_criticality(functional, concrete, seed=3) for _ in range(2))
    assert first == second
    assert first.proof.changed
    changes = [c for c in first.concrete.provenance if c.by == "search"]
    assert changes
    bound = [c for c in first.concrete.provenance if c.by == "reactivity"]
    assert bound
    last = {c.parameter: c.after for c in changes}
    assert all(c.before in {None, last.get(c.parameter, c.before)} for c in bound)
    for change in changes:
        assert change.before != change.after
        assert "near-miss" in change.reason
    after = {c.parameter: c.after for c in first.concrete.provenance}
    for participant in first.concrete.participants:
        was = concrete.participant(participant.id)
        if participant.speed_mps != was.speed_mps:
            assert after[f"{participant.id}.speed_mps"] == participant.speed_mps
        if isinstance(participant.motion, DriveMotion):
            moved = participant.motion.start_m != was.motion.start_m
            changed = {c.parameter for c in (*changes, *bound)}
            assert moved == (f"{participant.id}.start_m" in changed)


@pytest.mark.parametrize(
    ("target", "low", "high"),
    [("pet=0.6..0.9", 0.6, 0.9), ("distance=1.0..1.5", 1.0, 1.5), ("ttc=0.8..1.2", 0.8, 1.2)],
)
def test_bands_are_met(target, low, high):
    functional, concrete = made(read(SENTENCES["four_way"]))
    proof = raise_criticality(functional, concrete, target=target).proof
    assert proof.in_band
    assert low <= proof.of(target.split("=")[0]).after <= high


def test_a_collision_is_one_of_the_wanted_pair_only():
    functional, concrete = made(read("Ten cars arriving at a T intersection."))
    raised = raise_criticality(functional, concrete, target="collision")
    assert raised.proof.in_band
    summary, n = independent(raised.concrete, raised.proof.pair)
    touching = np.flatnonzero(~np.isnan(summary.contact_s[0]))
    assert touching.tolist() == [n]


def test_solutions_differ_and_all_hold():
    functional, concrete = made(two_cars())
    raised = raise_criticality(functional, concrete, solutions=3)
    found = [(raised.concrete, raised.proof), *raised.others]
    assert len(found) == 3
    assert all(proof.reached for _, proof in found)
    for (a, _), (b, _) in itertools.combinations(found, 2):
        assert a.participants != b.participants


def test_numbers_stay_within_bodies_and_ranges():
    functional, concrete = made(read(SENTENCES["y"]))
    for participant in raise_criticality(functional, concrete).concrete.participants:
        body = participant.body
        was = concrete.participant(participant.id)
        allowed = [
            p for p in concrete.logical.parameters if p.name == f"{participant.id}.speed_mps"
        ]
        for limits in allowed:
            planned = participant.speed_mps
            if participant.speed_program:
                first = participant.speed_program[0]
                # One who waits for the ego is slower until it comes.
                waits = isinstance(first.trigger, ArrivalBelow)
                planned = first.target_speed_mps if waits else planned
            assert min(limits.low, was.speed_mps) - 1e-3 <= planned
            assert planned <= max(limits.high, was.speed_mps) + 1e-3
        for phase in participant.speed_program:
            assert phase.rate_mps2 <= max(body.max_deceleration_mps2, body.max_acceleration_mps2)


def test_ice_takes_the_brakes_away():
    hazards = (Hazard(kind=HazardKind.HARD_BRAKING, by=("ego",)),)
    _, dry = made(two_cars(hazards=hazards))
    assert max(p.rate_mps2 for p in dry.ego.speed_program) > 5
    ice = Environment(road_surface=RoadSurface.ICY)
    functional, concrete = made(two_cars(hazards=hazards, environment=ice))
    raised = raise_criticality(functional, concrete)
    assert raised.proof.reached
    for scenario in (concrete, raised.concrete):
        for participant in scenario.participants:
            assert all(p.rate_mps2 <= 0.2 * 9.81 + 1e-3 for p in participant.speed_program)


def test_waits_are_as_long_as_the_program_says_wherever_the_stop_is():
    functional, concrete = made(read(SENTENCES["y"]))
    raised = raise_criticality(functional, concrete)

    def wait_s(scenario):
        traces = simulate(scenario, build_paths(scenario, build_network(scenario.road)))
        speed = traces["car_1"].speed_mps
        times = traces["car_1"].time_s[(speed < 1e-6) & (traces["car_1"].s_m > 1.0)]
        return times[-1] - times[0]

    assert raised.proof.changed
    for scenario in (concrete, raised.concrete):
        (wait,) = [
            p.trigger.duration_s
            for p in scenario.participant("car_1").speed_program
            if isinstance(p.trigger, StoodStill)
        ]
        assert wait_s(scenario) == pytest.approx(wait, abs=0.1)


@pytest.mark.parametrize("time_s", [1.0, 1.001, 1.009, 2.35, 3.3333])
def test_times_fall_between_steps(time_s):
    moved = off_the_steps(time_s)
    assert abs(moved - time_s) <= 0.004
    assert 1.4 < (moved * 1000) % 10 < 8.6


def refused(functional, target):
    scenario, concrete = made(functional)
    raised = raise_criticality(scenario, concrete, target=target)
    assert not raised.proof.in_band
    assert raised.concrete == concrete
    assert raised.proof.evaluations <= 1
    return raised.proof.blocked_by


def test_paths_that_never_meet_cannot_collide():
    opposite = two_cars(JunctionKind.STRAIGHT, 2).model_copy(
        update={
            "participants": (
                Participant(id="ego", role=Role.EGO, entries=frozenset({0})),
                Participant(id="other", entries=frozenset({1})),
            )
        }
    )
    reason = refused(opposite, "collision")
    assert "never meet" in reason
    assert "ego" in reason
    assert "other" in reason


def test_those_who_keep_to_lanes_of_their_own_never_meet():
    """Lanes lead to lanes: the outermost turns right, the innermost left, one lies in between."""
    functional = two_cars(JunctionKind.Y, 3)
    people = (
        Participant(
            id="ego", role=Role.EGO, entries=frozenset({0}), maneuvers=frozenset({Maneuver.RIGHT})
        ),
        Participant(id="other", entries=frozenset({2}), maneuvers=frozenset({Maneuver.LEFT})),
    )
    junction = functional.junction.model_copy(update={"lanes": (3, 3, 3)})
    update = {"participants": people, "junction": junction}
    reason = refused(functional.model_copy(update=update), "collision")
    assert "never meet: where their ways meet, each has a lane of its own" in reason


def test_who_creeps_over_a_stop_line_is_searched_for_in_the_steps_of_the_proof():
    """In steps of 0.05 s it passes 0.3 s later than in the proof's: what is found there is lost."""
    people = (
        Participant(id="ego", role=Role.EGO, entries=frozenset({0})),
        Participant(id="car_1", entries=frozenset({1})),
        Participant(id="car_2", entries=frozenset({2})),
    )
    junction = Junction(
        kind=JunctionKind.FOUR_WAY, arms=4, control=Control.ALL_WAY_STOP, speed_limit_mps=25
    )
    functional = FunctionalScenario(description="by hand", junction=junction, participants=people)
    (logical,) = (
        scenario
        for scenario in enumerate_scenarios(functional).scenarios
        if scenario.slug == "0right-1straight-2right"
    )
    raised = raise_criticality(
        functional, concretize(functional, logical, seed=0), target="collision"
    )
    assert raised.proof.reached, raised.proof.blocked_by
    summary, n = independent(raised.concrete, raised.proof.pair)
    assert np.flatnonzero(~np.isnan(summary.contact_s[0])).tolist() == [n]


def test_nobody_is_in_danger_alone():
    alone = two_cars().model_copy(update={"participants": (Participant(id="ego", role=Role.EGO),)})
    assert "nobody else is on the road" in refused(alone, "collision")


def test_nobody_is_in_danger_of_what_is_parked_beside_its_way():
    text = "A parked van stands on a straight road while the ego drives past at 10 m/s."
    proof = raise_criticality(*made(read(text))).proof
    assert not proof.in_band
    assert "nobody else moves" in proof.blocked_by


def test_nothing_is_dangerous_at_a_crawl():
    assert "walking pace" in refused(two_cars(limit=1.0), "pet=0..0.1")


def test_no_car_goes_500_mps():
    with pytest.raises(MotionInfeasibleError, match="500 m/s; a car reaches 60 m/s"):
        made(two_cars(speed=Interval(low=500, high=500)))


def test_steady_speeds_that_cross_have_a_ttc_of_0_or_none():
    """The refusal is true: a scan of the whole space finds nothing either."""
    functional, concrete = made(two_cars())
    assert not any(p.speed_program for p in concrete.participants)
    proof = raise_criticality(functional, concrete, target="ttc=0.8..1.2").proof
    assert not proof.in_band
    assert proof.blocked_by.startswith("reached by none of")


def test_a_demand_that_blocks_is_named():
    functional, concrete = made(two_cars())
    hides = {"hazards": (Hazard(kind=HazardKind.OCCLUSION, by=("other",), to=("ego",)),)}
    proof = raise_criticality(
        functional.model_copy(update=hides), concrete.model_copy(update=hides)
    ).proof
    assert not proof.reached
    assert [claim.statement for claim in proof.missed] == ["occlusion by other to ego happens"]
