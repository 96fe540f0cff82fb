"""scegen trace: movements as a table or for a viewer, the same in every run."""

import csv
import io
import json
import shutil
import sys
from math import hypot

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
    done = scegen("trace", made, "--csv")
    assert (done.returncode, done.stderr) == (0, "")
    assert (
        done.stdout.splitlines()[0]
        == ",".join(COLUMNS)
        == "time_s,id,x_m,y_m,heading_rad,speed_mps"
    )
    assert "-0.000000" not in done.stdout
    (file,) = made.glob("scenarios/*/concrete.yaml")
    concrete = load(file, ConcreteScenario)
    traces = simulate(concrete, build_paths(concrete, build_network(concrete.road)))
    found = rows(done.stdout)
    assert len(found) == sum(len(trace.time_s) for trace in traces.values())
    for name, trace in traces.items():
        own = [row for row in found if row["id"] == name]
        assert [float(r["time_s"]) for r in own] == pytest.approx(trace.time_s.tolist())
        for column, values in (
            ("x_m", trace.x_m),
            ("y_m", trace.y_m),
            ("heading_rad", trace.heading_rad),
            ("speed_mps", trace.speed_mps),
        ):
            assert [float(r[column]) for r in own] == pytest.approx(values.tolist(), abs=1e-6)


def test_folder_file_and_output_give_the_same_bytes(scegen, made, tmp_path):
    (folder,) = made.glob("scenarios/*")
    printed = scegen("trace", folder, "--csv").stdout
    assert scegen("trace", folder / "concrete.yaml").stdout == printed
    assert scegen("trace", folder, "--csv", "-o", "trace.csv").stdout == ""
    assert (tmp_path / "trace.csv").read_text() == printed


def test_another_step(scegen, made):
    times = [float(row["time_s"]) for row in rows(scegen("trace", made, "--dt", "0.5").stdout)]
    assert sorted(set(times))[:3] == [0.0, 0.5, 1.0]


@pytest.mark.parametrize("dt", ["0", "-1", "nan", "x"])
def test_steps_that_make_no_sense_are_refused(scegen, made, dt):
    done = scegen("trace", made, "--dt", dt)
    assert (done.returncode, done.stdout) == (2, "")
    assert "Traceback" not in done.stderr


def test_nothing_to_simulate(scegen, tmp_path):
    (tmp_path / "empty").mkdir()
    for place in ("empty", "nowhere"):
        done = scegen("trace", place)
        assert (done.returncode, done.stdout) == (2, "")
        assert place in done.stderr


def test_a_viewer_s_file_holds_the_same_movements(scegen, made, tmp_path):
    reading = pytest.importorskip("mcap.reader", reason="the extra exchange is not installed")
    decoding = pytest.importorskip("mcap_protobuf.decoder")
    for name in ("a.mcap", "b.mcap"):
        assert scegen("trace", made, "--mcap", "-o", name).returncode == 0
    assert (tmp_path / "a.mcap").read_bytes() == (tmp_path / "b.mcap").read_bytes()
    table = rows(scegen("trace", made, "--csv").stdout)
    ego = [row for row in table if row["id"] == "ego"]
    with (tmp_path / "a.mcap").open("rb") as stream:
        reader = reading.make_reader(stream, decoder_factories=[decoding.DecoderFactory()])
        plotted = [
            (message.log_time, json.loads(message.data))
            for _, channel, message in reader.iter_messages(topics=["/participants/ego"])
        ]
        frames = [m for *_, m in reader.iter_decoded_messages(topics=["/tf"])]
        boxes = [m for *_, m in reader.iter_decoded_messages(topics=["/scene"])]
        (road,) = [m for *_, m in reader.iter_decoded_messages(topics=["/road"])]
    assert [time / 1e9 for time, _ in plotted] == [float(row["time_s"]) for row in ego]
    for (_, state), frame, row in zip(plotted, frames, ego, strict=True):
        assert {k: float(v) for k, v in row.items() if k != "id"} == pytest.approx(state, abs=1e-6)
        (own,) = [t for t in frame.transforms if t.child_frame_id == "ego"]
        assert own.translation.x == pytest.approx(float(row["x_m"]), abs=1e-6)
    # The box stands before the rear axle, half a car's height above the ground.
    (box,) = [entity.cubes[0] for entity in boxes[0].entities if entity.id == "ego"]
    ahead = hypot(
        box.pose.position.x - float(ego[0]["x_m"]), box.pose.position.y - float(ego[0]["y_m"])
    )
    assert (ahead, box.pose.position.z) == pytest.approx((1.40, 1.49 / 2))
    assert len(road.entities[0].lines) > 5


def test_one_format_at_a_time_and_no_bytes_on_the_screen(scegen, made):
    assert scegen("trace", made, "--csv", "--mcap", "-o", "x").returncode == 2
    done = scegen("trace", made, "--mcap")
    assert (done.returncode, done.stdout) == (2, "")
    assert "-o" in done.stderr


def test_without_the_extra_it_says_what_to_install(scegen, made, monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "mcap.writer", None)
    done = scegen("trace", made, "--mcap", "-o", "x.mcap")
    assert (done.returncode, done.stdout) == (3, "")
    assert "ml-scegen[exchange]" in done.stderr
    assert not (tmp_path / "x.mcap").exists()


@pytest.mark.esmini
@pytest.mark.skipif(shutil.which("esmini") is None, reason="esmini is not on PATH")
def test_esmini_s_recording_is_the_same_movement(scegen, made):
    theirs = rows(scegen("trace", made, "--player", "esmini").stdout)
    ours = rows(scegen("trace", made).stdout)
    for mine, other in zip(ours, theirs, strict=False):
        assert (mine["time_s"], mine["id"]) == (other["time_s"], other["id"])
        for column in ("x_m", "y_m"):
            assert float(mine[column]) == pytest.approx(float(other[column]), abs=0.25)
    assert abs(len(ours) - len(theirs)) <= 4
    assert scegen("trace", made, "--player", "esmini", "--dt", "0.1").returncode == 2


def test_esmini_is_missing(scegen, made):
    assert scegen("trace", made, "--player", "esmini", path="/nowhere").returncode == 3


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
