"""Scenario files: every level as YAML or JSON, read back with errors that name the place."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, TypeVar

import yaml
from pydantic import ValidationError

from scegen.errors import InputError, VocabularyError
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.glossary import explain
from scegen.scenario.logical import LogicalSet
from scegen.scenario.model import FrozenModel

LEVELS: dict[str, type[FunctionalScenario | LogicalSet | ConcreteScenario]] = {
    "functional": FunctionalScenario,
    "logical": LogicalSet,
    "concrete": ConcreteScenario,
}
AnyLevel = FunctionalScenario | LogicalSet | ConcreteScenario
M = TypeVar("M", bound=FrozenModel)

_Loader: type = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
_Dumper: type = getattr(yaml, "CSafeDumper", yaml.SafeDumper)


def to_yaml(model: FrozenModel) -> str:
    """The model as YAML, fields in the order of their definition."""
    data = model.model_dump(mode="json")
    text: str = yaml.dump(data, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=100)
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
        raise VocabularyError(_in_words(error), where=where) from error


def parse(text: str, *, where: str) -> object:
    """YAML or JSON text (JSON is YAML) to plain data; VocabularyError names the line."""
    try:
        return json.loads(text) if text.lstrip().startswith("{") else yaml.load(text, _Loader)  # noqa: S506 - a safe loader
    except (yaml.YAMLError, json.JSONDecodeError) as error:
        raise VocabularyError(f"not valid YAML or JSON: {error}", where=where) from error
    except RecursionError as error:
        raise VocabularyError("nested too deeply", where=where) from error


def read_text(path: Path) -> str:
    """A file's text; InputError if it cannot be read."""
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise InputError(
            f"cannot be read: {error.strerror}", where=str(path), hint="check the path"
        ) from error
    except UnicodeDecodeError as error:
        raise InputError("is not UTF-8 text", where=str(path)) from error


def load(path: Path, cls: type[M]) -> M:
    """Read one level from a file."""
    data = parse(read_text(path), where=str(path))
    _require_level(data, cls, str(path))
    return from_data(cls, data, where=str(path))


def load_any(path: Path) -> AnyLevel | None:
    """Read whatever level the file holds; None if the file is not a scenario file."""
    if path.suffix.lower() not in {".yaml", ".yml", ".json"}:
        return None
    data = parse(read_text(path), where=str(path))
    level = data.get("level") if isinstance(data, dict) else None
    if level not in LEVELS:
        raise VocabularyError(
            f"has no known 'level' (found {level!r})",
            where=str(path),
            hint=f"a scenario file starts with 'level: {' | '.join(LEVELS)}'",
        )
    return from_data(LEVELS[level], data, where=str(path))


def json_schema(level: str) -> dict[str, Any]:
    """The published JSON Schema of a level, with every word defined."""
    if level not in LEVELS:
        raise VocabularyError(f"unknown level {level!r}", hint=f"one of {', '.join(LEVELS)}")
    return explain(LEVELS[level].model_json_schema(mode="validation"))


def _require_level(data: object, cls: type[M], where: str) -> None:
    wanted = next((name for name, model in LEVELS.items() if model is cls), None)
    found = data.get("level") if isinstance(data, dict) else None
    if wanted and found != wanted:
        raise VocabularyError(
            f"is a {found or 'nameless'} file, not a {wanted} scenario", where=where
        )


def _in_words(error: ValidationError) -> str:
    shown = []
    for item in error.errors()[:3]:
        place = ".".join(str(part) for part in item["loc"]) or "file"
        value = "" if isinstance(item["input"], dict | list) else f" (found {item['input']!r})"
        shown.append(f"{place}: {item['msg']}{value}")
    more = len(error.errors()) - len(shown)
    return "; ".join(shown) + (f"; and {more} more" if more > 0 else "")
