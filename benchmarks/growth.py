"""How cost and memory grow with cars, arms and scenarios.

    python benchmarks/growth.py [--json]

Counting, and listing the first so many, for cars spread over the arms of a junction with all arms
alike; then one scenario from the logical level to files with the search for danger, for 2 to 10
cars. Each row is measured in a process of its own: "peak" is the most memory that it ever held,
"base" that of one that has only imported the program. Processor seconds.
"""

from __future__ import annotations

import argparse
import json
import resource
from collections.abc import Callable
from functools import partial
from itertools import islice
from multiprocessing import get_context
from time import process_time
from typing import Any

from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.enumeration import (
    count_scenarios,
    enumerate_scenarios,
    iterate_scenarios,
    plain_crossing,
)
from scegen.pipeline.export import export_scenario
from scegen.pipeline.picking import pick
from scegen.scenario.vocabulary import ArmsMode
from scegen.understanding import read

COUNTED = ((2, 4), (4, 4), (6, 4), (8, 4), (10, 4), (8, 3), (8, 5), (8, 6), (8, 8), (20, 6))
LISTED = (100, 1_000, 10_000, 100_000)
MADE = {
    2: "Two cars meet at a four-way intersection.",
    4: "Four cars meet at a four-way intersection.",
    6: "Six cars meet at a four-way intersection.",
    8: "Eight cars meet at a four-way intersection.",
    10: "Ten cars meet at a four-way intersection.",
}


def peak_mb() -> float:
    """The most memory that this process has held."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def base() -> dict[str, Any]:
    return {"peak_mb": peak_mb()}


def counted(cars: int, arms: int) -> dict[str, Any]:
    functional = plain_crossing([car % arms for car in range(cars)], arms)
    count_scenarios(plain_crossing([0, 1], 4), arms=ArmsMode.EQUAL)
    begin = process_time()
    found = count_scenarios(functional, arms=ArmsMode.EQUAL)
    seconds = process_time() - begin
    row = {"cars": cars, "arms": arms, "assignments": found.total, "scenarios": found.count}
    return {**row, "ms": 1e3 * seconds}


def listed(scenarios: int) -> dict[str, Any]:
    functional = plain_crossing([car % 6 for car in range(20)], 6)
    begin = process_time()
    number = sum(1 for _ in islice(iterate_scenarios(functional, arms=ArmsMode.EQUAL), scenarios))
    return {"scenarios": number, "s": process_time() - begin, "peak_mb": peak_mb()}


def made(cars: int) -> dict[str, Any]:
    """The second time, when kernels are compiled and loaded."""
    functional = read(MADE[cars])
    scenario = pick(enumerate_scenarios(functional, limit=200), None)[0]
    for _ in range(2):
        begin = process_time()
        concrete = concretize(functional, scenario, seed=0)
        raised = raise_criticality(functional, concrete)
        export_scenario(raised.concrete)
        seconds = process_time() - begin
    return {"cars": cars, "s": seconds, "in_band": raised.proof.reached, "peak_mb": peak_mb()}


def alone(what: Callable[[], dict[str, Any]]) -> dict[str, Any]:
    """The answer of a new process."""
    with get_context("spawn").Pool(1) as pool:
        return pool.apply(what)


def main() -> None:
    """Print three tables."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--json", action="store_true")
    asked = parser.parse_args()
    report = {
        "base_mb": alone(base)["peak_mb"],
        "counted": [counted(cars, arms) for cars, arms in COUNTED],
        "listed": [alone(partial(listed, scenarios)) for scenarios in LISTED],
        "made": [alone(partial(made, cars)) for cars in MADE],
    }
    if asked.json:
        print(json.dumps(report, indent=2))
        return
    print(f"memory of a process that has only imported: {report['base_mb']:.0f} MB")
    for name in ("counted", "listed", "made"):
        print(f"\n{name}")
        for row in report[name]:
            print("  " + ", ".join(f"{key} {value:,.6g}" for key, value in row.items()))


if __name__ == "__main__":
    main()
