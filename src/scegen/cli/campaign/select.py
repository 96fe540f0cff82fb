"""scegen campaign select: a suite of a given size by coverage, criticality and diversity."""

from pathlib import Path
from typing import Annotated

import typer

from scegen.cli.console import result, result_json, say, working
from scegen.cli.options import CAMPAIGN, JsonFlag
from scegen.errors import of_extra


def select(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="Folder of a campaign.")],
    size: Annotated[int, typer.Option(min=1, help="How many scenarios at most.")],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the suite's files here.")
    ] = None,
    json: JsonFlag = False,
) -> None:
    """Choose the fewest scenarios that cover all that can be covered, then critical ones."""
    with of_extra(*CAMPAIGN), working() as progress:
        from scegen.campaign.choosing import select as choose
        from scegen.campaign.choosing import write_suite
        from scegen.campaign.store import Store

        progress("choosing")
        selected = choose(Store(folder), size)
        if output is not None:
            progress("writing")
            write_suite(Store(folder), selected, output)
    suite, data = selected.suite, selected.to_data()
    if json:
        result_json(data)
    else:
        for item in data["scenarios"]:
            brings = f" {len(item['brings'])} cells" if item["brings"] else ""
            result(f"{item['description']} {item['logical']}  {item['reason']}{brings}")
    proved = "no fewer do" if suite.proved else "the fewest found"
    say(
        f"{data['covered']} of {data['coverable']} cells covered; all take {suite.needed} "
        f"scenarios ({proved})"
    )
    for cell in suite.uncovered:
        say(f"no room for: {cell}")
    for cell, reason in data["cannot_be_covered"].items():
        say(f"cannot be covered: {cell}: {reason}")
    if data["not_in_the_campaign"]:
        say(f"{len(data['not_in_the_campaign'])} cells lie in logical scenarios not picked")
