"""The plan: what there is to make of one description, every item named by its content.

An item's key is the digest of all that decides what comes of it, and its seed is a part of the
key: neither order nor number of descriptions, batches or workers changes anything.
"""

import json
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from scegen import __version__
from scegen.campaign.order import Campaign, Described
from scegen.campaign.parameters import at_point, points
from scegen.campaign.rows import Row, cells
from scegen.campaign.store import Store
from scegen.enumeration import LIST_LIMIT, enumerate_scenarios
from scegen.errors import NoScenarioError, ScegenError
from scegen.pipeline.folder import digest
from scegen.pipeline.picking import pick
from scegen.pipeline.source import functional_of
from scegen.scenario.files import read_text, to_json
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario, LogicalSet
from scegen.scenario.rule_file import RuleFile
from scegen.understanding import read

LEFT_OUT = b"left_out"
"""Metadata of a plan: what scenarios show that the campaign leaves out, with how many do."""
_PLAN = pa.schema(
    [
        *((name, pa.string()) for name in ("key", "description", "functional", "logical")),
        ("point", pa.map_(pa.string(), pa.float64())),
        *((name, pa.int64()) for name in ("concretization", "seed")),
        ("cost", pa.float64()),
        *((name, pa.string()) for name in ("stage", "reason")),
    ]
)
_SEED_DIGITS = 13
"""Hexadecimal digits of a key that are its seed: any reader of JSON holds 52 bits exactly."""


@dataclass(frozen=True, slots=True)
class Item:
    """One piece of work; with a ``reason`` there is nothing to make, since ``stage`` failed."""

    key: str
    description: str
    functional: str | None
    logical: str | None
    point: dict[str, float]
    concretization: int
    seed: int
    stage: str | None
    reason: str | None

    @property
    def row(self) -> Row:
        """What its row says whatever comes of it."""
        return {
            "key": self.key,
            "description": self.description,
            "functional": self.functional,
            "sweep": self.point,
            "concretization": self.concretization,
            "seed": self.seed,
        }


def content_of(described: Described) -> str:
    """What a description says, whatever it is called.

    Raises:
        InputError: its file cannot be read.
    """
    return described.text or read_text(Path(str(described.file)))


def plan_key(campaign: Campaign, described: Described) -> str:
    """The digest of all that decides which items there are.

    Raises:
        InputError: a file cannot be read.
    """
    told = campaign.model_dump(mode="json", exclude={"descriptions", "files"}, by_alias=True)
    if campaign.rules is not None:
        told["rules"] = read_text(Path(campaign.rules))
    parts = [__version__, told, described.id, content_of(described)]
    return digest(json.dumps(parts, sort_keys=True).encode())


def plan_description(store: Store, campaign: Campaign, described: Described) -> None:
    """Understand one description, list its scenarios, and write down what is to be made of it."""
    rows: list[dict[str, Any]] = []
    left_out: dict[str, int] = {}
    try:
        text, file = described.text, described.file
        functional = read(text) if text is not None else functional_of(str(file))
    except ScegenError as error:
        rows.append(_failure(campaign, described, {}, "understand", error))
    else:
        for number, point in enumerate(points(campaign.sweep)):
            try:
                made, missed = _at_point(store, campaign, described, functional, point)
            except ScegenError as error:
                rows.append(_failure(campaign, described, point, "enumerate", error))
                continue
            rows += made
            left_out = missed if number == 0 else left_out
    table = pa.Table.from_pylist(rows, _PLAN)
    table = table.replace_schema_metadata({LEFT_OUT: json.dumps(left_out).encode()})
    store.write_plan(plan_key(campaign, described), table)


def _at_point(
    store: Store,
    campaign: Campaign,
    described: Described,
    functional: FunctionalScenario,
    point: dict[str, float],
) -> tuple[list[dict[str, Any]], dict[str, int]]:
    """The items of one point of the sweep, and what the scenarios not picked would show."""
    functional = at_point(functional, point)
    rules = campaign.rules
    logical = enumerate_scenarios(
        functional,
        reduction=campaign.reduction,
        arms=campaign.arms,
        limit=LIST_LIMIT,
        where=campaign.where,
        rules=None if rules is None else RuleFile(read_text(Path(rules)), rules),
    )
    if not logical.scenarios:
        raise NoScenarioError("no scenario is as asked for", where=f"where {campaign.where}")
    picked = pick(logical, campaign.pick)
    picked = picked if campaign.pick else picked[: campaign.count]
    name = store.put(to_json(functional).encode(), "json")
    store.settle([name])
    rows = []
    for scenario in picked:
        content = scenario.model_dump_json()
        canonical = json.loads(content)
        # Names and numbers depend on what else is listed.
        del canonical["index"], canonical["slug"]
        for number in range(campaign.concretizations):
            key = _key(campaign, name, canonical, point, number)
            rows.append(
                {
                    "key": key,
                    "description": described.id,
                    "functional": name,
                    "logical": content,
                    "point": point,
                    "concretization": number,
                    "seed": int(key[:_SEED_DIGITS], 16),
                    "cost": _cost(functional),
                }
            )
    return rows, _left_out(logical, picked)


def _key(campaign: Campaign, *parts: object) -> str:
    order = (campaign.seed, campaign.target, campaign.concretizations, str(campaign.osc))
    return digest(json.dumps([__version__, *order, *parts], sort_keys=True).encode())


def _left_out(logical: LogicalSet, picked: tuple[LogicalScenario, ...]) -> dict[str, int]:
    """What is shown by scenarios that are listed, and by none that is picked."""
    if len(picked) == len(logical.scenarios):
        return {}
    functional = logical.functional
    held = {cell for scenario in picked for cell in cells(functional, scenario)}
    shown = Counter(cell for scenario in logical.scenarios for cell in cells(functional, scenario))
    return {cell: times for cell, times in sorted(shown.items()) if cell not in held}


def _failure(
    campaign: Campaign,
    described: Described,
    point: dict[str, float],
    stage: str,
    error: ScegenError,
) -> dict[str, Any]:
    return {
        "key": _key(campaign, stage, content_of(described), point),
        "description": described.id,
        "point": point,
        "cost": 0.0,
        "stage": stage,
        "reason": error.render(),
    }


def _cost(functional: FunctionalScenario) -> float:
    """About how many seconds one takes: every participant moves, every pair is looked at."""
    return 0.05 + 0.02 * len(functional.participants) ** 2


@lru_cache(maxsize=8)
def _table(path: Path) -> pa.Table:
    return pq.read_table(path)


def items(path: Path, numbers: list[int]) -> Iterator[Item]:
    """The items of a plan in these rows."""
    for row in _table(path).take(numbers).to_pylist():
        del row["cost"]
        yield Item(**row | {"point": dict(row["point"] or [])})
