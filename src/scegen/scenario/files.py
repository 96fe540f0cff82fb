"""Scenario files: every level as YAML or JSON, read back with errors that name the place."""

import json
import re
from pathlib import Path
from typing import Any, TypeVar

import yaml
from pydantic import ValidationError

from scegen.errors import InputError, VocabularyError
from scegen.scenario.complaints import found, in_words
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.consistency import require_consistent
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.glossary import explain
from scegen.scenario.logical import LogicalSet
from scegen.scenario.model import FrozenModel
from scegen.scenario.parsing import parse

LEVELS: dict[str, type[FunctionalScenario | LogicalSet | ConcreteScenario]] = {
    "functional": FunctionalScenario,
    "logical": LogicalSet,
    "concrete": ConcreteScenario,
}
_MADE_BY = {
    "functional": "scegen understand writes one",
    "logical": "scegen enumerate writes one, with -o logical.json",
    "concrete": "scegen concretize writes one, and scegen generate with its files",
}
AnyLevel = FunctionalScenario | LogicalSet | ConcreteScenario
M = TypeVar("M", bound=FrozenModel)
ENDINGS = (".yaml", ".yml", ".json")
"""Of the names of scenario files."""
_SCENARIO = re.compile(r"\A\s*\{|^level:", re.MULTILINE)
_DUMPER: type = getattr(yaml, "CSafeDumper", yaml.SafeDumper)


def to_yaml(model: FrozenModel) -> str:
    """The model as YAML, fields in the order of their definition."""
    data = model.model_dump(mode="json")
    text: str = yaml.dump(data, Dumper=_DUMPER, sort_keys=False, allow_unicode=True, width=100)
    return text


def to_json(model: FrozenModel) -> str:
    """The model as indented JSON, with a final newline; logical scenarios take a line each."""
    data = model.model_dump(mode="json")
    if not isinstance(model, LogicalSet):
        return json.dumps(data, indent=2, ensure_ascii=False) + "\n"
    lines = [json.dumps(scenario, ensure_ascii=False) for scenario in data.pop("scenarios")]
    head = json.dumps(data, indent=2, ensure_ascii=False).removesuffix("\n}")
    listed = "[\n    " + ",\n    ".join(lines) + "\n  ]" if lines else "[]"
    return f'{head},\n  "scenarios": {listed}\n}}\n'


def from_data(cls: type[M], data: object, *, where: str) -> M:
    """Validate plain data; VocabularyError names the first wrong fields."""
    try:
        return cls.model_validate(data)
    except ValidationError as error:
        raise VocabularyError(in_words(error, cls, data), where=where) from error


def read_bytes(path: Path) -> bytes:
    """A file's bytes; InputError if it is missing or cannot be read."""
    try:
        return path.read_bytes()
    except OSError as error:
        raise InputError(
            f"cannot be read: {error.strerror}", where=str(path), hint="check the path"
        ) from error


def read_text(path: Path) -> str:
    """A file's text, without a byte order mark; InputError if it cannot be read."""
    return text_of(read_bytes(path), where=str(path))


def text_of(content: bytes, *, where: str) -> str:
    """The text of a file's bytes, without a byte order mark; InputError if they are none."""
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError("is not UTF-8 text", where=where, hint="save it as UTF-8") from error
    if "\0" in text:
        raise InputError("is no text: it holds binary data", where=where)
    return text.replace("\r\n", "\n").replace("\r", "\n")


def load(path: Path, cls: type[M]) -> M:
    """Read one level from a file."""
    data, level = _data_and_level(read_text(path), str(path))
    if LEVELS[level] is not cls:
        wanted = next(name for name, model in LEVELS.items() if model is cls)
        raise VocabularyError(
            f"is a {level} file, not a {wanted} scenario", where=str(path), hint=_MADE_BY[wanted]
        )
    return _whole(cls, data, str(path))


def load_if_there(path: Path, cls: type[M]) -> M | None:
    """Read one level from a file; None if there is no file."""
    return load(path, cls) if path.is_file() else None


def load_any(path: Path) -> AnyLevel | None:
    """Read whatever level the file holds; None if the file is not a scenario file."""
    text = read_text(path)
    return from_text(text, where=str(path)) if is_scenario(text, path.name) else None


def is_scenario(text: str, name: str = "") -> bool:
    """Whether a text, of a file of that name, is that of a scenario and no description."""
    return name.lower().endswith(ENDINGS) or _SCENARIO.search(text) is not None


def from_text(text: str, *, where: str) -> AnyLevel:
    """Read whatever level the text of a file holds; ``where`` names it in errors."""
    data, level = _data_and_level(text, where)
    return _whole(LEVELS[level], data, where)


def json_schema(level: str) -> dict[str, Any]:
    """The published JSON Schema of a level, with every word defined."""
    if level not in LEVELS:
        raise VocabularyError(f"unknown level {level!r}", hint=f"one of {', '.join(LEVELS)}")
    return explain(LEVELS[level].model_json_schema(mode="validation"))


def _whole(cls: type[M], data: object, where: str) -> M:
    found = from_data(cls, data, where=where)
    if isinstance(found, LogicalSet):
        require_consistent(found, where=where)
    return found


def _data_and_level(text: str, where: str) -> tuple[object, str]:
    data = parse(text, where=where)
    level = data.get("level") if isinstance(data, dict) else None
    if isinstance(level, str) and level in LEVELS:
        return data, level
    message = "is empty" if data is None else f"is no scenario file: its level is {found(level)}"
    raise VocabularyError(
        message, where=where, hint=f"a scenario file starts with 'level: {' | '.join(LEVELS)}'"
    )
