"""A campaign from its order to a complete table: plan, make what is not made, put together."""

from __future__ import annotations

from contextlib import closing
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Protocol

from scegen.campaign.claiming import Finished, alone, claim, keep_manifest
from scegen.campaign.engines import WorkerLostError, Workforce
from scegen.campaign.examining import Examined, examine
from scegen.campaign.making import Batch, enlist, make_batch, warm
from scegen.campaign.order import Campaign, Described
from scegen.campaign.planning import content_of, items, plan_description, plan_key
from scegen.campaign.rows import FAILED, table_of
from scegen.campaign.store import Store, StoreError, column, sound
from scegen.campaign.table import write_table
from scegen.campaign.verifying import digest_of

MOST_IN_BATCH = 64
_ROUNDS = 3
"""So often a batch may lose its worker; then its items go one by one, and then they fail."""
BATCH_COST_S = 4.0


class Watch(Protocol):
    """Who is told how far it is."""

    def planning(self, done: int, total: int) -> None:
        """So many descriptions are planned."""

    def making(self, done: int, failed: int, total: int) -> None:
        """So many scenarios are done, those that failed among them."""

    def note(self, text: str) -> None:
        """Something that the person should know."""


def run_campaign(campaign: Campaign, folder: Path, workforce: Workforce, watch: Watch) -> Finished:
    """Make a campaign in ``folder``, or what is missing of it.

    Raises:
        InputError: the folder holds something else, or cannot be written.
        MissingToolError: the engine is not installed.
    """
    begin = perf_counter()
    store = Store(folder)
    claim(store, campaign)
    with alone(folder):
        store.tidy()
        distinct = _distinct(campaign, watch)
        keys = [plan_key(campaign, described) for described in distinct]
        _plan(store, campaign, dict(zip(keys, distinct, strict=True)), workforce, watch)
        found = _examined(store, keys, watch)
        keep_manifest(store, campaign, keys, None)
        fresh = _make(store, campaign, keys, found, workforce, watch)
        found = _examined(store, keys, watch)
        if found.missing:
            raise StoreError(
                f"{len(found.missing)} scenarios are missing, as files were changed meanwhile",
                where=str(folder),
                hint="the same command goes on",
            )
        finished = Finished(write_table(store), fresh, perf_counter() - begin, digest_of(found))
        keep_manifest(store, campaign, keys, finished)
    return finished


def _distinct(campaign: Campaign, watch: Watch) -> list[Described]:
    """Descriptions that say the same are made once."""
    first: dict[str, Described] = {}
    for described in campaign.descriptions:
        content = content_of(described)
        if content in first:
            watch.note(f"{described.id} says the same as {first[content].id}: it is made once")
        first.setdefault(content, described)
    return list(first.values())


def _plan(
    store: Store,
    campaign: Campaign,
    by_key: dict[str, Described],
    workforce: Workforce,
    watch: Watch,
) -> None:
    """Plan every description that has no sound plan."""
    for path in (path for key, path in store.plans().items() if key in by_key):
        if not sound(path):
            watch.note(f"{path}: is not what was written: the plan is made again")
            path.unlink()
    left = [described for key, described in by_key.items() if key not in store.plans()]
    total = len(by_key)
    watch.planning(total - len(left), total)
    work = partial(plan_description, store, campaign)
    with closing(workforce.each(work, left, warm, enlist)) as planned:
        for number, _ in enumerate(planned, start=1):
            watch.planning(total - len(left) + number, total)


def _examined(store: Store, keys: list[str], watch: Watch) -> Examined:
    """What is done; what is broken is named and removed."""
    found = examine(store, keys)
    while found.bad:
        for line in found.in_words():
            watch.note(line)
        found.remove()
        found = examine(store, keys)
    return found


def _make(
    store: Store,
    campaign: Campaign,
    keys: list[str],
    found: Examined,
    workforce: Workforce,
    watch: Watch,
) -> int:
    """Make all that is missing; gives back how many that were."""
    total = len(found.planned)
    done, failed, before = len(found.done), 0, len(found.done)
    watch.making(done, failed, total)
    work = partial(make_batch, store, campaign)
    most, losses = MOST_IN_BATCH, 0
    while found.missing:
        batches = batches_of(works_of(store, keys, found.missing), most, workforce.workers)
        before_round = len(found.done)
        try:
            with closing(workforce.each(work, batches, warm, enlist)) as results:
                for items_done, items_failed in results:
                    done, failed = done + items_done, failed + items_failed
                    watch.making(done, failed, total)
        except WorkerLostError as error:
            found = examine(store, keys)
            done = len(found.done)
            losses = 0 if done > before_round else losses + 1
            said = str(error).strip().partition("\n")[0].partition(". ")[0]
            watch.note(f"a worker died ({said}); {total - done} are left")
            most = 1 if losses else max(1, most // 2)
            if losses >= _ROUNDS:
                _give_up(store, works_of(store, keys, found.missing))
                losses = 0
        keys_done = {key for path in store.batches() for key in column(path, "key")}
        found = Examined(done=keys_done, planned=found.planned)
    return len(found.done) - before


def _give_up(store: Store, works: list[Work]) -> None:
    """The first of those that are left kills its worker every time: a row says so."""
    (item,) = items(works[0].plan, [works[0].number])
    why = {"status": FAILED, "stage": "worker", "reason": f"its worker died {_ROUNDS} times"}
    store.write_batch(table_of([item.row | why]))


@dataclass(frozen=True, slots=True)
class Work:
    """A planned item: where it stands, and about how long it takes."""

    plan: Path
    number: int
    cost_s: float


def works_of(store: Store, keys: list[str], missing: set[str]) -> list[Work]:
    """The items that are not made yet."""
    works: list[Work] = []
    for key, path in store.plans().items():
        if key not in keys:
            continue
        costs = zip(column(path, "key"), column(path, "cost"), strict=True)
        for number, (item, cost) in enumerate(costs):
            if item in missing:
                works.append(Work(path, number, cost))
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
