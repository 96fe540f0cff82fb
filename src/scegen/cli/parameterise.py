"""scegen parameterise: a scenario with parameters, and sets of values to play it with."""

from pathlib import Path
from typing import Annotated

import typer

from scegen.cli.console import result, say
from scegen.cli.options import ScenarioOption, SeedOption
from scegen.errors import InputError, MissingToolError
from scegen.scenario.wording import counted


def parameterise(
    source: Annotated[
        Path,
        typer.Argument(
            metavar="LOGICAL|DIR|CONCRETE",
            help="logical.json, a scenario folder, or a concrete.yaml.",
        ),
    ],
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder to write to.")],
    index: Annotated[
        int | None, typer.Option("--index", "-i", min=0, help="Which scenario of a logical.json.")
    ] = None,
    scenario: ScenarioOption = None,
    sets: Annotated[int, typer.Option(help="How many random sets of values.")] = 50,
    seed: SeedOption = 0,
    alone: Annotated[
        bool, typer.Option("--alone", help="Also write every set as a scenario folder of its own.")
    ] = False,
    confirm: Annotated[
        bool,
        typer.Option("--confirm", help="Play every set in esmini, with parameters and --alone."),
    ] = False,
) -> None:
    """Write a scenario with parameters (OpenSCENARIO 1.2), and values to play it with."""
    from scegen.checking.environment import ESMINI_HINT, esmini
    from scegen.pipeline.folder import write_files
    from scegen.pipeline.parameter_sets import (
        PARAMETERISED_FILE,
        VALUES_FILE,
        parameter_source,
        set_files,
    )
    from scegen.pipeline.parameter_sets import write_parameter_files as run

    if output.exists() and not output.is_dir():
        raise InputError("is a file, not a folder", where=str(output), hint="choose another -o")
    if confirm and esmini() is None:
        raise MissingToolError(f"esmini is not on PATH; {ESMINI_HINT}")
    functional, concrete = parameter_source(source, index, seed, scenario)
    made = run(functional, concrete, count=sets, seed=seed, alone=alone or confirm)
    write_files(output, made.files)
    for item in made.declared:
        result(f"{item.name}  {item.low:g} to {item.high:g}, {item.value:g}")
    for line in made.frozen:
        result(f"fixed: {line}")
    for reason, times in made.passed_over.most_common():
        say(f"{times} draws passed over: {reason}")
    result(f"{output / PARAMETERISED_FILE}  {counted(len(made.declared), 'parameter')}")
    result(f"{output / VALUES_FILE}  {counted(len(made.sets), 'set')} of values")
    if confirm:
        from scegen.checking.parameters import check_parameters

        alone_files = set_files(output, len(made.sets))
        checked = check_parameters(output / PARAMETERISED_FILE, output / VALUES_FILE, alone_files)
        result(f"{checked.checker} {checked.status}  {checked.detail}")
        for finding in checked.errors:
            say(f"  {finding.place}: {finding.message} [{finding.rule}]")
        if checked.errors:
            raise typer.Exit(1)
