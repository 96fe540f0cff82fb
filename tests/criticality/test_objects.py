"""Things cause dangers: they are passed, hit, seen, and hide."""

import numpy as np
import pytest
from criticality_geometry import line
from criticality_scenarios import participant, phase, scenario
from things import thing

from scegen.claims.hazards.judging import judge
from scegen.claims.hazards.scenes import scene_of
from scegen.claims.view import view_of
from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.criticality.careful_driver import Outcome, careful_driver_verdict
from scegen.criticality.encounter import closest_encounter
from scegen.criticality.reactivity.sensitivity import ego_start_sensitivity
from scegen.criticality.search.pairs import candidate_pairs
from scegen.enumeration import enumerate_scenarios
from scegen.motion import simulate
from scegen.motion.batch import compile_program, simulate_batch
from scegen.scenario.concrete import AtTime
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind
from scegen.understanding import read

EGO_WAY = line(0.0, 0.0, 0.0, 400.0)
IN_THE_WAY = Hazard(kind=HazardKind.OBSTACLE, by=("crate_1",), to=("ego",))


def with_things(*things, people=(), hazards=(), speed=12.0):
    ego = participant("ego", speed=speed)
    made = scenario(ego, *people, hazards=hazards)
    return made.model_copy(update={"objects": things})


def proof(concrete, paths, hazard):
    program, own = compile_program(concrete, paths)
    traces = simulate_batch(program, own, duration_s=concrete.duration_s)
    pairs = [(a.id, "ego") for a in concrete.entities if a.id != "ego"]
    scene = scene_of(concrete, paths, pairs, 1.0)
    return judge(view_of(concrete, {}, scene, traces, 1.0), hazard)


@pytest.mark.parametrize(("y_m", "happened"), [(0.0, True), (3.4, True), (5.0, False)])
def test_a_thing_endangers_who_passes_close(y_m, happened):
    concrete = with_things(thing(y_m=y_m), hazards=(IN_THE_WAY,))
    found = proof(concrete, {"ego": EGO_WAY}, IN_THE_WAY)
    assert found.happened is happened
    # Half a car and half a metre lie between the middles.
    assert found.margin == pytest.approx(2.0 - max(0.0, y_m - 1.08 - 0.5), abs=1e-3)


def test_a_thing_hides_who_is_behind_it():
    walker = participant("walker", "pedestrian", 0.0, [phase(AtTime(time_s=3.0), 1.5, 20.0)])
    paths = {"ego": EGO_WAY, "walker": line(60.0, -6.0, np.pi / 2, 12.0)}
    hazard = Hazard(kind=HazardKind.OCCLUSION, by=("wall_1",), to=("ego",))
    for x_m, happened in ((57.0, True), (70.0, False)):
        wall = thing("wall_1", x_m, -5.5, length_m=4.0, width_m=2.0)
        concrete = with_things(wall, people=(walker,), hazards=(hazard,))
        assert proof(concrete, paths, hazard).happened is happened


def test_a_careful_driver_stops_for_it_and_sees_nobody_through_it():
    found = careful_driver_verdict(with_things(thing(x_m=80.0)), {"ego": EGO_WAY})
    assert (found.outcome, found.contact_as_driven) == (Outcome.AVOIDABLE, ("crate_1",))
    assert found.danger == "crate_1"
    walker = participant("walker", "pedestrian", 0.0, [phase(AtTime(time_s=2.6), 2.0, 20.0)])
    paths = {"ego": EGO_WAY, "walker": line(60.0, -5.0, np.pi / 2, 12.0)}
    wall = thing("wall_1", 56.0, -3.2, length_m=6.0, width_m=3.0)
    seen, hidden = (
        careful_driver_verdict(with_things(*things, people=(walker,)), paths)
        for things in ((), (wall,))
    )
    assert hidden.danger in {None, "walker"}
    assert hidden.perceived_s is None or hidden.perceived_s > seen.perceived_s


def test_the_event_is_about_an_obstacle_but_not_about_what_hides():
    far = participant("far", speed=12.0)
    paths = {"ego": EGO_WAY, "far": line(0.0, 40.0, 0.0, 400.0)}
    beside = with_things(thing(y_m=4.0), people=(far,))
    assert closest_encounter(beside, simulate(beside, paths)).other == "far"
    in_the_way = with_things(thing(y_m=4.0), people=(far,), hazards=(IN_THE_WAY,))
    assert closest_encounter(in_the_way, simulate(in_the_way, paths)).other == "crate_1"
    found = ego_start_sensitivity(in_the_way, paths)
    assert found.partner == "crate_1"


def test_people_come_before_things_as_whom_a_target_is_about():
    hazards = (IN_THE_WAY, Hazard(kind=HazardKind.HARD_BRAKING, by=("far",), to=("ego",)))
    concrete = with_things(thing(), people=(participant("far", speed=12.0),), hazards=hazards)
    assert candidate_pairs(concrete)[:2] == [("far", "ego"), ("crate_1", "ego")]


def test_others_in_file_are_no_pair_if_nothing_is_said_of_them():
    said = "The ego is in the left lane of a motorway and passes two trucks in the right lane."
    functional = read(said)
    concrete = concretize(functional, enumerate_scenarios(functional).scenarios[0])
    assert all("ego" in pair for pair in candidate_pairs(concrete))
    raised = raise_criticality(functional, concrete)
    assert raised.proof.blocked_by
    assert not raised.proof.missed


@pytest.mark.parametrize(("target", "contact"), [("near-miss", False), ("collision", True)])
def test_the_search_stops_short_of_it_or_in_it(target, contact):
    functional = read("A crate lies in the ego's lane on a straight road.")
    concrete = concretize(functional, enumerate_scenarios(functional).scenarios[0])
    raised = raise_criticality(functional, concrete, target=target)
    assert raised.proof.reached
    assert raised.proof.pair == ("box_1", "ego")
    assert (raised.proof.of("contact_time").after is not None) is contact
    assert raised.concrete.objects == concrete.objects
    assert raised.concrete.ego.speed_program[-1].target_speed_mps == 0.0
