"""scegen understand, concretize, schema: one stage each, level in, level out."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scegen.cli.console import result, result_json, say, working
from scegen.cli.llm import (
    BudgetOption,
    Listener,
    ModelOption,
    RecordOption,
    ReplayOption,
    TimeoutOption,
    UrlOption,
    llm_settings,
    tell,
)
from scegen.cli.parse_report import show_refusal, show_report
from scegen.errors import InputError

if TYPE_CHECKING:
    from scegen.scenario.functional import FunctionalScenario

JsonFlag = Annotated[bool, typer.Option("--json", help="Print JSON.")]
OutputFile = Annotated[
    Path | None, typer.Option("--output", "-o", help="Write to this file instead of stdout.")
]


def understand(
    text: Annotated[str, typer.Argument(metavar="TEXT|FILE", help="A description.")],
    json: JsonFlag = False,
    output: OutputFile = None,
    report: Annotated[
        bool, typer.Option("--report", help="Show the text with what became of its words.")
    ] = False,
    llm: ModelOption = None,
    llm_url: UrlOption = None,
    llm_budget: BudgetOption = None,
    llm_timeout: TimeoutOption = None,
    llm_record: RecordOption = None,
    llm_replay: ReplayOption = None,
) -> None:
    """Understand a description: text to functional scenario, with the words it rests on."""
    from scegen.scenario.files import to_json, to_yaml

    settings = llm_settings(llm, llm_url, llm_budget, llm_timeout, llm_record, llm_replay)
    listener = None
    try:
        if settings is None:
            functional = functional_of(text)
        else:
            with working() as progress:
                listener = Listener(settings, progress)
                functional = functional_of(text, listener)
            tell(listener.understanding)
    except InputError as error:
        if report:
            show_refusal(text, error, as_json=json)
        raise
    if report:
        understood = listener and listener.understanding
        show_report(functional, understood.disagreements if understood else (), as_json=json)
        return
    for phrase in functional.unsupported:
        say(f'not expressed: "{phrase.text}" ({phrase.instead})')
    write_text(to_json(functional) if json else to_yaml(functional), output)


def concretize(
    source: Annotated[Path, typer.Argument(metavar="LOGICAL", help="logical.json")],
    index: Annotated[int, typer.Option("--index", "-i", min=0, help="Which logical scenario.")],
    seed: Annotated[int, typer.Option(min=0, help="Seed of everything random.")] = 0,
    json: JsonFlag = False,
    output: OutputFile = None,
) -> None:
    """Choose all numbers of one logical scenario."""
    from scegen.concretization import concretize as choose_numbers
    from scegen.pipeline.picking import pick
    from scegen.scenario.files import load, to_json, to_yaml
    from scegen.scenario.logical import LogicalSet

    logical = load(source, LogicalSet)
    scenario = pick(logical, str(index))[0]
    concrete = choose_numbers(logical.functional, scenario, seed=seed)
    write_text(to_json(concrete) if json else to_yaml(concrete), output)


def schema(
    level: Annotated[str, typer.Argument(help="functional, logical or concrete")],
) -> None:
    """Print the JSON Schema of a level."""
    from scegen.scenario.files import json_schema

    result_json(json_schema(level))


def functional_of(text_or_path: str, listener: Listener | None = None) -> FunctionalScenario:
    """The functional scenario that an argument names or tells."""
    from scegen.pipeline.source import resolve_source
    from scegen.scenario.functional import FunctionalScenario

    source = resolve_source(text_or_path, listener) if listener else resolve_source(text_or_path)
    if not isinstance(source, FunctionalScenario):
        raise InputError(
            f"is a {source.level} scenario, not a description or a functional one",
            where=text_or_path,
        )
    return source


def write_text(text: str, output: Path | None) -> None:
    """Write to a file, or to stdout."""
    if output is None:
        result(text)
        return
    write_bytes(text.encode(), output)


def write_bytes(content: bytes, output: Path) -> None:
    """Write to a file."""
    try:
        output.write_bytes(content)
    except OSError as error:
        raise InputError(f"cannot be written: {error.strerror}", where=str(output)) from error
