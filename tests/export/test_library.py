"""Where the library is loaded without scipy, scipy is as it should be afterwards."""

import subprocess
import sys


def run(code: str) -> str:
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return done.stdout.strip()


def test_scipy_works_before_and_after():
    check = "from scipy.integrate import quad; print(round(quad(lambda x: x, 0, 1)[0], 9))"
    load = "from scegen.export.library import xodr"
    assert run(f"{load}\n{check}") == "0.5"
    assert run(f"{check}\n{load}") == "0.5"


def test_the_curve_that_needs_it_still_has_a_length():
    code = (
        "from scegen.export.library import xodr; "
        "print(xodr.ParamPoly3(0, 10, 0, 0, 0, 0, 0, 0).get_end_data(0, 0, 0)[:2])"
    )
    assert run(code).startswith("(")
