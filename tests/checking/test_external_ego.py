"""An ego that is driven from outside: the checks know it, and nothing else passes for one."""

import pytest

from scegen.checking import REPLAY, CheckStatus, check_folder
from scegen.checking.environment import esmini
from scegen.export.openscenario import write_openscenario
from scegen.motion import build_paths
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load

MARK = b'<Property name="driven_by" value="external" />'


@pytest.fixture
def external(folder):
    """The folder, with the ego left to somebody else."""
    concrete = load(folder / "concrete.yaml", ConcreteScenario)
    paths = build_paths(concrete, build_network(concrete.road, concrete.name))
    written = write_openscenario(concrete, paths, external_ego=True)
    assert written.count(MARK) == 1
    (folder / "scenario.xosc").write_bytes(written)
    return folder


def test_own_rules_pass_without_a_way(external):
    result = check_folder(external, ["openscenario"]).result("openscenario")
    assert result.status is CheckStatus.PASSED, result.findings


def test_without_the_mark_a_way_is_missing(external):
    file = external / "scenario.xosc"
    file.write_bytes(file.read_bytes().replace(MARK, b""))
    result = check_folder(external, ["openscenario"]).result("openscenario")
    assert {finding.rule for finding in result.errors} == {"xosc.missing_trajectory"}


def test_the_mark_on_an_ego_with_a_way_is_an_error(folder):
    file = folder / "scenario.xosc"
    ego = b'<Property name="type" value="ego_vehicle" />'
    assert ego in file.read_bytes()
    file.write_bytes(file.read_bytes().replace(ego, ego + MARK))
    result = check_folder(folder, ["openscenario"]).result("openscenario")
    assert {finding.rule for finding in result.errors} == {"xosc.external"}


@pytest.mark.esmini
@pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")
def test_esmini_plays_it_and_nothing_is_predicted(external):
    report = check_folder(external, ["esmini", REPLAY])
    assert report.result("esmini").status is CheckStatus.PASSED, report.result("esmini").findings
    replayed = report.result(REPLAY)
    assert (replayed.status, "outside" in replayed.detail) == (CheckStatus.NOT_RUN, True)
