"""scegen benchmark understand: labelled descriptions, by the reader or language models."""

from pathlib import Path
from typing import Annotated

import typer

from scegen.cli.console import result_json, say, working
from scegen.cli.llm import Asked, asks_models
from scegen.cli.options import JsonFlag


@asks_models
def understand(
    file: Annotated[Path, typer.Argument(metavar="FILE.jsonl", help="Labelled descriptions.")],
    json: JsonFlag = False,
    repeat: Annotated[
        int, typer.Option(min=1, max=100, help="Read each description so often: is it stable?")
    ] = 1,
    *,
    models: Asked,
) -> None:
    """Labelled descriptions: how many are understood, per field, kind and hazard.

    With --llm by language models and reader together; the budget is for all descriptions.
    """
    from scegen.benchmark.understand import run
    from scegen.understanding import load_cases

    cases = load_cases(file)
    settings = models.settings(runs="*/1/run.json")
    if settings is None:
        outcome, measured = run(cases, repeat=repeat), None
    else:
        from scegen.benchmark.agents import AgentReader

        with working() as progress:
            reader = AgentReader(settings, progress=progress)
            outcome, measured = run(cases, reader, repeat=repeat, told=say), reader.measured
    if json:
        llm_data = {} if measured is None else {"llm": measured.to_data(outcome)}
        result_json(outcome.to_data() | llm_data)
    else:
        from scegen.cli.benchmark.scores import print_scores

        print_scores(outcome, measured)
    if outcome.stopped is not None:
        say(f"stopped: {outcome.stopped}")
    if not outcome.perfect:
        raise typer.Exit(1)
