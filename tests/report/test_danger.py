"""The report says of every danger and every measure what was and what is."""

from scegen.report.danger import danger_tables, target_words
from scegen.scenario.concrete import Change, Rejected
from scegen.scenario.proof import Advice, HazardProof, MeasureProof, PartProof, Proof
from scegen.scenario.vocabulary import HazardKind


def hazard(*, happened, value):
    return HazardProof(
        kind=HazardKind.CUT_IN,
        by=("car_1",),
        to=("ego",),
        happened=happened,
        margin=1.0 - value,
        unit="s",
        threshold=1.0,
        time_s=3.5,
        parts=(PartProof(name="gap", value=value, threshold=1.0, unit="s", happened=happened),),
    )


def proof(**more):
    values = {
        "target": "near-miss",
        "in_band": True,
        "in_band_before": False,
        "measure": "pet",
        "band": (0.2, 1.0),
        "pair": ("car_1", "ego"),
        "measures": (
            MeasureProof(name="pet", unit="s", before=-0.5, after=0.4),
            MeasureProof(name="drac", unit="m/s2", before=None, after=None),
        ),
        "hazards": (hazard(happened=True, value=0.3),),
        "hazards_before": (hazard(happened=False, value=1.7),),
        "changed": True,
    }
    return Proof(**{**values, **more})


def test_no_search_no_tables():
    assert danger_tables(None) == []


def test_before_and_after():
    target, dangers = danger_tables(proof())
    assert "near-miss between car_1 and ego: reached" in target.title
    assert target_words(proof()) == "near-miss of car_1 and ego: post-encroachment time 0.40 s"
    assert "not reached" in target_words(proof(in_band=False))
    assert target.rows == (("post-encroachment time (decides)", "-0.50 s", "0.40 s", "0.2 to 1"),)
    (row,) = dangers.rows
    assert row[:6] == ("cut in", "car_1", "ego", "did not happen", "happens", "0.70 s")
    assert "gap 0.30 s (threshold 1)" in row[-1]


def test_a_failure_is_loud_and_says_why():
    failed = proof(
        in_band=False,
        changed=False,
        blocked_by="their paths never meet",
        hazards=(hazard(happened=False, value=1.7),),
    )
    target, dangers = danger_tables(failed)
    assert "NOT reached" in target.title
    assert "their paths never meet" in target.title
    assert "NOT" in dangers.rows[0][4]


def advice(**more):
    rejected = Rejected(by="openai:x", value="500", why="lies outside 0 to 60 m/s")
    changes = (
        Change(parameter="car_1.start_m", by="openai:x", before=10, after=12.5, reason="earlier"),
        Change(parameter="car_1.speed_mps", by="validator", reason="left", rejected=rejected),
    )
    return Advice(**{"speaker": "openai:x", "led": True, "changes": changes, **more})


def test_proposals_with_who_and_why_and_what_was_rejected():
    *_, proposed = danger_tables(proof(advice=advice()))
    assert proposed.title == "Numbers proposed by openai:x: the search went on from there"
    assert proposed.rows == (
        ("car_1.start_m", "10", "12.5", "openai:x", "earlier", ""),
        ("car_1.speed_mps", "–", "–", "validator", "left", "500: lies outside 0 to 60 m/s"),
    )


def test_proposals_that_did_not_help_and_why_others_are_silent():
    *_, proposed = danger_tables(proof(advice=advice(led=False)))
    assert "its own way" in proposed.title
    told = advice(led=False, changes=(), speaker="offline rules", notes=("openai:x: no answer",))
    *_, proposed = danger_tables(proof(advice=told))
    assert proposed.title == "Numbers proposed by offline rules: none"
    assert proposed.rows[0][4] == "openai:x: no answer"
