"""scegen campaign report: what a campaign covers, how critical it is, what stands out."""

from pathlib import Path
from typing import Annotated

import typer

from scegen.cli.console import result, working
from scegen.cli.options import CAMPAIGN
from scegen.errors import of_extra


def report(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="Folder of a campaign.")],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Folder to write; DIR/report if not said.")
    ] = None,
    pages: Annotated[
        int,
        typer.Option(
            min=0, help="So many of the most critical and most different ones get the player."
        ),
    ] = 10,
) -> None:
    """Write a page with coverage, distributions and what stands out, and the table of all rows."""
    with of_extra(*CAMPAIGN), working() as progress:
        from scegen.campaign.report.write import write_report
        from scegen.campaign.store import Store

        page = write_report(Store(folder), output or folder / "report", pages, progress)
    result(str(page))
