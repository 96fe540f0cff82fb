"""The report says of every danger and every measure what was and what is."""

from scegen.report.danger import danger_tables
from scegen.scenario.proof import HazardProof, MeasureProof, PartProof, Proof
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
