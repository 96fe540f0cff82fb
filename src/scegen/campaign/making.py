"""Making a batch of items, in one worker: the pipeline's functions one after the other, timed."""

import gc
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from threading import Thread
from time import perf_counter, sleep
from traceback import extract_tb

from scegen.campaign.order import Campaign
from scegen.campaign.parameters import spread
from scegen.campaign.planning import Item, items
from scegen.campaign.rows import (
    FAILED,
    FILE_COLUMNS,
    MADE,
    OBJECT_COLUMNS,
    SECONDS,
    Row,
    planned,
    shown,
    table_of,
)
from scegen.campaign.store import Store, StoreError
from scegen.checking import esmini as player
from scegen.checking import opendrive, openscenario, said, schema
from scegen.checking.check import check_subjects
from scegen.checking.results import CheckResult, worst
from scegen.checking.subject import PROOF_FILE, subject_of
from scegen.errors import ScegenError
from scegen.measures import warm_kernels
from scegen.pipeline.attempts import make_one
from scegen.pipeline.export import export_scenario
from scegen.pipeline.judging import judge
from scegen.pipeline.raising import chosen_target
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import to_json
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.proof import Proof

OWN_CHECKERS = (opendrive.CHECKER, openscenario.CHECKER, schema.CHECKER)
"""What needs neither the player nor another environment."""
PLAYED_CHECKERS = (player.CHECKER, said.CHECKER)
_SHARE_DIGITS = 8
_EMPLOYER = "SCEGEN_CAMPAIGN_EMPLOYER"
"""Where a worker process keeps the id of the process that started it."""
_LOOKS_EACH_S = 1.0
_OBJECTS_BEFORE_COLLECTING = 50_000

Batch = tuple[tuple[Path, tuple[int, ...]], ...]
"""Plans, and rows of theirs."""


@dataclass
class Clock:
    """Seconds by step, and the step that is under way or was the last."""

    seconds: dict[str, float] = field(default_factory=dict)
    stage: str = "concretize"

    @contextmanager
    def step(self, name: str) -> Iterator[None]:
        """Count the time of a step."""
        self.stage = name
        begin = perf_counter()
        try:
            yield
        finally:
            self.seconds[name] = self.seconds.get(name, 0.0) + perf_counter() - begin

    def columns(self) -> dict[str, float]:
        """The columns of a row."""
        told = {f"{SECONDS}_{name}": value for name, value in self.seconds.items()}
        return told | {SECONDS: sum(self.seconds.values())}


def warm() -> None:
    """Load what every batch needs, before the clock runs; none of that is ever garbage."""
    warm_kernels()
    gc.freeze()
    gc.set_threshold(_OBJECTS_BEFORE_COLLECTING)


def enlist(employer: int) -> None:
    """Once in a worker process of ``employer``: remember it, get warm."""
    os.environ[_EMPLOYER] = str(employer)
    Thread(target=_watch_employer, daemon=True).start()
    warm()


def _watch_employer() -> None:
    """One who waits for work is not left behind either."""
    while True:
        sleep(_LOOKS_EACH_S)
        _leave_if_alone()


def _leave_if_alone() -> None:
    """End a worker process whose employer was killed: the next one has its work made anew."""
    employer = os.environ.get(_EMPLOYER)
    if employer is not None and employer != str(os.getppid()):
        os._exit(1)


def make_batch(store: Store, campaign: Campaign, batch: Batch) -> tuple[int, int]:
    """Make the items of a batch and write them down; until that is done, nothing counts.

    Gives back how many items there are, and how many of them could not be made.

    Raises:
        StoreError: the folder cannot be written.
    """
    rows = []
    for path, numbers in batch:
        for item in items(path, list(numbers)):
            _leave_if_alone()
            rows.append(make_item(store, campaign, item))
    store.settle(row[name] for row in rows for name in OBJECT_COLUMNS if row.get(name))
    table = table_of(rows)
    _leave_if_alone()
    store.write_batch(table)
    return len(rows), sum(row["status"] == FAILED for row in rows)


