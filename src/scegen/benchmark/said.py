"""From the sentence to what runs: are the facts of a description true when its files are played?

A judge of the user's choice decides, a Python file with ``judge(facts, path)``: it reads a
recording in the layout of esmini's CSV log and gives back (fact, expected, measured, holds).
"""

import importlib.util
import json
import tempfile
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from scegen.benchmark.understand import Record, Understand, about_the_text, offline
from scegen.checking.recording import Player, record
from scegen.checking.subject import CONCRETE_FILE, SCENARIO_FILE
from scegen.errors import InputError, ScegenError
from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, Options
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load, read_text

JUDGE_FILE = "judge_catalogue.py"
Judge = Callable[[dict[str, Any], str], list[tuple[str, Any, Any, bool]]]
"""(facts, path of a recording) → (fact, expected, measured, holds)."""


@dataclass(frozen=True, slots=True)
class Fact:
    """One fact, as expected and as measured."""

    name: str
    expected: Any
    measured: Any
    holds: bool


@dataclass(frozen=True, slots=True)
class Row:
    """One description: its facts, who played it, or why nothing could be judged.

    ``missed`` are the statements of which the program itself says that they do not hold,
    ``left_out`` the words of which it says that no field expresses them.
    """

    record: Record
    facts: tuple[Fact, ...] = ()
    player: Player | None = None
    problem: str | None = None
    missed: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()

    @property
    def right(self) -> bool:
        """Whether every fact holds."""
        return self.problem is None and all(fact.holds for fact in self.facts)

    @property
    def unsaid(self) -> bool:
        """Whether it runs otherwise than said and the program says nothing of it at all."""
        return not (self.right or self.problem or self.missed or self.left_out)

    def to_data(self) -> dict[str, Any]:
        """As data that JSON can hold."""
        return {
            "id": self.record.id,
            "text": self.record.text,
            "right": self.right,
            "player": self.player,
            "problem": self.problem,
            "missed": list(self.missed),
            "left_out": list(self.left_out),
            "facts": [
                {"fact": f.name, "expected": f.expected, "measured": f.measured, "holds": f.holds}
                for f in self.facts
            ],
        }


def load_records(file: Path) -> list[Record]:
    """The records of a file with one JSON object a line: ``id``, ``text``, ``facts``.

    Raises:
        InputError: the file cannot be read, or a line is no record.
    """
    records = []
    for number, line in enumerate(read_text(file).splitlines(), start=1):
        if not line.strip():
            continue
        try:
            data = json.loads(line)
            records.append(Record(str(data["id"]), str(data["text"]), dict(data["facts"])))
        except (ValueError, KeyError, TypeError, RecursionError) as error:
            raise InputError(
                "is no record with id, text and facts", where=f"{file}, line {number}"
            ) from error
    if not records:
        raise InputError("holds no record", where=str(file))
    return records


def load_judge(file: Path) -> Judge:
    """The judge in a Python file.

    Raises:
        InputError: there is no such file, or no judge in it.
    """
    spec = importlib.util.spec_from_file_location("scegen_judge", file)
    if not file.is_file() or spec is None or spec.loader is None:
        raise InputError("there is no judge", where=str(file), hint="name one with --judge")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    judge = getattr(module, "judge", None)
    if not callable(judge):
        raise InputError("has no function judge(facts, path)", where=str(file))
    found: Judge = judge
    return found


def run(
    records: Iterable[Record],
    judge: Judge,
    understand: Understand = offline,
    *,
    seed: int = 0,
    only: Collection[str] = (),
    progress: Callable[[str], None] = lambda _: None,
) -> Iterator[Row]:
    """Every description, or those with these ids only, as files, played and judged.

    Raises:
        StoppedError: nobody is left who could read.
        InputError: the settings of who reads cannot be used, or a recording of it.
    """
    for item in records:
        if only and item.id not in only:
            continue
        progress(item.id)
        with tempfile.TemporaryDirectory(prefix="scegen-said-") as folder:
            yield _row(item, judge, understand, seed, Path(folder))


def _row(item: Record, judge: Judge, understand: Understand, seed: int, folder: Path) -> Row:
    try:
        functional = understand(item, 1)
    except InputError as error:
        if not about_the_text(error):
            raise
        return Row(item, problem=error.render())
    try:
        made = generate(functional, folder / "made", Options(seed=seed, depth=CheckDepth.NONE))
        scenario = made.folder / "scenarios" / next(iter(made.checks)) / SCENARIO_FILE
        concrete = load(scenario.with_name(CONCRETE_FILE), ConcreteScenario)
        recorded = record(scenario, concrete)
        played = folder / "played.csv"
        played.write_text(recorded.csv, encoding="utf-8")
        facts = _judged(judge, item.facts, played)
    except ScegenError as error:
        return Row(item, problem=error.render())
    missed = tuple(claim.statement for claim in made.proofs[concrete.name].missed)
    left_out = tuple(phrase.text for phrase in functional.unsupported)
    return Row(item, facts, recorded.player, missed=missed, left_out=left_out)


def _judged(judge: Judge, facts: dict[str, Any], played: Path) -> tuple[Fact, ...]:
    """What a judge measures.

    Raises:
        InputError: the judge, which is the user's own code, fails.
    """
    try:
        return tuple(Fact(*fact) for fact in judge(facts, str(played)))
    except Exception as failure:  # noqa: BLE001 - whatever the user's code does
        message = f"failed on the recording: {type(failure).__name__}: {failure}"
        raise InputError(
            message, where="the judge", hint="mend it, or leave the fact out"
        ) from None


def tally(rows: Iterable[Row]) -> dict[str, tuple[int, int]]:
    """By fact, how often it holds and how often it is asked for; nothing made holds nothing."""
    holds: Counter[str] = Counter()
    asked: Counter[str] = Counter()
    for row in rows:
        measured = row.facts or [
            Fact(name, value, None, holds=False) for name, value in row.record.facts.items()
        ]
        asked.update(fact.name for fact in measured)
        holds.update(fact.name for fact in measured if fact.holds)
    return {name: (holds[name], asked[name]) for name in sorted(asked)}
