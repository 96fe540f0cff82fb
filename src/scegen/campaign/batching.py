"""What is left to make, in batches that take about as long: longest first, one plan together."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import pyarrow.parquet as pq

from scegen.campaign.making import Batch
from scegen.campaign.store import Store

BATCH_COST_S = 4.0


@dataclass(frozen=True, slots=True)
class Work:
    """A planned item: where it stands, and about how long it takes."""

    key: str
    plan: Path
    number: int
    cost_s: float


def works_of(store: Store, keys: list[str], missing: set[str]) -> list[Work]:
    """The items that are not made yet."""
    works: list[Work] = []
    for key, path in store.plans().items():
        if key not in keys:
            continue
        table = pq.read_table(path, columns=["key", "cost"])
        for number, (item, cost) in enumerate(
            zip(table.column("key").to_pylist(), table.column("cost").to_pylist(), strict=True)
        ):
            if item in missing:
                works.append(Work(item, path, number, cost))
    return works


def batches_of(works: list[Work], most: int, workers: int) -> list[Batch]:
    """Items that take about as long together, those of a plan beside one another, longest first.

    Every worker gets several, so that all end at about the same time.
    """
    whole = sum(work.cost_s for work in works)
    limit = min(BATCH_COST_S, max(whole / (8 * workers), 0.1))
    batches: list[list[Work]] = [[]]
    cost = 0.0
    for work in sorted(works, key=lambda work: (-work.cost_s, work.plan.name, work.number)):
        if batches[-1] and (cost + work.cost_s > limit or len(batches[-1]) >= most):
            batches.append([])
            cost = 0.0
        batches[-1].append(work)
        cost += work.cost_s
    return [_batch(works) for works in batches if works]


def _batch(works: list[Work]) -> Batch:
    plans: dict[Path, list[int]] = {}
    for work in works:
        plans.setdefault(work.plan, []).append(work.number)
    return tuple((path, tuple(numbers)) for path, numbers in plans.items())
