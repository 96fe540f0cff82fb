"""scegen enumerate: streams, narrows, chooses, draws; scegen generate narrows alike."""

import json
import signal
import subprocess
import sys

from lxml import etree

CARS = ("enumerate", "--entries", "0,1,2", "--junction-arms", "4")
SENTENCE = "Three cars meet at a T-intersection."


def test_the_first_answer_comes_before_the_last():
    """800,000 scenarios: the reader of the pipe leaves after two, and nothing is left running."""
    command = (
        "from scegen.cli import main; main()",
        "enumerate", "--entries", "0,1,2,3,4,0,1,2,3,4", "--junction-arms", "5",
        "--reduction", "none", "--limit", "800000",
    )  # fmt: skip
    with subprocess.Popen(
        [sys.executable, "-c", *command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        lines = [process.stdout.readline() for _ in range(2)]
        process.stdout.close()
        assert process.wait(timeout=60) == 1
        assert "Traceback" not in process.stderr.read()
    assert [line[:4] for line in lines] == ["000-", "001-"]


def test_an_interrupt_is_no_traceback():
    command = (
        "from scegen.cli import main; main()",
        "enumerate", "--entries", "0,1,2,3,4,0,1,2,3,4", "--junction-arms", "5",
        "--reduction", "none", "--limit", "800000",
    )  # fmt: skip
    with subprocess.Popen(
        [sys.executable, "-c", *command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        _, complaint = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "Traceback" not in complaint


def test_millions_are_refused_without_a_limit(scegen):
    done = scegen("enumerate", "--entries", "0,1,2,3,4,0,1,2,3,4,0", "--junction-arms", "5")
    assert done.returncode == 2
    assert "--limit" in done.stderr
    assert done.stdout == ""


def test_json_says_how_many_match(scegen):
    listed = json.loads(scegen(*CARS, "--where", "yields(ego)", "--json").stdout)
    counted = json.loads(scegen(*CARS, "--where", "yields(ego)", "--json", "--count-only").stdout)
    assert listed["matching"] == counted["matching"] == len(listed["scenarios"]) < 27
    assert listed["count"] == listed["total"] == 27


def test_json_coverage_is_the_table(scegen):
    data = json.loads(scegen(*CARS, "--where", "index < 3", "--coverage", "--json").stdout)
    assert len(data["coverage"]) == 7
    assert sum(row["chosen"] > 0 for row in data["coverage"]) == 1


def test_two_ways_to_choose_are_one_too_many(scegen):
    assert scegen(*CARS, "--cover", "--sample", "2").returncode == 2


def test_what_is_chosen_goes_to_files(scegen, tmp_path):
    done = scegen(*CARS, "--sample", "4", "-o", "chosen.json", "--gallery", "chosen.svg")
    assert done.returncode == 0, done.stderr
    assert len(json.loads((tmp_path / "chosen.json").read_text())["scenarios"]) == 4
    etree.parse(tmp_path / "chosen.svg")
    assert "4 logical scenarios" in (tmp_path / "chosen.svg").read_text()


def test_generate_makes_what_is_as_asked_for(scegen, tmp_path):
    asked = ("--check", "none", "--target", "none", "--count", "2")
    done = scegen("generate", SENTENCE, "-o", "a", "--where", "ego.turn == left", *asked)
    assert done.returncode == 0, done.stderr
    logical = json.loads((tmp_path / "a" / "logical.json").read_text())
    ego = next(p["id"] for p in logical["functional"]["participants"] if p["role"] == "ego")
    turns = {
        a["turn"] for s in logical["scenarios"] for a in s["assignments"] if a["participant"] == ego
    }
    assert turns == {"left"}
    assert logical["certificate"]["matching"] == len(logical["scenarios"])
    done = scegen("generate", SENTENCE, "-o", "b", "--where", "ego.entry > 7", *asked)
    assert done.returncode == 2
    assert not (tmp_path / "b").exists()
