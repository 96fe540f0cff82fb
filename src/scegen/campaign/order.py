"""What a campaign is to make: RUN.yaml, or a list of descriptions with the usual answers."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Literal

from pydantic import Field

from scegen.criticality.target import parse_target
from scegen.errors import InputError
from scegen.pipeline.options import OscVersion
from scegen.pipeline.raising import NO_SEARCH
from scegen.scenario.files import from_data, read_text
from scegen.scenario.model import CheckedModel
from scegen.scenario.parsing import parse
from scegen.scenario.vocabulary import ArmsMode, Reduction

MOST_POINTS = 10_000
"""More points than this no sweep of one description has."""
_ROUNDING = 1e-9


class Described(CheckedModel):
    """One description: its words, or the functional.yaml in which it is understood already."""

    id: str = Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9_.-]*$", max_length=80)
    text: str | None = Field(default=None, min_length=1)
    file: str | None = None

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        if (self.text is None) == (self.file is None):
            yield f"{self.id}: give either its text or a file"


class Sweep(CheckedModel):
    """The values that one parameter takes: from, to, step, both ends included, or a list."""

    first: float | None = Field(default=None, alias="from")
    to: float | None = None
    step: float | None = Field(default=None, gt=0)
    values: tuple[float, ...] = ()

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        steps = (self.first, self.to, self.step)
        if bool(self.values) == any(value is not None for value in steps):
            yield "give either from, to and step, or values"
        if not self.values and (self.first is None or self.to is None or self.step is None):
            yield "from, to and step belong together"
        if self.first is not None and self.to is not None and self.first > self.to:
            yield f"from {self.first:g} lies above to {self.to:g}"
        if self.count > MOST_POINTS:
            yield f"{self.count:,} values are more than {MOST_POINTS:,}"

    @property
    def count(self) -> int:
        """How many values there are."""
        if self.first is None or self.to is None or self.step is None:
            return len(self.values)
        return int((self.to - self.first) / self.step + _ROUNDING) + 1

    @property
    def points(self) -> tuple[float, ...]:
        """The values, in order; ``to`` is the last one if steps lead there."""
        if self.first is None or self.to is None or self.step is None:
            return self.values
        return tuple(round(self.first + n * self.step, 9) for n in range(self.count))


class Campaign(CheckedModel):
    """All that decides what a campaign makes.

    ``descriptions`` stand here or in ``files`` beside this one (JSON lines with ``id`` and
    ``text``, a text with one description a line, or functional.yaml). Of each, ``pick`` names
    logical scenarios (``all``, numbers, names); without it the ``count`` richest are made.
    ``where`` and ``rules`` narrow them first. Of each logical scenario there is one for every
    point of the ``sweep`` and, there, ``concretizations`` with parameters spread over their
    ranges. ``target`` is what the danger is raised to (``none``: no search); ``check``: whether
    our own checkers look at the files; ``confirm`` is the share that esmini plays as well.
    """

    level: Literal["campaign"] = "campaign"
    descriptions: tuple[Described, ...] = ()
    files: tuple[str, ...] = ()
    pick: str | None = None
    count: int = Field(default=1, ge=1)
    where: str | None = None
    rules: str | None = None
    reduction: Reduction = Reduction.EXACT
    arms: ArmsMode = ArmsMode.DISTINCT
    concretizations: int = Field(default=1, ge=1, le=10_000)
    sweep: dict[str, Sweep] = Field(default_factory=dict)
    target: str | None = None
    seed: int = Field(default=0, ge=0)
    check: bool = True
    confirm: float = Field(default=0.0, ge=0.0, le=1.0)
    pictures: bool = False
    osc: OscVersion = OscVersion.V1_0

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        if self.target is not None and self.target.strip().lower() != NO_SEARCH:
            parse_target(self.target)
        points = 1
        for sweep in self.sweep.values():
            points *= sweep.count
        if points > MOST_POINTS:
            yield f"the sweep has {points:,} points, more than {MOST_POINTS:,}"


def load_campaign(path: Path, changes: dict[str, Any]) -> Campaign:
    """The campaign of a file, complete: descriptions of other files stand in it.

    ``changes`` are fields that are given otherwise, and stand above those of the file.

    Raises:
        InputError: a file cannot be used; says which, where, and what may stand there.
    """
    data: dict[str, Any] = {}
    files = [path]
    if path.suffix.lower() in {".yaml", ".yml", ".json"}:
        found = parse(read_text(path), where=str(path))
        if not isinstance(found, dict) or found.get("level") != "functional":
            data = dict(found) if isinstance(found, dict) else {"level": found}
            files = [path.parent / name for name in _names(data.get("files"))]
    campaign = from_data(Campaign, data | changes, where=str(path))
    listed = [_beside(path, described) for described in campaign.descriptions]
    listed += [described for file in files for described in _descriptions(file)]
    if not listed:
        raise InputError("names no description", where=str(path), hint="see scegen schema campaign")
    seen: set[str] = set()
    for described in listed:
        if described.id in seen:
            raise InputError(f"two descriptions are called {described.id!r}", where=str(path))
        seen.add(described.id)
    rules = campaign.rules and str(path.parent / campaign.rules)
    return campaign.but(descriptions=tuple(listed), files=(), rules=rules or None)


def _names(value: object) -> list[str]:
    """Whatever else stands there is told by the model."""
    return [name for name in value if isinstance(name, str)] if isinstance(value, list) else []


def _beside(path: Path, described: Described) -> Described:
    if described.file is None:
        return described
    return described.but(file=str(path.parent / described.file))


def _descriptions(file: Path) -> list[Described]:
    suffix = file.suffix.lower()
    if suffix in {".yaml", ".yml"}:
        return [from_data(Described, {"id": file.stem, "file": str(file)}, where=str(file))]
    lines = [(n, line) for n, line in enumerate(read_text(file).splitlines(), 1) if line.strip()]
    if suffix != ".jsonl":
        width = len(str(len(lines)))
        return [
            Described(id=f"{file.stem}-{number:0{width}d}", text=line.strip())
            for number, (_, line) in enumerate(lines, start=1)
        ]
    found = []
    for number, line in lines:
        where = f"{file}, line {number}"
        try:
            record = json.loads(line)
        except (ValueError, RecursionError) as error:
            raise InputError("is no JSON", where=where) from error
        if not isinstance(record, dict):
            raise InputError("is no object with id and text", where=where)
        known = {name: record[name] for name in ("id", "text", "file") if name in record}
        found.append(_beside(file, from_data(Described, known, where=where)))
    return found
