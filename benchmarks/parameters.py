"""Do scenarios with parameters play as our own files? 50 random sets of 10 logical scenarios.

    python benchmarks/parameters.py [--sets 50] [--seed 1] [--json]

Every set is played twice in esmini: by the file with parameters (``--param_dist``) and by the plain
1.0 file of the concrete scenario that has these values. Goal: nobody is ever more than 5 cm apart.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from pathlib import Path

from scegen.checking.parameters import check_parameters
from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.pipeline.parameter_sets import (
    PARAMETERISED_FILE,
    VALUES_FILE,
    set_files,
    write_parameter_files,
)
from scegen.pipeline.picking import pick
from scegen.understanding import read

TEXTS = (
    "At a four-way intersection the ego turns left and an oncoming car drives straight on.",
    "A car cuts in front of the ego on a two-lane road and brakes hard.",
    "A pedestrian crosses the road from behind a parked van in front of the ego.",
    "At a roundabout with four arms a car fails to yield to the ego.",
    "A truck from the right runs the red light at a crossing while the ego drives straight on.",
    "The ego overtakes a slow bus while a car comes towards it.",
    "A parked car pulls out in front of the ego.",
    "Three cars meet at a T-junction; the one from the left turns left without yielding.",
    "The car ahead of the ego suddenly brakes with 6 m/s2 when the gap is 20 m.",
    "A cyclist crosses from the right at a skewed intersection where the ego turns right.",
)


def main() -> int:
    """Print one line for each logical scenario."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sets", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", action="store_true")
    asked = parser.parse_args()
    rows, failed = [], 0
    for text in TEXTS:
        functional = read(text)
        logical = enumerate_scenarios(functional, limit=1000)
        scenario = pick(logical, None)[0]
        concrete = concretize(functional, scenario, seed=asked.seed)
        made = write_parameter_files(
            functional, concrete, count=asked.sets, seed=asked.seed, alone=True
        )
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            made.save(folder)
            checked = check_parameters(
                folder / PARAMETERISED_FILE, folder / VALUES_FILE, set_files(folder, asked.sets)
            )
        failed += bool(checked.errors)
        passed_over = sum(made.passed_over.values())
        rows.append([concrete.name, len(made.declared), passed_over, checked.detail])
        if not asked.json:
            print(
                f"{concrete.name}: {len(made.declared)} parameters, {passed_over} draws passed "
                f"over; {checked.status}: {checked.detail}",
                flush=True,
            )
            for finding in checked.errors[:5]:
                print(f"  {finding.place}: {finding.message}")
    if asked.json:
        print(json.dumps(rows))
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
