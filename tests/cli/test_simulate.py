"""scegen simulate: our own movements as a table, the same in every run."""

import csv
import io
import json
import shutil

import pytest

from scegen.motion import build_paths, simulate
from scegen.motion.traces import COLUMNS
from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, EgoMode, Options
from scegen.pipeline.source import resolve_source
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load

SENTENCE = "The ego turns left at a T-junction while a truck comes from the right."


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("made") / "out"
    generate(resolve_source(SENTENCE), folder, Options(depth=CheckDepth.NONE))
    return folder


def rows(text):
    return list(csv.DictReader(io.StringIO(text)))


def test_the_table_is_what_the_simulator_says(scegen, made):
    done = scegen("simulate", made, "--csv")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines()[0] == ",".join(COLUMNS) == "time,id,x,y,heading,speed"
    assert "-0.000000" not in done.stdout
    (file,) = made.glob("scenarios/*/concrete.yaml")
    concrete = load(file, ConcreteScenario)
    traces = simulate(concrete, build_paths(concrete, build_network(concrete.road)))
    found = rows(done.stdout)
    assert len(found) == sum(len(trace.time_s) for trace in traces.values())
    for name, trace in traces.items():
        own = [row for row in found if row["id"] == name]
        assert [float(r["time"]) for r in own] == pytest.approx(trace.time_s.tolist())
        for column, values in (
            ("x", trace.x_m),
            ("y", trace.y_m),
            ("heading", trace.heading_rad),
            ("speed", trace.speed_mps),
        ):
            assert [float(r[column]) for r in own] == pytest.approx(values.tolist(), abs=1e-6)


def test_folder_file_and_output_give_the_same_bytes(scegen, made, tmp_path):
    (folder,) = made.glob("scenarios/*")
    printed = scegen("simulate", folder, "--csv").stdout
    assert scegen("simulate", folder / "concrete.yaml").stdout == printed
    assert scegen("simulate", folder, "--csv", "-o", "trace.csv").stdout == ""
    assert (tmp_path / "trace.csv").read_text() == printed


def test_another_step(scegen, made):
    times = [float(row["time"]) for row in rows(scegen("simulate", made, "--dt", "0.5").stdout)]
    assert sorted(set(times))[:3] == [0.0, 0.5, 1.0]


@pytest.mark.parametrize("dt", ["0", "-1", "nan", "x"])
def test_steps_that_make_no_sense_are_refused(scegen, made, dt):
    done = scegen("simulate", made, "--dt", dt)
    assert (done.returncode, done.stdout) == (2, "")
    assert "Traceback" not in done.stderr


def test_nothing_to_simulate(scegen, tmp_path):
    (tmp_path / "empty").mkdir()
    for place in ("empty", "nowhere"):
        done = scegen("simulate", place)
        assert (done.returncode, done.stdout) == (2, "")
        assert place in done.stderr


@pytest.mark.esmini
@pytest.mark.skipif(shutil.which("esmini") is None, reason="esmini is not on PATH")
def test_check_can_replay(scegen, made):
    done = scegen("check", made, "--replay", "--require", "replay", "--json")
    assert done.returncode == 0, done.stderr
    (report,) = json.loads(done.stdout)
    assert report["results"][-1]["checker"] == "replay"
    assert report["results"][-1]["status"] == "passed"
    assert scegen("check", made, "--require", "replay").returncode == 2


def test_an_external_ego_reaches_the_files_and_the_checks(tmp_path):
    folder = tmp_path / "out"
    made = generate(resolve_source(SENTENCE), folder, Options(ego=EgoMode.EXTERNAL))
    assert made.ok, made.checks
    (file,) = folder.glob("scenarios/*/scenario.xosc")
    assert 'name="driven_by" value="external"' in file.read_text()
