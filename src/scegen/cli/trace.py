"""scegen trace: everybody's movements as a file for other tools."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from scegen.cli.console import write_bytes
from scegen.cli.options import OutputFile, ScenarioOption
from scegen.errors import InputError
from scegen.pipeline.place import scenario_file


def trace(
    place: Annotated[
        Path, typer.Argument(metavar="DIR|FILE", help="A scenario folder or a concrete.yaml.")
    ],
    csv: Annotated[bool, typer.Option("--csv", help="As a table (the default).")] = False,
    mcap: Annotated[
        bool, typer.Option("--mcap", help="For Foxglove and Lichtblick; needs ml-scegen[exchange].")
    ] = False,
    output: OutputFile = None,
    scenario: ScenarioOption = None,
    player: Annotated[
        Literal["own", "esmini"],
        typer.Option(help="Whose movements: our own simulation's, or esmini's."),
    ] = "own",
    dt: Annotated[
        float, typer.Option(min=0.001, max=1.0, help="Time step in s; esmini is played at 0.05.")
    ] = 0.05,
) -> None:
    """Write time, place, heading and speed of everybody, in SI units."""
    from scegen.checking.subject import CONCRETE_FILE
    from scegen.pipeline.tracing import trace_file
    from scegen.scenario.concrete import ConcreteScenario
    from scegen.scenario.files import load

    if csv and mcap:
        raise InputError("one of --csv and --mcap at a time", where="scegen trace")
    if mcap and output is None:
        raise InputError("is no text: name a file with -o", where="--mcap")
    source = scenario_file(place, CONCRETE_FILE, scenario)
    content = trace_file(
        load(source, ConcreteScenario),
        folder=source.parent,
        mcap=mcap,
        esmini_plays=player == "esmini",
        dt_s=dt,
    )
    write_bytes(content, output)
