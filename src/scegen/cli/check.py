"""scegen check: every checker on what was made, or on any OpenDRIVE and OpenSCENARIO file."""

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from scegen.cli.console import result_json, working
from scegen.cli.options import JsonFlag
from scegen.errors import InputError, MissingToolError


def check(
    paths: Annotated[
        list[Path],
        typer.Argument(metavar="DIR|FILE...", help="Folders made by generate, or single files."),
    ],
    require: Annotated[
        str, typer.Option(help="Checkers that must have run, such as esmini,asam-opendrive.")
    ] = "",
    replay: Annotated[
        bool,
        typer.Option("--replay", help="Also compare what esmini plays with our own simulation."),
    ] = False,
    json: JsonFlag = False,
) -> None:
    """Check files by geometry, topology, schema, the ASAM checkers and esmini."""
    from scegen.checking import CHECKERS, REPLAY, CheckStatus, check_files, reports_table

    checkers = (*CHECKERS, REPLAY) if replay else CHECKERS

    required = {name.strip() for name in require.split(",") if name.strip()}
    if unknown := required - set(checkers):
        raise InputError(
            f"no checker is called {min(unknown)!r}",
            where="--require",
            hint=f"there are: {', '.join(checkers)}",
        )
    with working() as progress:
        progress("checking")
        reports = check_files(paths, checkers)
    if json:
        result_json([report.to_data() for report in reports])
    else:
        Console().print(reports_table(reports))
    if not all(report.ok for report in reports):
        raise typer.Exit(1)
    for report in reports:
        for item in report.results:
            if item.checker in required and item.status is CheckStatus.NOT_RUN:
                raise MissingToolError(f"{item.checker} did not run: {item.detail}")
