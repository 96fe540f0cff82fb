"""ASAM's rules: all of them completed, on twins where the version leaves some out."""

from __future__ import annotations

import re

import pytest
from lxml import etree

from scegen.checking import CheckStatus, Severity, check_files, check_folder
from scegen.checking.asam import Job, run_asam
from scegen.checking.asam.xqar import RuleOutcome, merged
from scegen.checking.environment import asam_python
from scegen.export.openscenario import write_openscenario
from scegen.motion import build_paths
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load

needs_asam = pytest.mark.skipif(
    asam_python() is None, reason="the ASAM checkers are not installed; run: make asam"
)
ASAM = ("asam-opendrive", "asam-openscenario")


@pytest.mark.asam
@needs_asam
def test_every_rule_completes_on_a_good_folder(folder):
    report = check_folder(folder, ASAM)
    assert [(r.status, r.findings) for r in report.results] == [(CheckStatus.PASSED, ())] * 2
    details = [result.detail for result in report.results]
    assert details == ["23 of 23 rules completed", "17 of 17 rules completed, on the 1.2 twin"]


@pytest.mark.asam
@needs_asam
def test_edited_scenario_has_no_twin(folder):
    """What concrete.yaml gives no longer speaks for the file: 12 rules did not look at it."""
    path = folder / "scenario.xosc"
    path.write_bytes(path.read_bytes() + b"<!-- edited by hand -->\n")
    result = check_folder(folder, ASAM).result("asam-openscenario")
    assert result.status is CheckStatus.NOT_RUN
    assert result.detail.startswith("5 of 17 rules completed, scenario.xosc is not what")
    assert len(result.findings) == 12
    assert {finding.severity for finding in result.findings} == {Severity.UNCHECKED}


@pytest.mark.asam
@needs_asam
def test_scenario_written_as_1_2_speaks_for_itself(folder):
    concrete = load(folder / "concrete.yaml", ConcreteScenario)
    paths = build_paths(concrete, build_network(concrete.road))
    (folder / "scenario.xosc").write_bytes(write_openscenario(concrete, paths, version="1.2"))
    result = check_folder(folder, ASAM).result("asam-openscenario")
    assert (result.status, result.detail) == (CheckStatus.PASSED, "17 of 17 rules completed")


@pytest.mark.asam
@needs_asam
def test_foreign_scenario_below_1_2_is_no_pass(folder):
    (folder / "concrete.yaml").unlink()
    assert check_folder(folder, ASAM).result("asam-openscenario").status is CheckStatus.NOT_RUN


@pytest.mark.asam
@needs_asam
def test_concrete_scenario_that_cannot_be_built(folder):
    path = folder / "concrete.yaml"
    path.write_text(re.sub(r"\blength_m: [\d.]+", "length_m: 1.0", path.read_text()))
    result = check_folder(folder, ASAM).result("asam-openscenario")
    assert [finding.rule for finding in result.findings] == ["asam.twin"]


@pytest.mark.asam
@needs_asam
def test_skipped_rules_fail(folder):
    """Of an OpenDRIVE 1.4 file ASAM's checker skips most rules and ends with 0."""
    content = (folder / "road.xodr").read_bytes().replace(b'revMinor="7"', b'revMinor="4"')
    [[result]] = run_asam([Job(road=content)])
    assert result.status is not CheckStatus.PASSED
    assert len(result.findings) > 5


@pytest.mark.asam
@needs_asam
def test_what_asam_finds_is_reported(folder):
    root = etree.parse(folder / "road.xodr").getroot()
    lane = next(lane for lane in root.iter("lane") if lane.get("id") == "-1")
    lane.set("level", "perhaps")
    (folder / "road.xodr").write_bytes(etree.tostring(root))
    result = check_folder(folder, ASAM).result("asam-opendrive")
    assert result.status is CheckStatus.FAILED
    assert any("schema" in finding.rule for finding in result.findings)


@pytest.mark.asam
@needs_asam
def test_many_files_in_one_process(folder):
    content = (folder / "road.xodr").read_bytes()
    ran = run_asam([Job(road=content), Job(road=b"<OpenDRIVE/>"), Job(road=content)])
    assert [r.status for [r] in ran] == [
        CheckStatus.PASSED,
        CheckStatus.FAILED,
        CheckStatus.PASSED,
    ]


@pytest.mark.asam
@needs_asam
def test_schema(folder):
    assert check_folder(folder, ["schema"]).result("schema").findings == ()
    root = etree.parse(folder / "scenario.xosc").getroot()
    vertex = root.find(".//Vertex")
    del vertex.attrib["time"]
    (folder / "scenario.xosc").write_bytes(etree.tostring(root))
    result = check_folder(folder, ["schema"]).result("schema")
    assert result.status is CheckStatus.FAILED
    assert result.findings[0].place.startswith("scenario.xosc:")
    assert "time" in result.findings[0].message


@pytest.mark.asam
@needs_asam
def test_version_without_a_schema(folder):
    path = folder / "road.xodr"
    path.write_bytes(path.read_bytes().replace(b'revMinor="7"', b'revMinor="9"'))
    findings = check_folder(folder, ["schema"]).result("schema").findings
    assert [(f.rule, f.severity) for f in findings] == [("xsd.version", Severity.UNCHECKED)]


def test_without_the_environment(folder, monkeypatch, tmp_path):
    monkeypatch.setenv("SCEGEN_ASAM_PYTHON", str(tmp_path / "none"))
    report = check_folder(folder, ["schema", *ASAM])
    assert {result.status for result in report.results} == {CheckStatus.NOT_RUN}
    assert all("make asam" in result.detail for result in report.results)
    assert len(report.results) == 3


@pytest.mark.parametrize("content", [b"<!DOCTYPE a []><OpenDRIVE/>", b"<broken"])
def test_untrusted_files_are_not_handed_on(folder, content):
    (folder / "road.xodr").write_bytes(content)
    report = check_folder(folder)
    assert report.result("opendrive").status is CheckStatus.FAILED
    for checker in ("asam-opendrive", "esmini"):
        assert report.result(checker).status is CheckStatus.NOT_RUN


def outcome(rule, status, summary=""):
    return RuleOutcome(rule, status, summary, ())


def test_only_rules_for_another_version_come_from_the_twin():
    late = "Version 1.7.0 is not valid according to definition setting >=1.8.0. Skip the check."
    first = {
        "a": outcome("a", "completed"),
        "b": outcome("b", "skipped", late),
        "c": outcome("c", "skipped", "Preconditions are not satisfied. Skip the check."),
    }
    second = {name: outcome(name, "completed", "twin") for name in first}
    assert [o.status for o in merged(first, second)] == ["completed", "completed", "skipped"]
    assert [o.findings() != () for o in merged(first, {})] == [False, True, True]
    assert merged(first, {})[1].findings()[0].severity is Severity.UNCHECKED
    assert merged(first, {})[2].findings()[0].severity is Severity.ERROR


def test_single_road_file(folder):
    [report] = check_files([folder / "road.xodr"], ASAM)
    assert [result.checker for result in report.results] == ["asam-opendrive"]
