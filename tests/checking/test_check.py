"""What is checked, what comes back, and what happens to what is not there."""

from __future__ import annotations

import json
import runpy
import shutil
import subprocess
import sys

import pytest
from rich.console import Console

from scegen.checking import (
    CHECKERS,
    QUICK_CHECKERS,
    CheckReport,
    CheckStatus,
    check_files,
    check_folder,
    reports_table,
)
from scegen.checking.environment import installed_tools
from scegen.checking.environment.__main__ import main
from scegen.checking.results import error, not_run, verdict, warning
from scegen.errors import InputError

OWN = ("opendrive", "openscenario")


def test_scenario_folder(folder):
    [report] = check_files([folder], OWN)
    assert report == check_folder(folder, OWN)
    assert report.ok
    assert [result.checker for result in report.results] == list(OWN)


def test_generate_folder(folder, tmp_path):
    made = tmp_path / "out"
    for name in ("002-b", "001-a"):
        shutil.copytree(folder, made / "scenarios" / name)
    reports = check_files([made], OWN)
    assert [report.folder.rsplit("/")[-1] for report in reports] == ["001-a", "002-b"]


def test_a_made_scenario_that_lost_its_file_is_not_passed_over(folder, tmp_path):
    made = tmp_path / "out"
    for name in ("001-a", "002-b"):
        shutil.copytree(folder, made / "scenarios" / name)
    (made / "scenarios" / "002-b" / "scenario.xosc").unlink()
    with pytest.raises(InputError, match=r"002-b/scenario\.xosc"):
        check_files([made], OWN)


def test_single_files(folder):
    [road] = check_files([folder / "road.xodr"], OWN)
    assert [result.checker for result in road.results] == ["opendrive"]
    [scenario] = check_files([folder / "scenario.xosc"], OWN)
    assert [result.checker for result in scenario.results] == list(OWN)
    assert scenario.ok


def test_folder_of_foreign_files(folder, tmp_path):
    foreign = tmp_path / "foreign"
    foreign.mkdir()
    shutil.copy(folder / "road.xodr", foreign / "town.xodr")
    assert [report.ok for report in check_files([foreign], OWN)] == [True]
    shutil.copy(folder / "concrete.yaml", foreign)  # numbers alone make it no scenario of ours
    assert [report.ok for report in check_files([foreign], OWN)] == [True]
    (foreign / "town.xodr").rename(foreign / "road.xodr")
    (foreign / "concrete.yaml").unlink()
    shutil.copy(folder / "scenario.xosc", foreign / "drive.xosc")
    assert [report.ok for report in check_files([foreign], OWN)] == [True, True]


def test_single_scenario_without_its_road(folder, tmp_path):
    lone = tmp_path / "lone.xosc"
    shutil.copy(folder / "scenario.xosc", lone)
    [report] = check_files([lone], OWN)
    assert {f.rule for f in report.result("openscenario").findings} == {"xosc.road_file"}


@pytest.mark.parametrize("name", ["road.xodr", "scenario.xosc"])
def test_missing_file(folder, name):
    (folder / name).unlink()
    with pytest.raises(InputError, match=name):
        check_files([folder])


def test_nothing_there(tmp_path):
    for path in (tmp_path / "none", tmp_path):
        with pytest.raises(InputError):
            check_files([path])
    other = tmp_path / "notes.txt"
    other.write_text("nothing")
    with pytest.raises(InputError, match="neither"):
        check_files([other])


def test_broken_concrete_scenario(folder):
    (folder / "concrete.yaml").write_text("level: concrete\nname: 3\n")
    with pytest.raises(InputError, match=r"concrete\.yaml"):
        check_folder(folder)


def test_several_at_once(folder):
    reports = check_files([folder, folder / "road.xodr"], OWN)
    assert [len(report.results) for report in reports] == [2, 1]


def test_quick_leaves_out_asam():
    assert set(CHECKERS) - set(QUICK_CHECKERS) == {"asam-opendrive", "asam-openscenario"}


def test_not_run_is_no_pass_and_no_failure():
    report = CheckReport("x", (verdict("a", []), not_run("b", "not installed")))
    assert report.ok
    assert report.result("b").status is CheckStatus.NOT_RUN


def test_only_errors_fail():
    assert verdict("a", [warning("r", "p", "m")]).status is CheckStatus.PASSED
    assert verdict("a", [warning("r", "p", "m"), error("r", "p", "m")]).status is CheckStatus.FAILED


def test_reports_as_json(folder):
    report = check_folder(folder, OWN)
    data = json.loads(json.dumps(report.to_data()))
    assert data["ok"] is True
    assert [result["status"] for result in data["results"]] == ["passed", "passed"]
    assert report.to_data() == check_folder(folder, OWN).to_data()


def test_table_shows_what_matters():
    report = CheckReport(
        "some[folder]",
        (
            verdict("opendrive", [error("xodr.lane_gap", "road 7", "[0.5 m] apart")]),
            not_run("esmini", "not on PATH"),
        ),
    )
    console = Console(width=200, record=True)
    with console.capture() as printed:
        console.print(reports_table([report]))
    text = printed.get()
    for words in ("some[folder]", "FAILED", "road 7: [0.5 m] apart", "NOT RUN", "not on PATH"):
        assert words in text


def test_tools_say_how_to_get_them(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setenv("SCEGEN_ASAM_PYTHON", str(tmp_path / "none"))
    monkeypatch.setenv("SCEGEN_INTEROP_PYTHON", str(tmp_path / "none"))
    assert all(tool.found is None and tool.hint for tool in installed_tools())


@pytest.mark.parametrize("arguments", [[], ["other"], ["asam", "interop"]])
def test_installer_takes_one_known_name(arguments, capsys):
    assert main(arguments) == 2
    assert "asam or interop" in capsys.readouterr().err


def test_installer_runs_as_the_makefile_calls_it(monkeypatch):
    """As a script: what it needs must be there before it is run."""
    commands = []
    monkeypatch.setattr(subprocess, "run", lambda command, **_: commands.append(command))
    monkeypatch.setattr(sys, "argv", ["environment", "asam"])
    with pytest.raises(SystemExit) as ended:
        runpy.run_path(main.__code__.co_filename, run_name="__main__")
    assert ended.value.code == 0
    assert ["venv" in commands[0], "asam-qc-opendrive" in commands[1]] == [True, True]
