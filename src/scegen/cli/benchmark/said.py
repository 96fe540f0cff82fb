"""scegen benchmark said: what was said, judged on what is played."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scegen.cli.console import result, result_json, say, working
from scegen.cli.llm import Asked, asks_models
from scegen.cli.options import JsonFlag, SeedOption

if TYPE_CHECKING:
    from scegen.benchmark.said import Row


@asks_models
def said(
    file: Annotated[
        Path, typer.Argument(metavar="FILE.jsonl", help="Descriptions with facts, one a line.")
    ],
    only: Annotated[
        list[str] | None, typer.Option("--only", help="Id of a description; may be repeated.")
    ] = None,
    seed: SeedOption = 0,
    judge: Annotated[
        Path | None,
        typer.Option(
            help="Python file with judge(facts, recording); judge_catalogue.py beside FILE."
        ),
    ] = None,
    json: JsonFlag = False,
    *,
    models: Asked,
) -> None:
    """From the sentence to what runs: which facts are true when the files are played.

    With --llm read by language models and reader together; the budget is for all descriptions.
    """
    from scegen.benchmark.said import JUDGE_FILE, load_judge, load_records, run, tally
    from scegen.benchmark.understand import Result, StoppedError, offline
    from scegen.cli.benchmark.scores import print_language_models
    from scegen.errors import InputError

    records = load_records(file)
    judging = load_judge(judge or file.with_name(JUDGE_FILE))
    if unknown := sorted({*(only or ())} - {record.id for record in records}):
        raise InputError(f"there is no description {unknown[0]!r}", where=str(file))
    settings = models.settings(runs="*/1/run.json")
    rows: list[Row] = []
    stopped = None
    agents = None
    with working() as progress:
        if settings is not None:
            from scegen.benchmark.agents import AgentReader

            agents = AgentReader(settings, progress=progress)
        reads = agents or offline
        try:
            for row in run(records, judging, reads, seed=seed, only=only or (), progress=progress):
                rows.append(row)
                if not json:
                    _tell(row)
        except StoppedError as error:
            stopped = str(error)
    right, unsaid = sum(row.right for row in rows), sum(row.unsaid for row in rows)
    facts = tally(rows)
    held = {(row.record.id, 1): row.right for row in rows}
    outcome = Result(readings=len(rows), understood=right, held=held)
    if json:
        data = {
            "right": right,
            "sentences": len(rows),
            "unsaid": unsaid,
            "facts": {name: {"right": r, "asked": n} for name, (r, n) in facts.items()},
            "rows": [row.to_data() for row in rows],
            "stopped": stopped,
        }
        result_json(data | ({} if agents is None else {"llm": agents.measured.to_data(outcome)}))
    else:
        if agents is not None:
            print_language_models(agents.measured, outcome)
        result("")
        for name, (holds, asked) in facts.items():
            result(f"  {name:28}{holds:4} of {asked}")
        players = ", ".join(sorted({row.player for row in rows if row.player}))
        result(f"every fact right: {right} of {len(rows)} sentences; played by {players or '-'}")
    if stopped is not None:
        say(f"stopped: {stopped}")
    if right < len(rows):
        wrong = len(rows) - right
        say(f"{wrong} sentences run otherwise than said, {unsaid} of them without a word about it")
    if right < len(rows) or stopped is not None:
        raise typer.Exit(1)


def _tell(row: Row) -> None:
    known = f", {len(row.missed)} statements known not to hold" if row.missed else ""
    known += f", {len(row.left_out)} phrases known to be left out" if row.left_out else ""
    if row.right:
        result(f"right  {row.record.id}{known}")
        return
    result(f"WRONG  {row.record.id}{known}: {row.record.text}")
    if row.problem is not None:
        result(f"         {row.problem}")
    for fact in row.facts:
        if not fact.holds:
            result(f"         {fact.name}: {fact.expected} expected, {fact.measured} measured")
