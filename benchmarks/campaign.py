"""What a campaign makes in a second of one processor, by number of cars, and where the time goes.

    python benchmarks/campaign.py [--each N] [--json] [--profile]

Pairs of files with search, claims, judgement, own checks and storing, no pictures, in one process;
N of two cars and a fifth as many of ten, drawn evenly from the plan. Time is that
of the processor, kernels are warm.
"""

from __future__ import annotations

import argparse
import cProfile
import json
import pstats
import tempfile
from pathlib import Path
from time import process_time

import pyarrow.parquet as pq

from scegen.campaign.making import make_item, warm
from scegen.campaign.order import Campaign, Described
from scegen.campaign.planning import items, plan_description
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


def measured(cars: int, count: int, profile: cProfile.Profile | None) -> dict[str, object]:
    texts = tuple(Described(id=f"d{n}", text=text) for n, text in enumerate(TEXTS[cars]))
    order = Campaign(descriptions=texts, count=8, concretizations=5)
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
        step = max(1, len(every) // count)
        chosen = every[::step][:count]
        make_item(store, order, chosen[0])
        if profile is not None:
            profile.enable()
        begin = process_time()
        rows = [make_item(store, order, item) for item in chosen]
        store.settle(row[name] for row in rows for name in OBJECT_COLUMNS if row.get(name))
        store.write_batch(table_of(rows))
        seconds = process_time() - begin
        if profile is not None:
            profile.disable()
    made = [row for row in rows if row["status"] == "made"]
    return {
        "cars": cars,
        "made": len(made),
        "failed": len(rows) - len(made),
        "said": sum(row["claims"] == row["claims_held"] for row in made),
        "reached": sum(bool(row["reached"]) for row in made),
        "per_s": len(rows) / seconds,
        "goal_per_s": GOALS[cars],
        **{
            f"{name}_ms": 1e3 * sum(row.get(f"{SECONDS}_{name}") or 0.0 for row in rows) / len(rows)
            for name in STEPS
        },
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--each", type=int, default=100)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--profile", action="store_true")
    asked = parser.parse_args()
    profile = cProfile.Profile() if asked.profile else None
    found = [measured(2, asked.each, profile), measured(10, max(1, asked.each // 5), profile)]
    if asked.json:
        print(json.dumps(found, indent=2))
    else:
        for row in found:
            steps = ", ".join(f"{name} {row[f'{name}_ms']:.0f}" for name in STEPS[:-1])
            print(
                f"{row['cars']:2} cars: {row['per_s']:.1f}/s (goal {row['goal_per_s']:g}); "
                f"{row['made']} made, {row['failed']} failed, {row['said']} as said, "
                f"{row['reached']} reached; ms of the clock: {steps}"
            )
    if profile is not None:
        pstats.Stats(profile).sort_stats("tottime").print_stats(30)


if __name__ == "__main__":
    main()
