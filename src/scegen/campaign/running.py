"""A campaign from its order to a complete table: plan, make what is not made, put together."""

from __future__ import annotations

import fcntl
import json
import platform
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from importlib.metadata import version
from pathlib import Path
from time import perf_counter
from typing import Any, Protocol

import pyarrow.parquet as pq

from scegen import __version__
from scegen.campaign.engines import WorkerLostError, Workforce
from scegen.campaign.examining import Examined, examine
from scegen.campaign.making import Batch, Done, enlist, make_batch, warm
from scegen.campaign.order import Campaign, Described
from scegen.campaign.planning import content_of, plan_description, plan_key
from scegen.campaign.rows import FAILED, table_of
from scegen.campaign.store import Store, StoreError, digest, sound
from scegen.campaign.table import write_table
from scegen.errors import InputError

FORMAT = 1
BATCH_COST_S = 4.0
MOST_IN_BATCH = 64
_ROUNDS = 3
"""So often a batch may lose its worker; then its items go one by one, and then they fail."""
_LIBRARIES = ("clingo", "cmaes", "numba", "numpy", "pyarrow", "scenariogeneration", "shapely")


class Watch(Protocol):
    """Who is told how far it is."""

    def planning(self, done: int, total: int) -> None:
        """So many descriptions are planned."""

    def making(self, done: int, failed: int, total: int) -> None:
        """So many scenarios are done, those that failed among them."""

    def note(self, text: str) -> None:
        """Something that the person should know."""


@dataclass(frozen=True, slots=True)
class Finished:
    """What a run has come to: rows in all, those that failed, those made now, and in what time."""

    rows: int
    failed: int
    fresh: int
    seconds: float
    digest: str


@dataclass(frozen=True, slots=True)
class _Work:
    """A planned item: where it stands, and about how long it takes."""

    key: str
    plan: Path
    number: int
    cost_s: float


def run_campaign(campaign: Campaign, folder: Path, workforce: Workforce, watch: Watch) -> Finished:
    """Make a campaign in ``folder``, or what is missing of it.

    Raises:
        InputError: the folder holds something else, or cannot be written.
        MissingToolError: the engine is not installed.
    """
    begin = perf_counter()
    store = Store(folder)
    _claim(store, campaign)
    with _alone(folder):
        store.tidy()
        distinct = _distinct(campaign, watch)
        keys = [plan_key(campaign, described) for described in distinct]
        _plan(store, campaign, dict(zip(keys, distinct, strict=True)), workforce, watch)
        found = _examined(store, keys, watch)
        _keep_manifest(store, campaign, keys, None)
        fresh = _make(store, campaign, keys, found, workforce, watch)
        found = _examined(store, keys, watch)
        if found.missing:
            raise StoreError(
                f"{len(found.missing)} scenarios are missing, as files were changed meanwhile",
                where=str(folder),
                hint="the same command goes on",
            )
        rows, failed = write_table(store)
        told = _digest(found)
        finished = Finished(rows, failed, fresh, perf_counter() - begin, told)
        _keep_manifest(store, campaign, keys, finished)
    return finished


def verify(folder: Path) -> tuple[Examined, list[str]]:
    """Look at every file of a campaign, and hold every row against its digest; changes nothing.

    The second part says what is wrong beside single files.

    Raises:
        InputError: there is no campaign.
    """
    store = Store(folder)
    manifest = store.manifest()
    if not manifest:
        raise InputError("holds no campaign", where=str(folder))
    keys = [str(key) for key in manifest.get("plans", ())]
    found = examine(store, keys, rows=True)
    problems = []
    if not keys:
        problems.append("the plan is not finished")
    if not found.plans_whole:
        problems.append("a plan is missing or broken: what there is to make is not known")
    if found.missing:
        problems.append(f"{len(found.missing):,} of {len(found.planned):,} scenarios are missing")
    finished = manifest.get("finished")
    if finished and not found.bad and not problems and finished["digest"] != _digest(found):
        problems.append("the rows are not those of which the manifest tells")
    if finished and not _table_sound(store, found):
        problems.append(f"{store.table.name} does not hold the rows of the batches")
    return found, problems


def _table_sound(store: Store, found: Examined) -> bool:
    """Whether the table has every row once."""
    try:
        table = pq.read_table(store.table, columns=["key", "row_digest"])
    except (OSError, ValueError):
        return False
    keys, digests = (table.column(name).to_pylist() for name in ("key", "row_digest"))
    return (
        len(keys) == len(found.digests) and dict(zip(keys, digests, strict=True)) == found.digests
    )


def _digest(found: Examined) -> str:
    """One digest for all rows, whatever their order."""
    return digest("".join(f"{k}{v}" for k, v in sorted(found.digests.items())).encode())


