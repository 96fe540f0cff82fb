"""The labelled sentences of the source paper, and reading labelled files."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from scegen.errors import InputError
from scegen.scenario.files import read_text


@dataclass(frozen=True, slots=True)
class Case:
    """A description with the label to judge its reading by.

    Attributes:
        id: name of the case.
        text: the description.
        expect: the label, see :func:`scegen.understanding.report.scoring.score`.
    """

    id: str
    text: str
    expect: Mapping[str, Any]


def _parse(content: str, where: str) -> tuple[Case, ...]:
    cases: list[Case] = []
    ids: set[str] = set()
    for number, line in enumerate(content.splitlines(), start=1):
        if not line.strip():
            continue
        try:
            record = json.loads(line)
            cases.append(Case(record["id"], record["text"], record["expect"]))
        except (ValueError, KeyError, TypeError, RecursionError) as error:
            msg = "a line must be a JSON object with id, text and expect"
            raise InputError(msg, where=f"{where}:{number}") from error
        if cases[-1].id in ids:
            msg = f"another line has the id {cases[-1].id!r} too"
            raise InputError(msg, where=f"{where}:{number}", hint="give each line its own")
        ids.add(cases[-1].id)
    if not cases:
        raise InputError("holds no description", where=where)
    return tuple(cases)


@lru_cache(maxsize=1)
def paper_cases() -> tuple[Case, ...]:
    """The 11 sentences of the source paper, with labels."""
    content = files(__package__).joinpath("data/paper.jsonl").read_text(encoding="utf-8")
    return _parse(content, "paper.jsonl")


def load_cases(path: Path) -> tuple[Case, ...]:
    """Labelled descriptions from a file with one JSON object a line.

    Raises:
        InputError: if the file cannot be read or a line is not a labelled description.
    """
    return _parse(read_text(path), str(path))
