"""Our own simulation, written as esmini writes its log, is read like esmini's."""

import numpy as np
import pytest

from scegen.checking import recording
from scegen.checking.environment import esmini
from scegen.checking.esmini.recording import read_recording
from scegen.checking.recording import Player, record
from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.pipeline.export import SCENARIO_FILE, export_scenario
from scegen.understanding import read

TEXT = "The ego goes straight on at a crossing. A pedestrian steps out behind a parked van."


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    listed = enumerate_scenarios(read(TEXT))
    concrete = concretize(listed.functional, listed.scenarios[0])
    path = tmp_path_factory.mktemp("made")
    for name, content in export_scenario(concrete).items():
        (path / name).write_bytes(content)
    return concrete, path / SCENARIO_FILE


def _own(concrete, file, monkeypatch):
    monkeypatch.setattr(recording, "esmini", lambda: None)
    return record(file, concrete)


def test_without_esmini_our_own_simulation_speaks_for_the_files(folder, monkeypatch):
    concrete, file = folder
    recorded = _own(concrete, file, monkeypatch)
    assert recorded.player is Player.OWN
    movements = read_recording(recorded.csv)
    assert [m.entity for m in movements] == [e.id for e in concrete.entities]
    assert movements[0].time_s[-1] == pytest.approx(concrete.duration_s, abs=0.05)


@pytest.mark.esmini
@pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")
def test_both_players_show_the_same(folder, monkeypatch):
    concrete, file = folder
    played = record(file, concrete)
    assert played.player is Player.ESMINI
    theirs = {m.entity: m for m in read_recording(played.csv)}
    for ours in read_recording(_own(concrete, file, monkeypatch).csv):
        steps = min(len(ours.point), len(theirs[ours.entity].point))
        off = np.abs(ours.point[:steps] - theirs[ours.entity].point[:steps])
        assert np.percentile(off, 95) < 0.05
