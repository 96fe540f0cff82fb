"""What claims cost per candidate, beside the simulation and the measures that a search runs anyway.

    python benchmarks/claims.py [--json] [--candidates N]

The problems are the source paper's eleven sentences and some with acts, spacings and outcomes;
every candidate of a batch differs, as in a search. "without" is one evaluation of a candidate with
no claims at all: simulation, measures, target, bounds of what is possible. The goal: claims cost
less than half of that, in the median over the problems.
"""

from __future__ import annotations

import argparse
import gc
import json
import sys
from collections.abc import Iterator
from dataclasses import replace
from statistics import median
from time import process_time

import numpy as np

from scegen.concretization import concretize
from scegen.criticality.raising.stage import Stage
from scegen.criticality.search.optimize import halton
from scegen.criticality.search.problem import Problem
from scegen.criticality.target import COLLISION, NEAR_MISS, parse_target
from scegen.enumeration import enumerate_scenarios
from scegen.pipeline.picking import pick
from scegen.road import build_network
from scegen.understanding import paper_cases, read

GOAL = 0.5
ROUNDS = 15
SAYINGS = {
    "brakes": "The ego follows a car at 50 km/h with a gap of 20 m. The car brakes with 5 m/s2.",
    "cuts in": "A van at 70 km/h cuts in from the right lane 15 m in front of the ego, "
    "which drives 90 km/h.",
    "walks": "A pedestrian walks at 5 km/h from the right across the road and is hit by the middle "
    "of the front of the ego, which drives at 40 km/h.",
    "stands": "A car stands still in the ego's lane. The ego crashes into it at 40 km/h.",
}


def problems() -> Iterator[tuple[str, Problem]]:
    """By name, search problems of the sentences."""
    texts = {case.id: case.text for case in paper_cases()} | SAYINGS
    for name, text in texts.items():
        functional = read(text)
        concrete = concretize(functional, pick(enumerate_scenarios(functional), None)[0], seed=0)
        outcome = functional.outcome
        collides = outcome is not None and outcome.kind == "collision"
        target = parse_target(COLLISION if collides else NEAR_MISS)
        stage = Stage(functional, concrete, build_network(concrete.road), target)
        if stage.blocked is None:
            yield name, stage.problem()


def cost_s(problem: Problem, count: int) -> float:
    """Seconds of the processor per candidate, the best of some rounds."""
    x = problem.space.at(halton(count, np.zeros(len(problem.space.variables))))
    best = np.inf
    for _ in range(ROUNDS):
        begin = process_time()
        problem.evaluate(x)
        best = min(best, process_time() - begin)
    return best / count


def main() -> int:
    """Print the costs; 1 if the goal is missed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--candidates", type=int, default=96)
    options = parser.parse_args()
    rows = []
    # As in the program itself, which collects garbage rarely.
    gc.set_threshold(200_000)
    for name, problem in problems():
        bare = replace(problem, claims=())
        without = cost_s(bare, options.candidates)
        with_them = cost_s(problem, options.candidates)
        rows.append(
            {
                "problem": name,
                "participants": len(problem.concrete.participants),
                "claims": len(problem.claims),
                "without_us": 1e6 * without,
                "claims_us": 1e6 * (with_them - without),
                "share": with_them / without - 1.0,
            }
        )
    share = median(row["share"] for row in rows)
    if options.json:
        print(json.dumps({"median_share": share, "rows": rows}, indent=2))
    else:
        print(f"{'problem':10}{'participants':>13}{'claims':>8}{'without':>10}{'claims':>10}")
        for row in rows:
            print(
                f"{row['problem']:10}{row['participants']:13}{row['claims']:8}"
                f"{row['without_us']:7.0f} µs{row['claims_us']:7.0f} µs  {row['share']:.2f}"
            )
        print(f"median share {share:.2f} [{GOAL}]")
    return int(share > GOAL)


if __name__ == "__main__":
    sys.exit(main())
