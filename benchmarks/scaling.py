"""Cost of a candidate against the number of participants and of candidates.

    python benchmarks/scaling.py [--json]

The crossing of batch.py: simulation with all measures of all pairs, 10 s in steps of 0.05 s, one
thread, best of three runs. First 2 to 10 participants with 2,000 candidates, then 2, 4 and 10
participants with 1 to 100,000 candidates, and what a call costs before its first candidate.
"""

from __future__ import annotations

import argparse
import json
import sys
from time import process_time
from typing import Any

import numpy as np
from batch import DT_S, DURATION_S, crossing, varied

from scegen.measures import evaluate

PARTICIPANTS = range(2, 11)
CANDIDATES = (1, 10, 100, 1_000, 10_000, 100_000)
USUAL = 2_000
RUNS = 3
ENOUGH_S = 0.2
"""Calls shorter than this are repeated, so that the clock can see them."""
MOST_S = 40.0


def seconds_per_candidate(participants: int, candidates: int) -> float:
    """Processor time of one candidate in a batch of so many."""
    program, candidate, scene = crossing(participants)
    many = varied(candidate, candidates)
    evaluate(program, varied(candidate, 1), scene, duration_s=DURATION_S, dt_s=DT_S)
    best = np.inf
    for _ in range(RUNS):
        calls, begin = 0, process_time()
        while not calls or process_time() - begin < ENOUGH_S:
            evaluate(program, many, scene, duration_s=DURATION_S, dt_s=DT_S)
            calls += 1
        best = min(best, (process_time() - begin) / calls / candidates)
        if calls == 1 and best * candidates > MOST_S / RUNS:
            break
    return best


def report() -> dict[str, Any]:
    by_participants = [
        {"participants": n, "pairs": n * (n - 1) // 2, "us": 1e6 * seconds_per_candidate(n, USUAL)}
        for n in PARTICIPANTS
    ]
    by_candidates = [
        {
            "candidates": count,
            **{f"us_{n}": 1e6 * seconds_per_candidate(n, count) for n in (2, 4, 10)},
        }
        for count in CANDIDATES
    ]
    return {"by_participants": by_participants, "by_candidates": by_candidates}


def main() -> int:
    """Print both tables; exit code 1 if large batches cost more per candidate than usual ones."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--json", action="store_true")
    asked = parser.parse_args()
    made = report()
    if asked.json:
        print(json.dumps(made, indent=2))
    else:
        print(f"{'participants':>12}{'pairs':>7}{'us/candidate':>14}{'us/pair':>9}")
        for row in made["by_participants"]:
            per_pair = row["us"] / row["pairs"]
            print(f"{row['participants']:12}{row['pairs']:7}{row['us']:14.1f}{per_pair:9.2f}")
        print(f"\n{'candidates':>10}" + "".join(f"{f'us, {n} cars':>14}" for n in (2, 4, 10)))
        for row in made["by_candidates"]:
            costs = "".join(f"{row[f'us_{n}']:14.1f}" for n in (2, 4, 10))
            print(f"{row['candidates']:10,}{costs}")
    small, large = made["by_candidates"][3], made["by_candidates"][-1]
    return int(any(large[f"us_{n}"] > 1.5 * small[f"us_{n}"] for n in (2, 4, 10)))


if __name__ == "__main__":
    sys.exit(main())
