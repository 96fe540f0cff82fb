"""Three ways to enumerate, side by side: the source paper's encoding, raw clingo, the package.

    python benchmarks/enumeration.py [--quick] [--json]

10 cars at 5 arms, two at each: the 286 patterns and the 20,008 exact classes. Raw clingo only
counts the models of the package's own program; the whole path goes from the functional scenario
to typed, named and certified results. The paper's encoding knows patterns alone and takes about a
minute; --quick gives all three 8 cars. Then 20 cars at 6 arms: time to count, rate and memory of
the stream. Processor time of one thread: raw and whole take turns, and the medians of nine runs
count (the paper's: one).
"""

from __future__ import annotations

import argparse
import gc
import json
import sys
import tracemalloc
from collections.abc import Callable
from itertools import islice
from pathlib import Path
from statistics import median
from time import process_time
from typing import Any

from clorm.clingo import Control

from scegen.enumeration import (
    count_scenarios,
    enumerate_scenarios,
    iterate_scenarios,
    plain_crossing,
)
from scegen.enumeration.problem import build_problem
from scegen.enumeration.solving import listing_program
from scegen.enumeration.symmetry import symmetry_of
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.vocabulary import ArmsMode, Reduction

PAPER = Path(__file__).parent / "paper.lp"
RUNS = 9
RAW_LIMIT, PAPER_LIMIT, COUNT_LIMIT_MS = 8.0, 100.0, 10.0
STREAMED = 20_000


def models(control: Control) -> int:
    control.configuration.solve.models = 0
    with control.control_.solve(yield_=True) as handle:  # clingo's own, without clorm
        return sum(1 for _ in handle)


def paper(entries: list[int], arms: int) -> int:
    """Patterns by the paper's encoding."""
    control = Control(["--project=project"])
    control.load(str(PAPER))
    facts = [f"arms({arms})."]
    facts += [f"car({c}). initial_move({c},{e})." for c, e in enumerate(entries)]
    control.add("base", [], " ".join(facts))
    control.ground([("base", [])])
    return models(control)


def raw(functional: FunctionalScenario, reduction: Reduction) -> int:
    problem = build_problem(functional)
    symmetry = symmetry_of(problem, ArmsMode.EQUAL)
    return models(listing_program(problem, symmetry, reduction))


def whole(functional: FunctionalScenario, reduction: Reduction) -> int:
    found = enumerate_scenarios(functional, reduction=reduction, arms=ArmsMode.EQUAL)
    return len(found.scenarios)


def timed(what: Callable[[], int]) -> tuple[int, float]:
    """The answer and the time (s)."""
    gc.collect()
    start = process_time()
    answer = what()
    return answer, process_time() - start


def in_turns(*whats: Callable[[], int]) -> tuple[int, list[float]]:
    """The answer, the same of all, and the median time of each (s)."""
    runs = [[timed(what) for what in whats] for _ in range(RUNS)]
    (answer,) = {found for run in runs for found, _ in run}
    return answer, [median(took for _, took in column) for column in zip(*runs, strict=True)]


def listings(cars: int) -> list[dict[str, Any]]:
    arms = 5
    entries = [index % arms for index in range(cars)]
    functional = plain_crossing(entries, arms)
    rows = []
    for reduction in (Reduction.PATTERN, Reduction.EXACT):
        listed, (raw_s, whole_s) = in_turns(
            lambda r=reduction: raw(functional, r), lambda r=reduction: whole(functional, r)
        )
        row = {"cars": cars, "arms": arms, "reduction": reduction.value, "scenarios": listed}
        row |= {
            "paper_s": None,
            "raw_s": raw_s,
            "whole_s": whole_s,
            "whole_per_raw": whole_s / raw_s,
        }
        if reduction is Reduction.PATTERN:
            patterns, paper_s = timed(lambda: paper(entries, arms))
            assert patterns == listed
            row |= {"paper_s": paper_s, "paper_per_whole": paper_s / whole_s}
        rows.append(row)
    return rows


def stream() -> dict[str, Any]:
    functional = plain_crossing([index % 6 for index in range(20)], 6)
    _, (count_s,) = in_turns(lambda: count_scenarios(functional, arms=ArmsMode.EQUAL).count)
    start = process_time()
    flow = iterate_scenarios(functional, arms=ArmsMode.EQUAL)
    next(flow)
    first_s = process_time() - start
    rates = []
    for _ in range(4):
        start = process_time()
        for _scenario in islice(flow, STREAMED // 4):
            pass
        rates.append(STREAMED / 4 / (process_time() - start))
    flow.close()
    tracemalloc.start()
    flow, held = iterate_scenarios(functional, arms=ArmsMode.EQUAL), []
    for _ in range(2):
        for _scenario in islice(flow, STREAMED // 2):
            pass
        held.append(tracemalloc.get_traced_memory()[0])
    tracemalloc.stop()
    flow.close()
    return {
        "count_ms": count_s * 1e3,
        "first_ms": first_s * 1e3,
        "per_s": rates,
        "growth_kb": (held[1] - held[0]) / 1e3,
    }


def show(rows: list[dict[str, Any]], flow: dict[str, Any]) -> None:
    print(
        f"{'':22}{'scenarios':>10}{'paper':>10}{'raw':>9}{'whole':>9}{'whole/raw':>11}{'paper/whole':>13}"
    )
    for row in rows:
        name = f"{row['cars']} cars, {row['arms']} arms, {row['reduction']}"
        by_paper = f"{row['paper_s']:.2f} s" if row["paper_s"] else "–"
        faster = f"{row['paper_per_whole']:.0f}" if row["paper_s"] else "–"
        print(
            f"{name:22}{row['scenarios']:>10,}{by_paper:>10}{row['raw_s']:>7.3f} s"
            f"{row['whole_s']:>7.3f} s{row['whole_per_raw']:>11.1f}{faster:>13}"
        )
    print(
        f"targets: whole/raw at most {RAW_LIMIT:g}, paper/whole at least {PAPER_LIMIT:g} (10 cars)"
    )
    rates = ", ".join(f"{rate:,.0f}" for rate in flow["per_s"])
    print(f"20 cars, 6 arms: counted in {flow['count_ms']:.1f} ms (target {COUNT_LIMIT_MS:g})")
    print(f"  first scenario after {flow['first_ms']:.0f} ms, then per second: {rates}")
    print(f"  memory from scenario {STREAMED // 2:,} to {STREAMED:,}: {flow['growth_kb']:+,.0f} kB")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--quick", action="store_true", help="8 cars instead of 10")
    parser.add_argument("--json", action="store_true")
    asked = parser.parse_args()
    rows, flow = listings(8 if asked.quick else 10), stream()
    if asked.json:
        print(json.dumps({"listings": rows, "stream": flow}, indent=2))
    else:
        show(rows, flow)
    kept = rows[1]["whole_per_raw"] <= RAW_LIMIT and flow["count_ms"] <= COUNT_LIMIT_MS
    if not asked.quick:
        kept = kept and rows[0]["paper_per_whole"] >= PAPER_LIMIT
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
