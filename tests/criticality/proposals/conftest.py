"""Searches that are ready to be advised, of sentences with different dangers."""

from dataclasses import dataclass
from typing import Any

import pytest

from scegen.concretization import concretize
from scegen.criticality.proposals.advising import advised
from scegen.criticality.proposals.proposal import Proposed
from scegen.criticality.raising.stage import Stage
from scegen.criticality.search.proving import examine
from scegen.criticality.target import parse_target
from scegen.enumeration import enumerate_scenarios
from scegen.pipeline.picking import pick
from scegen.road import build_network
from scegen.understanding import read

SENTENCES = {
    "two cars": "Two speeding vehicles approach a T-intersection simultaneously from opposite "
    "directions, one trying to make an unprotected left turn.",
    "walker": "A vehicle tailgating another car at a four-way stop, leading to a sudden braking "
    "event as a pedestrian steps into the crosswalk.",
    "queue": "Three cars approach a four-way intersection one behind the other while a truck "
    "crosses.",
}


class Says:
    """Proposes always the same, and remembers what it saw."""

    def __init__(self, *proposals, speaker="somebody"):
        self.proposed = Proposed(speaker, tuple(proposals))
        self.situation = self.judged = None

    def propose(self, situation, check):
        self.situation = situation
        self.judged = check(self.proposed.proposals)
        return self.proposed


@dataclass
class Ready:
    """A search before its start."""

    functional: Any
    concrete: Any
    stage: Any
    problem: Any
    before: Any

    def advise(self, proposer, seed=0):
        hazards = self.before.hazards
        return advised(proposer, self.problem, self.concrete, self.stage.ways, hazards, seed=seed)

    def situation(self):
        says = Says()
        self.advise(says)
        return says.situation

    def examine(self, concrete):
        return examine(concrete, self.stage.network, self.stage.focus, self.stage.friction)


def make(sentence, target="near-miss"):
    functional = read(sentence)
    logical = enumerate_scenarios(functional)
    concrete = concretize(functional, pick(logical, None)[0], seed=0)
    network = build_network(concrete.road)
    stage = Stage(functional, concrete, network, parse_target(target))
    before = examine(concrete, network, stage.focus, stage.friction)
    return Ready(functional, concrete, stage, stage.problem(), before)


@pytest.fixture(scope="session")
def ready():
    """Searches by name."""
    return {name: make(sentence) for name, sentence in SENTENCES.items()}


@pytest.fixture(scope="session")
def says():
    return Says


@pytest.fixture(scope="session")
def ready_for():
    """Makes a search for a sentence and a target."""
    return make
