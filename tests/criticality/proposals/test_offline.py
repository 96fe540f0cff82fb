"""The offline rules: valid, without chance, a help to the search and never a harm."""

from types import SimpleNamespace

import pytest

from scegen.concretization import concretize
from scegen.criticality import OfflineProposer, raise_criticality
from scegen.criticality.proposals.offline import OFFLINE
from scegen.criticality.proposals.proposal import Proposal
from scegen.enumeration import enumerate_scenarios
from scegen.pipeline.picking import pick
from scegen.scenario.vocabulary import HazardKind
from scegen.understanding import paper_cases, read


@pytest.mark.parametrize("name", ["two cars", "walker", "queue"])
def test_rules_propose_only_what_is_valid_and_always_the_same(ready, name):
    first, second = (ready[name].advise(OfflineProposer(), seed) for seed in (0, 1))
    assert first.advice == second.advice
    assert first.advice.speaker == OFFLINE
    assert all(change.rejected is None for change in first.advice.changes)


def test_the_pair_is_brought_to_the_gap_of_the_target(ready):
    search = ready["two cars"]
    result = search.advise(OfflineProposer())
    assert all("0.60 s after" in change.reason for change in result.advice.changes)
    evidence = search.examine(result.concrete)
    pet = evidence.view.of_pair("pet_s", *search.stage.pair)[0]
    assert pet == pytest.approx(0.6, abs=0.1)


def test_another_target_another_gap(ready_for):
    search = ready_for("Two cars meet at a four-way intersection.", "pet=1.2..1.8")
    result = search.advise(OfflineProposer())
    evidence = search.examine(result.concrete)
    assert evidence.view.of_pair("pet_s", *search.stage.pair)[0] == pytest.approx(1.5, abs=0.1)


def test_a_danger_that_lacks_something_gets_more_of_it(ready):
    search = ready["two cars"]
    hazards = search.before.hazards
    speeding = next(h for h in hazards if h.kind is HazardKind.SPEEDING)
    short = speeding.model_copy(update={"happened": False, "margin": -1.5, "by": ("car_1",)})
    before = search.before
    try:
        search.before = SimpleNamespace(hazards=(short,))
        changes = search.advise(OfflineProposer()).advice.changes
    finally:
        search.before = before
    quicker = next(c for c in changes if c.parameter == "car_1.speed_mps")
    assert quicker.after > quicker.before
    assert quicker.reason == "speeding by car_1 is 1.50 m/s short"


LONGEST_LEAD = 250


def made(text, which=0):
    functional = read(text)
    logical = enumerate_scenarios(functional)
    return functional, concretize(functional, pick(logical, None)[which], seed=0)


@pytest.mark.parametrize("case", paper_cases(), ids=lambda case: case.id)
def test_what_is_found_without_proposals_is_found_with_them(case):
    functional, concrete = made(case.text)
    plain = raise_criticality(functional, concrete).proof
    advised = raise_criticality(functional, concrete, proposer=OfflineProposer())
    assert plain.reached <= advised.proof.reached
    if advised.proof.advice is None:
        assert plain.in_band_before
    elif advised.proof.advice.led:
        # Where a statement cannot hold, either search does its utmost; a lead is never looked
        # around for long, even where a change or two of many would have done.
        assert plain.missed or advised.proof.evaluations < max(plain.evaluations, LONGEST_LEAD)
        assert any(c.by == OFFLINE for c in advised.concrete.provenance)
    else:
        assert not any(c.by == OFFLINE for c in advised.concrete.provenance)


def test_bad_advice_does_no_harm(says):
    functional, concrete = made(paper_cases()[1].text)
    plain = raise_criticality(functional, concrete)
    asked = says()
    raise_criticality(functional, concrete, proposer=asked)
    worst = [
        Proposal(parameter=p.name, value=p.low, reason="against the grain")
        for p in asked.situation.parameters
    ]
    harmed = raise_criticality(functional, concrete, proposer=says(*worst))
    assert plain.proof.reached
    assert harmed.proof.reached
    if not harmed.proof.advice.led:
        assert harmed.concrete == plain.concrete


def test_without_advice_the_search_is_as_it_was(says):
    functional, concrete = made(paper_cases()[6].text)
    plain = raise_criticality(functional, concrete)
    silent = raise_criticality(functional, concrete, proposer=says())
    assert silent.concrete == plain.concrete
    assert silent.proof.evaluations == plain.proof.evaluations
    assert silent.proof.advice.speaker == "somebody"


def test_nobody_is_asked_where_nothing_has_to_change(says):
    functional, concrete = made(paper_cases()[3].text)
    asked = says()
    raised = raise_criticality(functional, concrete, proposer=asked)
    assert raised.proof.in_band_before
    assert asked.situation is None
    assert raised.proof.advice is None
