"""The same claims judge our own traces and a recording, and agree with whoever else measures."""

from pathlib import Path

import pytest
from saying import made
from sayings import BRAKES, CROSSES, EVERY, STANDS, WALKS

from scegen.benchmark.said import JUDGE_FILE, load_judge
from scegen.checking.environment import esmini
from scegen.checking.esmini.layout import simulated_csv
from scegen.checking.esmini.recording import read_recording
from scegen.checking.recording import Player, record
from scegen.checking.said import recorded_view
from scegen.claims import claims_of, prove
from scegen.pipeline.export import SCENARIO_FILE, export_scenario

SHARED = Path(__file__).parents[3] / "shared" / "descriptions"
MEASURED = {
    "brakes": (
        BRAKES,
        {
            "gap_m": "spacing.0",
            "deceleration_mps2": "act.brake.rate_mps2",
            "other_final_speed_kph": "act.brake.target_speed_mps",
        },
    ),
    "walks": (
        WALKS,
        {"impact_percent": "outcome.impact_percent", "other_speed_kph": "speed.walker"},
    ),
    "stands": (STANDS, {"overlap_percent": "spacing.0", "ego_speed_kph": "speed.ego"}),
}
FACTS = {
    "brakes": (BRAKES, {"approach": "ahead", "contact": False, "other_turn": "straight"}),
    "crosses": (CROSSES, {"approach": "left", "contact": False, "ego_turn": "straight"}),
    "walks": (WALKS, {"crosses_from": "right", "contact": True, "ego_struck": "front"}),
    "stands": (STANDS, {"approach": "ahead", "contact": True, "other_speed_kph": 0}),
}


def judged(functional, csv):
    concrete = made(functional).concrete
    view = recorded_view(concrete, read_recording(csv))
    return {c.id: c for c in prove(claims_of(functional, concrete.logical), view)}


@pytest.mark.parametrize("functional", EVERY, ids=lambda f: f.participants[1].id)
def test_a_recording_of_our_own_is_judged_as_the_traces_are(functional):
    result = made(functional)
    found = judged(functional, simulated_csv(result.concrete))
    assert {c.id: c.holds for c in result.proof.claims} == {n: c.holds for n, c in found.items()}


@pytest.mark.esmini
@pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")
@pytest.mark.parametrize("functional", EVERY, ids=lambda f: f.participants[1].id)
def test_esmini_shows_what_was_said(functional, tmp_path):
    for name, content in export_scenario(made(functional).concrete).items():
        (tmp_path / name).write_bytes(content)
    recorded = record(tmp_path / SCENARIO_FILE, made(functional).concrete)
    assert recorded.player is Player.ESMINI
    assert [c.statement for c in judged(functional, recorded.csv).values() if not c.holds] == []


@pytest.mark.skipif(not SHARED.exists(), reason="the judge does not lie beside the checkout")
@pytest.mark.parametrize("name", MEASURED)
def test_claims_measure_what_the_judge_measures(name, tmp_path):
    functional, pairs = MEASURED[name]
    csv = simulated_csv(made(functional).concrete)
    (tmp_path / "played.csv").write_text(csv)
    judge = load_judge(SHARED / JUDGE_FILE)
    ours = judged(functional, csv)
    facts = {fact: ours[claim].measured for fact, claim in pairs.items()}
    assert [
        fact for fact, *_, right in judge(facts, str(tmp_path / "played.csv")) if not right
    ] == []


@pytest.mark.skipif(not SHARED.exists(), reason="the judge does not lie beside the checkout")
@pytest.mark.parametrize("name", FACTS)
def test_what_claims_hold_to_be_true_is_true_for_the_judge(name, tmp_path):
    functional, facts = FACTS[name]
    (tmp_path / "played.csv").write_text(simulated_csv(made(functional).concrete))
    judge = load_judge(SHARED / JUDGE_FILE)
    assert [row for row in judge(facts, str(tmp_path / "played.csv")) if not row[3]] == []
