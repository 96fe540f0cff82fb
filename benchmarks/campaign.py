"""What a campaign makes in a second of one processor, by number of cars, and where the time goes.

    python benchmarks/campaign.py [--each N] [--json] [--profile]
    python benchmarks/campaign.py --memory N [--json]

Pairs of files with search, claims, judgement, own checks and storing, no pictures, in one process;
five rounds of N others of two cars and a fifth as many of ten, drawn evenly from the plan. Time is
that of the processor, kernels are warm. The rate is that of the best round, since others on a host
take away from all rounds but add to none; the median stands beside it. With ``--memory``: what the
process holds after each tenth of N different scenarios of two cars, MB; from the second tenth on it
may grow by a twentieth.
"""

from __future__ import annotations

import argparse
import cProfile
import json
import pstats
import resource
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from math import ceil
from pathlib import Path
from statistics import median
from time import process_time

import pyarrow.parquet as pq

from scegen.campaign.making import make_item, warm
from scegen.campaign.order import Campaign, Described
from scegen.campaign.planning import Item, items, plan_description
from scegen.campaign.rows import OBJECT_COLUMNS, SECONDS, STEPS, table_of
from scegen.campaign.store import Store

TEXTS = {
    2: (
        "Two cars meet at a four-way intersection.",
        "A car comes from the left at 50 km/h while the ego goes straight over the intersection.",
        "The ego turns left at a T-intersection in front of an oncoming car.",
        "The ego follows a car which brakes hard.",
        "The ego enters a roundabout while a car drives in it.",
    ),
    10: ("Ten cars meet at a four-way intersection.", "Ten cars meet at a T-intersection."),
}
GOALS = {2: 20.0, 10: 5.0}
BATCH, GROWS = 50, 1.05
ROUNDS = 5


@contextmanager
def planned(cars: int, concretizations: int) -> Iterator[tuple[Store, Campaign, list[Item]]]:
    """A store, and all that is to be made in it."""
    texts = tuple(Described(id=f"d{n}", text=text) for n, text in enumerate(TEXTS[cars]))
    order = Campaign(descriptions=texts, count=8, concretizations=concretizations)
    warm()
    with tempfile.TemporaryDirectory() as place:
        store = Store(Path(place))
        for described in order.descriptions:
            plan_description(store, order, described)
        every = [
            item
            for path in store.plans().values()
            for item in items(path, list(range(pq.read_metadata(path).num_rows)))
        ]
        yield store, order, every


def spread(every: list[Item], count: int) -> list[Item]:
    """So many, evenly."""
    return every[:: max(1, len(every) // count)][:count]


def measured(cars: int, count: int, profile: cProfile.Profile | None) -> dict[str, object]:
    with planned(cars, 4 * ROUNDS) as (store, order, every):
        chosen = spread(every, ROUNDS * count)
        make_item(store, order, every[-1])
        if profile is not None:
            profile.enable()
        rows, rates = [], []
        for part in (chosen[n::ROUNDS] for n in range(ROUNDS)):
            begin = process_time()
            found = [make_item(store, order, item) for item in part]
            store.settle(row[name] for row in found for name in OBJECT_COLUMNS if row.get(name))
            store.write_batch(table_of(found))
            rates.append(len(part) / (process_time() - begin))
            rows += found
        if profile is not None:
            profile.disable()
    made = [row for row in rows if row["status"] == "made"]
    return {
        "cars": cars,
        "made": len(made),
        "failed": len(rows) - len(made),
        "said": sum(row["claims"] == row["claims_held"] for row in made),
        "reached": sum(bool(row["reached"]) for row in made),
        "per_s": max(rates),
        "median_per_s": median(rates),
        "goal_per_s": GOALS[cars],
        **{
            f"{name}_ms": 1e3 * sum(row.get(f"{SECONDS}_{name}") or 0.0 for row in rows) / len(rows)
            for name in STEPS
        },
    }


def held_mb(count: int) -> list[float]:
    """What the process holds after each tenth of so many scenarios, batch by batch as a worker."""
    found = []
    with planned(2, ceil(count / 30)) as (store, order, every):
        chosen = spread(every, count)
        for n in range(10):
            for part in batched(chosen[n * count // 10 : (n + 1) * count // 10], BATCH):
                rows = [make_item(store, order, item) for item in part]
                store.settle(row[name] for row in rows for name in OBJECT_COLUMNS if row.get(name))
                store.write_batch(table_of(rows))
            pages = int(Path("/proc/self/statm").read_text().split()[1])
            found.append(pages * resource.getpagesize() / 1e6)
            print(f"{(n + 1) * 10} %: {found[-1]:.0f} MB", file=sys.stderr, flush=True)
    return found


def batched(every: list[Item], size: int) -> Iterator[list[Item]]:
    """So many at a time."""
    for begin in range(0, len(every), size):
        yield every[begin : begin + size]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--each", type=int, default=100)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--profile", action="store_true")
    parser.add_argument("--memory", type=int)
    asked = parser.parse_args()
    if asked.memory is not None:
        held = held_mb(asked.memory)
        print(json.dumps(held) if asked.json else ", ".join(f"{mb:.0f} MB" for mb in held))
        return int(held[-1] > GROWS * held[1])
    profile = cProfile.Profile() if asked.profile else None
    found = [measured(2, asked.each, profile), measured(10, max(1, asked.each // 5), profile)]
    if asked.json:
        print(json.dumps(found, indent=2))
    else:
        for row in found:
            steps = ", ".join(f"{name} {row[f'{name}_ms']:.0f}" for name in STEPS[:-1])
            print(
                f"{row['cars']:2} cars: {row['per_s']:.1f}/s, median {row['median_per_s']:.1f} "
                f"(goal {row['goal_per_s']:g}); "
                f"{row['made']} made, {row['failed']} failed, {row['said']} as said, "
                f"{row['reached']} reached; ms of the clock: {steps}"
            )
    if profile is not None:
        pstats.Stats(profile).sort_stats("tottime").print_stats(30)
    return 0


if __name__ == "__main__":
    sys.exit(main())
