"""scegen enumerate: streams, narrows, chooses, draws; scegen generate narrows alike."""

import json
import re
import signal
import subprocess
import sys

import numpy as np
import pytest
from lxml import etree
from PIL import Image

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


MILLION = (
    "enumerate", "--entries", "0,1,2,3,4,0,1,2,3,4", "--junction-arms", "5", "--reduction", "none"
)  # fmt: skip


IN_FRONT = (
    "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
    "from scegen.cli import main; main()"
)
"""A shell lets its background jobs ignore Ctrl-C, and the tests may run in one."""


@pytest.mark.parametrize("form", ["lines", "json"])
def test_an_interrupt_says_how_far_it_came_and_leaves_the_list_whole(form):
    with subprocess.Popen(
        [
            sys.executable,
            "-c",
            IN_FRONT,
            *MILLION,
            "--all",
            *(["--json"] if form == "json" else []),
        ],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        begun = [process.stdout.readline() for _ in range(6)]
        process.send_signal(signal.SIGINT)
        rest, complaint = process.stdout.read(), process.stderr.read()
    assert process.returncode == 130
    listed = re.search(r"interrupted: ([\d,]+) of 1,048,576 scenarios listed", complaint)
    number = int(listed[1].replace(",", ""))
    written = "".join(begun) + rest
    if form == "json":
        data = json.loads(written)
        assert (len(data["scenarios"]), data["complete"]) == (number, False)
        assert (data["total"], data["looked_at"]) == (4**10, number)
    else:
        assert len(written.splitlines()) == number
        assert written.endswith("\n")


def test_an_interrupt_elsewhere_is_said_too():
    program = (
        "import os, signal; from scegen.cli import app, main\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "app.app.command('wait')(lambda: os.kill(os.getpid(), signal.SIGINT))\n"
        "main()"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, "wait"], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr.strip()) == (130, "interrupted")


def test_an_interrupt_in_the_background_is_ignored():
    program = (
        "import os, signal; from scegen.cli import listing, main\n"
        "signal.signal(signal.SIGINT, signal.SIG_IGN)\n"
        "whole = listing.line\n"
        "listing.line = lambda one: os.kill(os.getpid(), signal.SIGINT) or whole(one)\n"
        "main()"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, *CARS], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.splitlines()) == 27


def test_of_too_many_a_selection_is_listed_and_both_numbers_are_said(scegen):
    done = scegen(*MILLION, "--limit", "30")
    assert len(done.stdout.splitlines()) == 30
    assert "1,048,576 scenarios of 1,048,576 assignments" in done.stderr
    assert "Listed are 30 of 1,048,576" in done.stderr


def test_json_is_one_document_with_its_certificate(scegen):
    data = json.loads(scegen(*CARS, "--arms", "equal", "--json").stdout)
    assert list(data)[:3] == ["total", "count", "scenarios"]
    assert data["total"] == data["count"] == len(data["scenarios"]) == data["looked_at"] == 27
    assert data["complete"]
    counted = json.loads(scegen(*CARS, "--arms", "equal", "--json", "--count-only").stdout)
    assert {n: data[n] for n in counted if n != "method"} | {"method": counted["method"]} == counted


def test_who_counts_as_whom_is_said(scegen):
    ten = ("enumerate", "--entries", "0,1,2,0,1,2,0,1,2,0", "--junction-arms", "3", "--limit", "1")
    told = scegen(*ten).stderr
    assert "128 scenarios of 1,024" in told
    assert "the ego car_1 is told apart as the vehicle under test" in told
    assert "car_4, car_7, car_10 at arm 0" in told
    assert "car_1, car_4, car_7, car_10 at arm 0" in scegen(*ten, "--arms", "equal").stderr


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


def test_many_are_folded_as_png_and_the_same_again(scegen, tmp_path):
    cars = ("enumerate", "--entries", "0,1,2,3", "--junction-arms", "4", "--reduction", "none")
    for name in ("a.png", "b.png"):
        done = scegen(*cars, "--gallery", name)
        assert done.returncode == 0, done.stderr
    one, other = ((tmp_path / name).read_bytes() for name in ("a.png", "b.png"))
    assert one == other
    with Image.open(tmp_path / "a.png") as picture:
        assert picture.width == 1272
        assert 1_000 < picture.height < 3_000  # 81, folded
        tile = np.asarray(picture.convert("RGB"))[400:700, 12:252]
    assert len(np.unique(tile.reshape(-1, 3), axis=0)) > 50


def test_a_picture_of_a_folder_lies_beside_its_scenarios(scegen, tmp_path):
    assert scegen(*CARS, "-o", "logical.json").returncode == 0
    done = scegen("gallery", ".")
    assert (done.returncode, done.stdout) == (0, "gallery.png\n"), done.stderr
    assert (tmp_path / "gallery.png").read_bytes()[:4] == b"\x89PNG"
    assert scegen("gallery", "logical.json", "-o", "tiles.svg").returncode == 0
    etree.parse(tmp_path / "tiles.svg")


def test_a_picture_of_another_kind_is_refused(scegen, tmp_path):
    for arguments in ((*CARS, "--gallery", "g.gif"), ("gallery", ".", "-o", "g.pdf")):
        done = scegen(*arguments)
        assert done.returncode == 2
        assert "neither .svg nor .png" in done.stderr
    assert not list(tmp_path.iterdir())


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
