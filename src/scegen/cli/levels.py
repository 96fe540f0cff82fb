"""scegen understand, enumerate, concretize, schema: one stage each, level in, level out."""

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
    UrlOption,
    llm_settings,
    tell,
)
from scegen.cli.parse_report import show_contradiction, show_report
from scegen.errors import InfeasibleError, InputError
from scegen.scenario.vocabulary import ArmsMode, Reduction

if TYPE_CHECKING:
    from scegen.scenario.functional import FunctionalScenario
    from scegen.scenario.logical import Certificate, LogicalSet

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
    llm_record: RecordOption = None,
    llm_replay: ReplayOption = None,
) -> None:
    """Understand a description: text to functional scenario, with the words it rests on."""
    from scegen.scenario.files import to_json, to_yaml

    settings = llm_settings(llm, llm_url, llm_budget, llm_record, llm_replay)
    if settings is None:
        try:
            functional = _functional(text)
        except InfeasibleError as error:
            if report:
                show_contradiction(text, error, as_json=json)
            raise
    else:
        with working() as progress:
            listener = Listener(settings, progress)
            functional = _functional(text, listener)
        tell(listener.understanding)
    if report:
        show_report(functional, as_json=json)
        return
    for phrase in functional.unsupported:
        say(f'not expressed: "{phrase.text}" ({phrase.instead})')
    _write(to_json(functional) if json else to_yaml(functional), output)


def enumerate_(
    source: Annotated[
        str | None, typer.Argument(metavar="FUNCTIONAL|TEXT", help="functional.yaml or a text.")
    ] = None,
    reduction: Annotated[
        Reduction, typer.Option(help="Which assignments count as one scenario.")
    ] = Reduction.EXACT,
    arms: Annotated[
        ArmsMode, typer.Option(help="Whether all arms count alike.")
    ] = ArmsMode.DISTINCT,
    count_only: Annotated[bool, typer.Option("--count-only", help="Count, do not list.")] = False,
    limit: Annotated[int | None, typer.Option(min=1, help="List at most so many.")] = None,
    entries: Annotated[
        str | None, typer.Option(help="Entry arms of free cars, such as 0,1,2, instead of a file.")
    ] = None,
    junction_arms: Annotated[
        int | None, typer.Option(min=2, max=8, help="With --entries: arms of the junction.")
    ] = None,
    json: JsonFlag = False,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write logical.json to this file.")
    ] = None,
) -> None:
    """List or count all logical scenarios of a functional one."""
    from scegen.enumeration import count_scenarios, enumerate_scenarios

    functional = _counted_cars(source, entries, junction_arms)
    if count_only:
        certificate = count_scenarios(functional, reduction=reduction, arms=arms)
        _tell_count(certificate, reduction, arms, as_json=json)
        return
    with working() as progress:
        progress("enumerating")
        logical = enumerate_scenarios(functional, reduction=reduction, arms=arms, limit=limit)
    if output is not None:
        from scegen.scenario.files import to_json

        _write(to_json(logical), output)
    if json:
        scenarios = [s.model_dump(mode="json") for s in logical.scenarios]
        result_json(_head(logical.certificate, reduction, arms) | {"scenarios": scenarios})
    elif output is None:
        _tell_list(logical)


def concretize(
    source: Annotated[Path, typer.Argument(metavar="LOGICAL", help="logical.json")],
    index: Annotated[int, typer.Option("--index", "-i", min=0, help="Which logical scenario.")],
    seed: Annotated[int, typer.Option(min=0, help="Seed of everything random.")] = 0,
    json: JsonFlag = False,
    output: OutputFile = None,
) -> None:
    """Choose all numbers of one logical scenario."""
    from scegen.motion import concretize as choose_numbers
    from scegen.pipeline.picking import pick
    from scegen.scenario.files import load, to_json, to_yaml
    from scegen.scenario.logical import LogicalSet

    logical = load(source, LogicalSet)
    scenario = pick(logical, str(index))[0]
    concrete = choose_numbers(logical.functional, scenario, seed=seed)
    _write(to_json(concrete) if json else to_yaml(concrete), output)


def schema(
    level: Annotated[str, typer.Argument(help="functional, logical or concrete")],
) -> None:
    """Print the JSON Schema of a level."""
    from scegen.scenario.files import json_schema

    result_json(json_schema(level))


def _functional(text_or_path: str, listener: Listener | None = None) -> FunctionalScenario:
    from scegen.pipeline.source import resolve_source
    from scegen.scenario.functional import FunctionalScenario

    source = resolve_source(text_or_path, listener) if listener else resolve_source(text_or_path)
    if not isinstance(source, FunctionalScenario):
        raise InputError(
            f"is a {source.level} scenario, not a description or a functional one",
            where=text_or_path,
        )
    return source


def _counted_cars(
    source: str | None, entries: str | None, junction_arms: int | None
) -> FunctionalScenario:
    from scegen.enumeration import plain_crossing

    if (source is None) == (entries is None):
        raise InputError("name either a functional file (or a text) or --entries, not both")
    if source is not None:
        return _functional(source)
    if junction_arms is None:
        raise InputError("--entries needs --junction-arms, the number of arms of the junction")
    try:
        numbers = tuple(int(part) for part in (entries or "").split(","))
    except ValueError as error:
        raise InputError(
            f"{entries!r} is not a list of arm numbers", where="--entries", hint="such as 0,1,2"
        ) from error
    return plain_crossing(entries=numbers, arms=junction_arms)


def _head(certificate: Certificate, reduction: Reduction, arms: ArmsMode) -> dict[str, object]:
    return {
        "total": certificate.total,
        "count": certificate.count,
        "complete": certificate.complete,
        "method": certificate.method,
        "reduction": reduction.value,
        "arms": arms.value,
    }


def _tell_count(
    certificate: Certificate, reduction: Reduction, arms: ArmsMode, *, as_json: bool
) -> None:
    if as_json:
        result_json(_head(certificate, reduction, arms))
    else:
        result(f"{certificate.count} scenarios of {certificate.total} assignments")


def _tell_list(logical: LogicalSet) -> None:
    certificate = logical.certificate
    say(
        f"{certificate.count} scenarios of {certificate.total} assignments "
        f"(reduction {logical.reduction}, arms {logical.arms}; {certificate.method})"
    )
    for note in logical.notes:
        say(note)
    for scenario in logical.scenarios:
        ways = "  ".join(f"{d.participant} {d.entry}→{d.exit}" for d in scenario.drives)
        times = f"  ×{scenario.class_size}" if scenario.class_size > 1 else ""
        result(f"{scenario.index:03d}-{scenario.slug}  {ways}{times}")


def _write(text: str, output: Path | None) -> None:
    if output is None:
        result(text)
        return
    try:
        output.write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError(f"cannot be written: {error.strerror}", where=str(output)) from error
