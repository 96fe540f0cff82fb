"""The worked example runs, in esmini where it is and in our own simulation."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from command import SOURCE

from scegen.closed_loop import esmini_library

EXAMPLE = Path(__file__).parents[2] / "examples" / "closed_loop.py"
SIMULATORS = ["own", *(["esmini"] if esmini_library() else [])]


@pytest.mark.parametrize("simulator", SIMULATORS)
def test_tells_what_the_driver_made_of_it(simulator):
    done = subprocess.run(
        [sys.executable, EXAMPLE, "--simulator", simulator],
        env=os.environ | {"PYTHONPATH": SOURCE},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    scripted, careful = done.stdout.split(f"with the careful driver, in {simulator}\n")
    assert "truck_1: 0.00 m at the nearest, contact at" in scripted
    assert "contact" not in careful
    assert "it brakes for truck_1 at" in careful


def test_bad_input_is_one_message():
    done = subprocess.run(
        [sys.executable, EXAMPLE, "Hello."],
        env=os.environ | {"PYTHONPATH": SOURCE},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert done.stderr.startswith("error: ")
