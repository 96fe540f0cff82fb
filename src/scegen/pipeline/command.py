"""How a folder was made, kept in it, so that the same files can be made again, byte for byte."""

import shlex
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import Any

from scegen.checking.subject import CONCRETE_FILE, FUNCTIONAL_FILE
from scegen.pipeline.options import Options
from scegen.pipeline.source import GIVEN_FILE, LOGICAL_FILE, Source
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import to_json
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.rule_file import RULES_FILE

_NAMES = {"depth": "check"}
_LEFT_OUT = {"force"}
_DEFAULTS = Options()


@dataclass(frozen=True, slots=True)
class Recipe:
    """What makes a folder again, from inside it.

    ``source`` is the file to begin from, ``options`` those that differ from what is usual, by
    their names on the command line, ``kept`` files that the folder needs for it and would not
    hold otherwise.
    """

    source: str
    options: dict[str, str | int]
    kept: dict[str, bytes] = field(default_factory=dict)


def recipe(source: Source, made: Sequence[ConcreteScenario], options: Options) -> Recipe:
    """How these scenarios were made from that source."""
    kept = {} if options.rules is None else {RULES_FILE: options.rules.text.encode()}
    told = options_told(options)
    if isinstance(source, FunctionalScenario):
        return Recipe(FUNCTIONAL_FILE, told, kept)
    if not isinstance(source, ConcreteScenario):
        return Recipe(LOGICAL_FILE, told, kept)
    if list(made) == [source]:
        return Recipe(f"scenarios/{source.name}/{CONCRETE_FILE}", told, kept)
    return Recipe(GIVEN_FILE, told, {**kept, GIVEN_FILE: to_json(source).encode()})


def options_told(options: Options) -> dict[str, str | int]:
    """The options that are not the usual ones, by their names on the command line."""
    told: dict[str, str | int] = {}
    for option in fields(options):
        value = getattr(options, option.name)
        if option.name in _LEFT_OUT or value == getattr(_DEFAULTS, option.name):
            continue
        shown = RULES_FILE if option.name == "rules" else value
        told[_NAMES.get(option.name, option.name)] = shown if type(shown) is int else str(shown)
    return told


def command_line(summary: Mapping[str, Any], output: str) -> str | None:
    """``scegen generate`` as it made a folder, ready for a shell in it; None if it does not tell.

    ``output`` is the folder that the command makes.
    """
    source, options = summary.get("source"), summary.get("options")
    if not isinstance(source, str) or not isinstance(options, dict):
        return None
    words = ["scegen", "generate", source, "-o", output]
    for name, value in options.items():
        words += [f"--{name}", str(value)]
    return shlex.join(words)