def _claim(store: Store, campaign: Campaign) -> None:
    """Begin a folder, or go on in one of the same campaign.

    Raises:
        InputError: something else lies there.
    """
    folder = store.folder
    if folder.exists() and not folder.is_dir():
        raise InputError("is a file, not a folder", where=str(folder), hint="choose another -o")
    manifest = store.manifest() if folder.exists() else {}
    if not manifest:
        if folder.exists() and any(p for p in folder.iterdir() if not p.name.startswith(".")):
            raise InputError(
                "is not empty and holds no campaign", where=str(folder), hint="choose another -o"
            )
        _keep_manifest(store, campaign, [], None)
        return
    order = _order(campaign)
    earlier = manifest.get("campaign", {})
    differing = sorted(name for name in {*order, *earlier} if order.get(name) != earlier.get(name))
    if manifest.get("scegen") != __version__ or manifest.get("format") != FORMAT:
        differing.insert(0, f"version {manifest.get('scegen')}")
    if differing:
        raise InputError(
            f"holds another campaign: it differs in {', '.join(differing)}",
            where=str(folder),
            hint="choose another -o, or give the same order to go on",
        )


def _order(campaign: Campaign) -> dict[str, Any]:
    """The campaign as the manifest keeps it."""
    data: dict[str, Any] = json.loads(campaign.model_dump_json(by_alias=True))
    return data


def _keep_manifest(
    store: Store, campaign: Campaign, keys: list[str], finished: Finished | None
) -> None:
    manifest: dict[str, Any] = {
        "format": FORMAT,
        "scegen": __version__,
        "python": platform.python_version(),
        "libraries": {name: version(name) for name in _LIBRARIES},
        "campaign": _order(campaign),
        "plans": keys,
    }
    if finished is not None:
        manifest["finished"] = {
            "rows": finished.rows,
            "failed": finished.failed,
            "digest": finished.digest,
        }
    store.write_manifest(manifest)


@contextmanager
def _alone(folder: Path) -> Iterator[None]:
    """Nobody else works in the folder meanwhile; a process that ends, however, lets go of it."""
    with (folder / ".lock").open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise InputError("another command works here", where=str(folder)) from error
        yield


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
    for number, _ in enumerate(workforce.each(work, left, warm, enlist), start=1):
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
        batches = batches_of(_works(store, keys, found.missing), most, workforce.workers)
        before_round = len(found.done)
        try:
            made: Done
            for made in workforce.each(work, batches, warm, enlist):
                done, failed = done + made.made + made.failed, failed + made.failed
                watch.making(done, failed, total)
        except WorkerLostError as error:
            found = examine(store, keys)
            done = len(found.done)
            losses = 0 if done > before_round else losses + 1
            watch.note(f"a worker died ({_first_line(error)}); {total - done} are left")
            most = 1 if losses else max(1, most // 2)
            if losses >= _ROUNDS:
                _give_up(store, _works(store, keys, found.missing))
                losses = 0
        found = examine_done(store, found)
    return len(found.done) - before


def examine_done(store: Store, found: Examined) -> Examined:
    """The keys of all batches, as they are now."""
    done = {
        key
        for path in store.batches()
        for key in pq.read_table(path, columns=["key"]).column("key").to_pylist()
    }
    return Examined(done=done, planned=found.planned)


def _first_line(error: Exception) -> str:
    return str(error).strip().partition("\n")[0]


def _give_up(store: Store, works: list[_Work]) -> None:
    """The first of those that are left kills its worker every time: a row says so."""
    first = works[0]
    plan = pq.read_table(first.plan).slice(first.number, 1).to_pylist()[0]
    row = {
        "key": first.key,
        "description": plan["description"],
        "functional": plan["functional"],
        "sweep": dict(plan["point"] or []),
        "concretization": plan["concretization"],
        "seed": plan["seed"],
        "status": FAILED,
        "stage": "worker",
        "reason": f"its worker died {_ROUNDS} times",
    }
    store.write_batch(table_of([row]))


def _works(store: Store, keys: list[str], missing: set[str]) -> list[_Work]:
    """The items that are not made yet."""
    works = []
    for key, path in store.plans().items():
        if key not in keys:
            continue
        table = pq.read_table(path, columns=["key", "cost"])
        for number, (item, cost) in enumerate(
            zip(table.column("key").to_pylist(), table.column("cost").to_pylist(), strict=True)
        ):
            if item in missing:
                works.append(_Work(item, path, number, cost))
    return works


def batches_of(works: list[_Work], most: int, workers: int) -> list[Batch]:
    """Items that take about as long together, those of a plan beside one another, longest first.

    Every worker gets several, so that all end at about the same time.
    """
    whole = sum(work.cost_s for work in works)
    limit = min(BATCH_COST_S, max(whole / (8 * workers), 0.1))
    batches: list[list[_Work]] = [[]]
    cost = 0.0
    for work in sorted(works, key=lambda work: (-work.cost_s, work.plan.name, work.number)):
        if batches[-1] and (cost + work.cost_s > limit or len(batches[-1]) >= most):
            batches.append([])
            cost = 0.0
        batches[-1].append(work)
        cost += work.cost_s
    return [_batch(works) for works in batches if works]


def _batch(works: list[_Work]) -> Batch:
    plans: dict[Path, list[int]] = {}
    for work in works:
        plans.setdefault(work.plan, []).append(work.number)
    return tuple((path, tuple(numbers)) for path, numbers in plans.items())
