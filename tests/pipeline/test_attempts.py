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
    options = {"target": "near-miss"} | options
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
    options = Options(pick="0,1", target="near-miss")
    made = make_some(FUNCTIONAL, PICKED[:2], "near-miss", options, lambda _: None)
    assert len(made.proofs) == 2
    assert made.skipped == {}


def test_another_scenario_that_allows_of_a_near_miss_comes_before_a_collision(outcomes):
    outcomes += [proof(holds=False), proof(holds=True)]
    made = make(target=None)
    assert outcomes == []
    assert len(made.skipped) == 1
    assert not any("a near miss" in name for name in made.skipped)


def test_who_cannot_be_missed_is_hit_if_nobody_asked_for_a_near_miss(outcomes):
    unhurt = proof(holds=False)
    outcomes += [proof(holds=False)] * (attempts.MOST_SPARE + 1) + [unhurt, proof(holds=True)]
    made = make(target=None)
    ((name, taken),) = made.proofs.items()
    assert outcomes == []
    assert not taken.missed
    assert "does not hold" in made.skipped[f"{name}, a near miss"]


def test_what_is_said_may_allow_of_no_danger_if_nobody_asked_for_one(outcomes):
    near = [proof(holds=False)] * attempts.MOST_SPARE + [proof(holds=True, in_band=False)]
    outcomes += [*near, proof(holds=True)]
    made = make(target=None)
    ((name, taken),) = made.proofs.items()
    assert outcomes == []
    assert (taken.missed, taken.in_band) == ((), True)
    assert "the target is not reached" in made.skipped[f"{name}, a near miss"]


def test_where_they_cannot_touch_either_the_near_miss_is_told(outcomes):
    tried = attempts.MOST_SPARE + 1
    outcomes += [proof(holds=False)] * tried + [proof(holds=True, in_band=False)] * 2 * tried
    made = make(target=None)
    ((_, taken),) = made.proofs.items()
    assert taken.missed
    assert not any("a near miss" in name for name in made.skipped)


@pytest.mark.parametrize(
    "text",
    [
        "A coach is parked on the hard shoulder of the motorway as the ego drives by.",
        "At 60 km/h the lead car stops with 5 m/s², 2 s ahead; after 1 s the ego brakes as hard.",
    ],
)
def test_what_is_harmless(text):
    functional = read(text)
    picked = enumerate_scenarios(functional).scenarios
    made = make_some(functional, picked, "near-miss", Options(), lambda _: None)
    ((_, taken),) = made.proofs.items()
    assert not taken.missed
    assert (taken.target, taken.in_band) == ("avoided", True)


@pytest.mark.parametrize("text", [
    "A pedestrian steps onto the road from the right 30 m ahead of the ego, which drives 80 km/h.",
    "A lorry ahead brakes with 9 m/s² to a stop; the ego follows 10 m behind at 90 km/h.",
])  # fmt: skip
def test_what_cannot_be_missed(text):
    functional = read(text)
    picked = enumerate_scenarios(functional).scenarios
    made = make_some(functional, picked, "near-miss", Options(), lambda _: None)
    ((name, taken),) = made.proofs.items()
    assert not taken.missed
    assert taken.target == "collision"
    assert any(skipped.startswith(name) for skipped in made.skipped)
