"""Campaigns on the command line: from a list of sentences to a suite that passes its checks."""

import json
import os

import pytest
from command import PROGRAM, as_process


@pytest.fixture
def made(scegen, tmp_path):
    (tmp_path / "list.txt").write_text("Two cars meet at a T-intersection.\n", encoding="utf-8")
    done = scegen("campaign", "list.txt", "-o", "made", "--workers", "1", "--count", "2")
    assert done.returncode == 0, done.stderr
    assert done.stdout == "2 scenarios, 0 of them failed\n"
    return tmp_path / "made"


def test_a_suite_passes_its_checks(scegen, made, tmp_path):
    done = scegen("campaign", "select", made, "--size", "2", "-o", "suite", "--json")
    told = json.loads(done.stdout)
    assert told["covered"] == told["coverable"] > 0
    checked = scegen("check", "suite", "--json")
    assert checked.returncode == 0, checked.stdout
    places = {report["folder"] for report in json.loads(checked.stdout)}
    assert places == {f"suite/{scenario['folder']}" for scenario in told["scenarios"]}
    assert json.loads((tmp_path / "suite" / "suite.json").read_text()) == told
    again = scegen("campaign", "select", made, "--size", "2", "-o", "suite")
    assert again.returncode == 2
    assert "not empty" in again.stderr


def test_what_is_broken_is_named_and_fails(scegen, made):
    assert scegen("campaign", made, "--verify").returncode == 0
    batch = next(made.glob("batches/*.parquet"))
    batch.write_bytes(b"")
    done = scegen("campaign", "--verify", made)
    assert done.returncode == 1
    assert batch.name in done.stderr


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        (["no.yaml", "-o", "x"], "no.yaml"),
        (["list.txt"], "-o DIR"),
        (["list.txt", "-o", "x", "--engine", "slurm"], "is not one of 'joblib', 'ray'"),
        (["list.txt", "-o", "x", "--engine", "ray", "--address", "127.0.0.1:1"], "no Ray cluster"),
        (["--verify"], "names no folder"),
        (["nowhere", "--verify"], "holds no campaign"),
        (["report", "nowhere"], "holds no campaign"),
        (["select", "nowhere", "--size", "3"], "holds no rows"),
    ],
)
def test_what_cannot_be_is_told(scegen, tmp_path, arguments, word):
    (tmp_path / "list.txt").write_text("Two cars meet.", encoding="utf-8")
    done = scegen("campaign", *arguments)
    assert done.returncode == 2
    assert word in done.stderr
    assert "Traceback" not in done.stderr


def test_without_the_extra_it_says_what_to_install(tmp_path):
    (tmp_path / "list.txt").write_text("Two cars meet.", encoding="utf-8")
    program = f"import sys; sys.modules['duckdb'] = None; {PROGRAM}"
    arguments = ["campaign", "list.txt", "-o", "x"]
    done = as_process(arguments, tmp_path, dict(os.environ), program)
    assert done.returncode == 3
    assert "ml-scegen[campaign]" in done.stderr


def test_the_order_has_a_schema(scegen):
    schema = json.loads(scegen("schema", "campaign").stdout)
    assert {"descriptions", "sweep", "concretizations", "confirm"} <= set(schema["properties"])
