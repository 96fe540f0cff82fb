"""Bound to the ego, a danger survives an ego that comes earlier or later."""

import pytest
from saying import KMH
from told import made, told, who

from scegen.claims.ways import paths_of, ways_of
from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.criticality.reactivity.binding import bind_to_ego
from scegen.criticality.reactivity.sensitivity import ego_start_sensitivity
from scegen.enumeration import enumerate_scenarios
from scegen.pipeline.picking import pick
from scegen.road import build_network
from scegen.scenario.concrete import ArrivalBelow
from scegen.understanding import read

SENTENCES = {
    "crossing": "The ego goes straight at a four-way intersection while a car from the left runs "
    "the red light.",
    "cut in": "On a straight road a car cuts in abruptly in front of the ego.",
    "ring": "A car aggressively merges into a roundabout at high speed while the ego drives "
    "around in it.",
}


def raised(sentence):
    functional = read(sentence)
    concrete = concretize(functional, pick(enumerate_scenarios(functional), None)[0], seed=1)
    return raise_criticality(functional, concrete, seed=1)


def sensitivity(concrete, partner):
    paths = paths_of(ways_of(concrete, build_network(concrete.road)))
    return ego_start_sensitivity(concrete, paths, partner=partner)


@pytest.mark.parametrize("sentence", SENTENCES.values(), ids=SENTENCES)
def test_dangers_are_bound_to_the_ego_and_still_proved(sentence):
    result = raised(sentence)
    assert result.proof.reached
    partner = next(name for name in result.proof.pair if name != result.concrete.ego.id)
    program = result.concrete.participant(partner).speed_program
    assert isinstance(program[0].trigger, ArrivalBelow)
    assert program[0].trigger.participant == result.concrete.ego.id
    found = sensitivity(result.concrete, partner)
    assert found.reactive
    assert not found.others_touch
    assert any(change.by == "reactivity" for change in result.concrete.provenance)


def test_nothing_changes_where_the_result_would_not_stand():
    result = raised(SENTENCES["crossing"])
    network = build_network(result.concrete.road)
    functional = read(SENTENCES["crossing"])
    timed = concretize(functional, pick(enumerate_scenarios(functional), None)[0], seed=0)
    others = {p.id: [7.0] for p in timed.participants if p.id != timed.ego.id}
    assert bind_to_ego(timed, network, others, lambda _: False) is timed
    # Who looks at the ego already is left alone.
    assert bind_to_ego(result.concrete, network, others, lambda _: True) is result.concrete


@pytest.mark.parametrize("speed", [50, 80, 110, 130])
def test_nobody_crawls_along_a_road_to_wait_for_the_ego(speed):
    people = [
        who("ego", maneuvers=["straight"], speed=speed * KMH),
        who("van", "van", ["adjacent", "right"], ["lane_change"]),
    ]
    road = {"lanes": 2, "carriageway": "divided"}
    functional = told("straight", people, [("cut_in", "van", "ego")], **road)
    concrete, proof = made(functional)
    assert proof.reached
    assert concrete.participant("van").speed_mps >= 0.45 * speed * KMH - 0.1
