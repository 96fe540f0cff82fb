"""Other logical scenarios are tried before one in which something said does not hold."""

import pytest

from scegen.enumeration import enumerate_scenarios
from scegen.pipeline import attempts
from scegen.pipeline.attempts import make_some
from scegen.pipeline.options import Options
from scegen.pipeline.raising import Raising
from scegen.scenario.proof import ClaimProof, Proof
from scegen.understanding import read

FUNCTIONAL = read("Two cars meet at a four-way intersection.")
PICKED = enumerate_scenarios(FUNCTIONAL).scenarios


def proof(*, holds, in_band=True):
    claim = ClaimProof(
        id="speed.ego", kind="speed", statement="ego drives 50 km/h", field="x", holds=holds
    )
    return Proof(target="near-miss", in_band=in_band, in_band_before=False, claims=(claim,))


@pytest.fixture
def outcomes(monkeypatch):
    """What becomes of one scenario after the other."""
    coming = []

    def raised(functional, concrete, *_, **__):
        return Raising([concrete], {concrete.name: coming.pop(0)})

    monkeypatch.setattr(attempts, "raise_danger", raised)
    return coming


def make(**options):
    return make_some(FUNCTIONAL, PICKED, "near-miss", Options(**options), lambda _: None)


def test_the_first_in_which_all_holds_is_taken_and_the_rest_is_told(outcomes):
    outcomes += [proof(holds=False), proof(holds=True, in_band=False), proof(holds=True)]
    made = make()
    assert outcomes == []
    (name,) = made.proofs
    assert made.proofs[name].in_band
    assert len(made.skipped) == 2
    told = " ".join(made.skipped.values())
    assert "1 of 1 statement does not hold (ego drives 50 km/h)" in told
    assert "the target is not reached" in told


def test_without_any_that_is_right_the_best_is_taken(outcomes):
    outcomes += [proof(holds=False)] * 3 + [proof(holds=True, in_band=False)]
    outcomes += [proof(holds=False)] * (attempts.MOST_SPARE + 1 - 4)
    made = make()
    ((_, taken),) = made.proofs.items()
    assert not taken.missed


def test_what_is_picked_is_made_whatever_comes_of_it(outcomes):
    outcomes += [proof(holds=False), proof(holds=True)]
    made = make_some(FUNCTIONAL, PICKED[:2], "near-miss", Options(pick="0,1"), lambda _: None)
    assert len(made.proofs) == 2
    assert made.skipped == {}
