"""Reversing as a search sees it: velocities, conflict areas, and dangers that happen."""

from __future__ import annotations

import numpy as np
import pytest

from scegen.claims.ways import paths_of, ways_of
from scegen.concretization import concretize
from scegen.criticality.raising.raising import raise_criticality
from scegen.criticality.reactivity.sensitivity import ego_start_sensitivity
from scegen.enumeration import enumerate_scenarios
from scegen.measures.conflict_areas import area_table
from scegen.measures.tables import build_tables
from scegen.motion.model import Path
from scegen.road import build_network
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.logical import Reverses
from scegen.scenario.vocabulary import Approach, HazardKind, JunctionKind, ParticipantKind, Role


def described(kind, arms, approaches=(), extra=()):
    hazards = [Hazard(kind=HazardKind.REVERSING, by=("van",), to=("ego",))]
    hazards += [Hazard(kind=HazardKind(k), by=("van",), to=("ego",)) for k in extra]
    return FunctionalScenario(
        description="for tests",
        junction=Junction(kind=JunctionKind(kind), arms=arms),
        participants=(
            Participant(
                id="van", kind=ParticipantKind.VAN, approaches=frozenset(map(Approach, approaches))
            ),
            Participant(id="ego", role=Role.EGO),
        ),
        hazards=tuple(hazards),
    )


def first(functional, how, seed=0):
    for logical in enumerate_scenarios(functional).scenarios:
        if logical.assignment("van").reverses is how:
            return concretize(functional, logical, seed=seed)
    raise AssertionError(how)


CASES = {
    "ahead": (described("straight", 2, ["ahead"]), Reverses.BACKS_UP),
    "right": (described("straight", 2), Reverses.FROM_RIGHT),
    "left": (described("straight", 2, ["left"]), Reverses.FROM_LEFT),
    "arm": (described("t", 3), Reverses.OUT_OF_ARM),
    "crossing": (described("four_way", 4, ["right"], ["stopping"]), Reverses.BACKS_UP),
    "red": (described("four_way", 4, ["left"], ["red_light_running"]), Reverses.BACKS_UP),
}


@pytest.mark.parametrize("target", ["near-miss", "collision"])
@pytest.mark.parametrize("case", sorted(CASES))
def test_it_is_raised_and_every_danger_happens(case, target):
    functional, how = CASES[case]
    concrete = first(functional, how)
    raised = raise_criticality(functional, concrete, target=target)
    assert raised.proof.in_band, raised.proof.blocked_by
    assert all(hazard.happened for hazard in raised.proof.hazards)
    assert not raised.proof.unwanted_contacts
    # Where and how it goes back is fixed: only when it does, and what the other does, may vary.
    was, now = concrete.participant("van"), raised.concrete.participant("van")
    assert now.motion == was.motion
    assert now.speed_mps == was.speed_mps


@pytest.mark.parametrize("case", sorted(CASES))
def test_it_waits_for_a_slower_or_faster_ego(case):
    functional, how = CASES[case]
    # With other seeds it is not to be had for every case.
    concrete = raise_criticality(functional, first(functional, how, seed=2)).concrete
    paths = paths_of(ways_of(concrete, build_network(concrete.road)))
    found = ego_start_sensitivity(concrete, paths)
    assert found.own.critical
    assert found.reactive


def straight(x0, x1):
    """Along the x-axis, heading east, whichever way it goes."""
    x = np.linspace(x0, x1, 30)
    return Path(np.abs(x - x0), x, np.zeros(30), np.zeros(30), ())


def test_one_that_comes_backwards_is_no_merge():
    """The van backs round a corner into the lane and drives on; the ego comes along the lane."""
    functional, how = CASES["right"]
    concrete = first(functional, how)
    ways = ways_of(concrete, build_network(concrete.road))
    bodies = [p.body for p in concrete.participants]
    paths = [ways[p.id].path for p in concrete.participants]
    scene = build_tables(paths, bodies)
    assert area_table(paths, scene.bodies, [(0, 1)]).first.tolist() == [0, 0]
    assert (scene.following.first >= 0).any()


def test_backwards_is_where_the_way_goes_against_the_heading():
    assert straight(0.0, 20.0).backwards == ()
    ((begins, ends),) = straight(20.0, 0.0).backwards
    assert (begins, ends) == (0.0, pytest.approx(20.0))
