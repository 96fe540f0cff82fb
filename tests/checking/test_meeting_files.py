"""What those who are to meet are written to passes all own checks, and esmini plays it alike."""

import pytest
from meetings import MEETINGS
from told import made

from scegen.checking import REPLAY, CheckStatus, check_folder
from scegen.checking.environment import esmini
from scegen.export.opendrive import write_opendrive
from scegen.export.openscenario import write_openscenario
from scegen.motion import build_paths
from scegen.road import build_network
from scegen.scenario.files import to_yaml

CHECKED = ("opendrive", "openscenario", "schema")


def written(folder, concrete):
    network = build_network(concrete.road, concrete.name)
    paths = build_paths(concrete, network)
    road = write_opendrive(network, controlled_arms=concrete.road.controlled_arms)
    (folder / "road.xodr").write_text(road)
    (folder / "scenario.xosc").write_bytes(write_openscenario(concrete, paths))
    (folder / "concrete.yaml").write_text(to_yaml(concrete))
    return folder


@pytest.mark.esmini
@pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")
@pytest.mark.parametrize("name", sorted(MEETINGS))
def test_files_are_clean_and_play_as_simulated(tmp_path, name):
    folder = written(tmp_path, made(MEETINGS[name])[0])
    report = check_folder(folder, (*CHECKED, "esmini", REPLAY))
    found = {result.checker: result for result in report.results}
    assert set(found) == {*CHECKED, "esmini", REPLAY}
    for result in found.values():
        assert (result.status, result.findings) == (CheckStatus.PASSED, ()), result.checker
