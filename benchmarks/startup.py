"""What one ``scegen generate`` costs as a process of its own, with the quick checks; goal: 2 s.

    python benchmarks/startup.py [--against SRC] [--times 5] [--json]

SRC is the ``src`` folder of another version, such as a worktree of an older commit: both then run
in turn, so that other work on the machine slows both alike, and the ratio says what has changed.
Told are the least seconds of processor time, esmini's included, and of wall clock; the first run of
each, which compiles, is not counted.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter

GOAL_S = 2.0
TEXT = (
    "At a four-way intersection the ego turns left and an oncoming car drives straight on too fast."
)
HERE = Path(__file__).resolve().parents[1] / "src"


def main() -> int:
    """Print a line for each version, and the ratio."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--against", type=Path)
    parser.add_argument("--times", type=int, default=5)
    parser.add_argument("--json", action="store_true")
    asked = parser.parse_args()
    sources = {"this": HERE} | ({"against": asked.against.resolve()} if asked.against else {})
    found: dict[str, list[tuple[float, float]]] = {name: [] for name in sources}
    with tempfile.TemporaryDirectory() as folder:
        for number in range(asked.times + 1):
            for name, source in sources.items():
                measured = _run(source, Path(folder, name))
                if number:
                    found[name].append(measured)
    told = {
        name: {
            "cpu_s": round(min(c for c, _ in runs), 2),
            "wall_s": round(min(w for _, w in runs), 2),
        }
        for name, runs in found.items()
    }
    if asked.against:
        told["ratio"] = {
            key: round(told["this"][key] / told["against"][key], 2) for key in ("cpu_s", "wall_s")
        }
    if asked.json:
        print(json.dumps(told))
    else:
        for name, values in told.items():
            print(f"{name}: " + ", ".join(f"{key} {value}" for key, value in values.items()))
    return int(told["this"]["cpu_s"] > GOAL_S)


def _run(source: Path, folder: Path) -> tuple[float, float]:
    """Processor and wall seconds of one process, with compiled files kept beside its results."""
    environment = {**os.environ, "PYTHONPATH": str(source)}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    environment["PYTHONPYCACHEPREFIX"] = str(folder.with_suffix(".cache"))
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), perf_counter()
    done = subprocess.run(
        [sys.executable, "-m", "scegen", "generate", TEXT, "-o", str(folder), "--force"],
        env=environment,
        check=False,
        capture_output=True,
        text=True,
    )
    if done.returncode:
        sys.exit(f"{source}: exit code {done.returncode}\n{done.stderr}{done.stdout}")
    wall, after = perf_counter() - begin, resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return cpu, wall


if __name__ == "__main__":
    sys.exit(main())
