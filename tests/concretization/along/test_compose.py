"""End to end: everything that is said of a plain road holds in what is made of it."""

from __future__ import annotations

from itertools import combinations, islice

import pytest
from roads import SCENARIOS

from scegen.claims import claims_of
from scegen.claims.hazards.scenes import scene_of
from scegen.claims.proving import prove
from scegen.claims.view import view_of
from scegen.claims.ways import paths_of, ways_of
from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.motion.batch.compilation import compile_program
from scegen.motion.batch.simulation import simulate_batch
from scegen.motion.friction import friction_of
from scegen.road import build_network
from scegen.scenario.acts import ActKind
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.spacings import Measure

AT_JUNCTIONS = {
    ActKind.TURN,
    ActKind.REVERSE,
    ActKind.ENTER,
    ActKind.GIVE_WAY,
}
MOST = 4
MISTAKEN = {
    "is_followed_and_brakes": "speed.tail",
    "ego_changes_lane_before_a_faster_one": "speed.fast",
    "ego_stops_then_sets_off": "act.goes.when",
}
"""Claims that ask too much: that who follows never reacts, and that who sets off stood from the
start."""


def proofs(functional, logical, concrete):
    """Every statement, judged on the simulated movements."""
    ways = ways_of(concrete, build_network(concrete.road))
    program, own = compile_program(concrete, paths_of(ways))
    traces = simulate_batch(program, own, duration_s=concrete.duration_s, dt_s=0.01)
    friction = friction_of(concrete.environment)
    everybody = list(combinations([entity.id for entity in concrete.entities], 2))
    scene = scene_of(concrete, paths_of(ways), everybody, friction)
    view = view_of(concrete, ways, scene, traces, friction)
    return prove(claims_of(functional, logical), view)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", sorted(SCENARIOS))
def test_all_that_is_said_holds(name, seed):
    functional = SCENARIOS[name]
    for logical in islice(enumerate_scenarios(functional).scenarios, MOST):
        concrete = concretize(functional, logical, seed=seed)
        missed = [
            f"{claim.id}: {claim.statement}: {claim.measured} {claim.unit} at {claim.time_s} s"
            for claim in proofs(functional, logical, concrete)
            if not claim.holds and claim.id != MISTAKEN.get(name)
        ]
        assert not missed, (logical.slug, missed)


def test_the_scenarios_cover_every_act_measure_moment_and_outcome():
    told = SCENARIOS.values()
    acts = {act.kind for functional in told for act in functional.acts}
    assert acts == set(ActKind) - AT_JUNCTIONS
    spacings = [spacing for functional in told for spacing in functional.spacings]
    assert {spacing.measure for spacing in spacings} == set(Measure)
    assert {"start", "contact"} < {spacing.at for spacing in spacings}
    outcomes = {functional.outcome.kind for functional in told if functional.outcome}
    assert outcomes == set(OutcomeKind)
    triggers = {act.when.type for functional in told for act in functional.acts if act.when}
    assert triggers == {"start", "after", "measure"}
