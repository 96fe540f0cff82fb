import json

import pytest

from scegen.errors import NotTrafficError
from scegen.understanding import Standing, parse_report, read, report_on

TEXT = "In rain a purplish van turns left at a crossroads; several buses wait in snow."


def test_every_finding_has_its_standing_and_its_words():
    report = parse_report(TEXT)
    for finding in report.findings:
        if finding.start is not None:
            assert report.text[finding.start : finding.end] == finding.words
        else:
            assert finding.reason
    assert {f.field: f.value for f in report.of(Standing.UNDERSTOOD)}["environment.weather"] == (
        "rain"
    )
    assert [f.words for f in report.of(Standing.UNSUPPORTED)] == ["purplish", "wait"]
    assert [f.words for f in report.of(Standing.CONTRADICTED)] == ["snow"]
    assert any(f.words == "several buses" for f in report.of(Standing.INFERRED))
    assert "junction.driving_side" in {f.field for f in report.of(Standing.ASSUMED)}


def test_the_findings_are_all_evidence_and_all_that_is_left_out():
    scenario = read(TEXT)
    report = report_on(scenario)
    assert len(report.findings) == len(scenario.evidence) + len(scenario.unsupported)
    order = [list(Standing).index(f.standing) for f in report.findings]
    assert order == sorted(order)


def test_values_are_those_of_the_scenario():
    report = parse_report("The ego turns left at a crossroads at 36 km/h; a van brakes hard.")
    values = {f.field: f.value for f in report.findings}
    assert values["junction.kind"] == "four_way"
    assert values["junction.arms"] == "4"
    assert values["participants.ego.maneuvers"] == "left"
    assert values["participants.ego.speed_mps"] == "10.0 m/s"
    assert values["hazards.hard_braking"] == "van_1"
    assert "hazards.hard_braking.to" not in values  # left to each logical scenario


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("The ego turns left and the ego turns right.", {"turns left", "turns right"}),
        ("A T-intersection with five arms.", {"T intersection", "five arms"}),
    ],
)
def test_contradictions_are_findings(text, words):
    found = parse_report(text).of(Standing.CONTRADICTED)
    assert found
    assert {f.words for f in found} & words
    assert all(f.reason for f in found)


def test_other_subjects_stay_an_error():
    with pytest.raises(NotTrafficError):
        parse_report("The cat sleeps on the sofa.")


def test_the_report_is_data():
    data = parse_report(TEXT).to_data()
    assert json.loads(json.dumps(data)) == data
    assert data["counts"]["contradicted"] == 1
    assert sum(data["counts"].values()) == len(data["findings"])


def test_somebody_else_may_read():
    report = parse_report("whatever", lambda _: read("A van turns left."))
    assert report.text == "A van turns left."