def make_item(store: Store, campaign: Campaign, item: Item) -> Row:
    """The row of one item; what cannot be made is a row with its reason.

    Raises:
        StoreError: the folder cannot be written.
    """
    clock = Clock()
    row = item.row
    if item.functional is None or item.logical is None:
        return row | {"status": FAILED, "stage": item.stage, "reason": item.reason, SECONDS: 0.0}
    functional = _functional(store, item.functional)
    logical = LogicalScenario.model_validate_json(item.logical)
    row |= planned(functional, logical)
    try:
        functional, logical = spread(
            functional, logical, item.concretization, campaign.concretizations, item.seed
        )
        row["ranges"] = {p.name: [p.low, p.high] for p in logical.parameters}
        row |= _made(store, campaign, item, functional, logical, clock)
        return row | {"status": MADE} | clock.columns()
    except StoreError:
        raise
    except ScegenError as error:
        reason = error.render()
    except Exception as error:  # noqa: BLE001 - one scenario must not end the campaign
        place = extract_tb(error.__traceback__)[-1]
        told = f"{type(error).__name__}: {error} ({Path(place.filename).name}, {place.lineno})"
        reason = f"an error of the program: {told}"
    return row | {"status": FAILED, "stage": clock.stage, "reason": reason} | clock.columns()


@lru_cache(maxsize=64)
def _functional(store: Store, name: str) -> FunctionalScenario:
    return FunctionalScenario.model_validate_json(store.get(name))


def _made(
    store: Store,
    campaign: Campaign,
    item: Item,
    functional: FunctionalScenario,
    logical: LogicalScenario,
    clock: Clock,
) -> Row:
    """One concrete scenario: numbers, danger, judgement, files, checks."""
    target = chosen_target(campaign.target, functional)
    with clock.step("concretize"):
        raised = make_one(functional, logical, target, item.seed, free=campaign.target is None)
    (concrete,) = raised.concretes
    clock.seconds["search"] = raised.search_s.get(concrete.name, 0.0)
    clock.seconds["concretize"] -= clock.seconds["search"]
    proof = raised.proofs.get(concrete.name)
    with clock.step("judge"):
        row = shown(functional, concrete, proof, judge(concrete, proof))
    with clock.step("write"):
        files = export_scenario(concrete, osc=campaign.osc, picture=campaign.pictures)
        for name, content in files.items():
            row[FILE_COLUMNS[name]] = store.put(content, name.rsplit(".", 1)[1])
        if proof is not None:
            row[FILE_COLUMNS[PROOF_FILE]] = store.put(to_json(proof).encode(), "json")
    return row | _checked(campaign, item, files, concrete, functional, proof, clock)


def _checked(
    campaign: Campaign,
    item: Item,
    files: dict[str, bytes],
    concrete: ConcreteScenario,
    functional: FunctionalScenario,
    proof: Proof | None,
    clock: Clock,
) -> Row:
    """Our own checks of the files, and of a share of them what the player plays."""
    results: list[CheckResult] = []
    if campaign.check:
        with clock.step("check"):
            subject = subject_of(Path(item.key), files, concrete, functional, proof)
            results += check_subjects([subject], OWN_CHECKERS)[0].results
    confirmed = None
    if int(item.key[-_SHARE_DIGITS:], 16) < campaign.confirm * 16**_SHARE_DIGITS:
        with clock.step("confirm"), tempfile.TemporaryDirectory(prefix="scegen-") as place:
            for name, content in files.items():
                Path(place, name).write_bytes(content)
            subject = subject_of(Path(place), files, concrete, functional, proof)
            played = check_subjects([subject], PLAYED_CHECKERS)[0].results
            results += played
            confirmed = str(worst(result.status for result in played))
    return {
        "checks": {result.checker: str(result.status) for result in results},
        "check_findings": [
            f"{result.checker}: {f.place}: {f.message} [{f.rule}]"
            for result in results
            for f in result.errors
        ],
        "confirmed": confirmed,
    }
