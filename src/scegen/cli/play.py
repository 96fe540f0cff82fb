"""scegen play: a scenario in esmini, with or without a window."""

from pathlib import Path
from typing import Annotated

import typer

from scegen.cli.console import result, say
from scegen.cli.options import ScenarioOption


def play(
    folder: Annotated[
        Path,
        typer.Argument(metavar="DIR", help="A scenario folder, or one made by generate."),
    ],
    scenario: ScenarioOption = None,
    headless: Annotated[bool, typer.Option("--headless", help="Play without a window.")] = False,
) -> None:
    """Play a scenario in esmini."""
    from scegen.pipeline.place import scenario_file
    from scegen.pipeline.playing import has_screen
    from scegen.pipeline.playing import play as run

    file = scenario_file(folder, "scenario.xosc", scenario)
    if not headless and not has_screen():
        say("no screen here: playing without a window")
        headless = True
    played = run(file, window=not headless)
    # What it tells of its own doings interests only where it fails.
    if played.returncode:
        say(played.stdout.rstrip())
        say(f"esmini ended with exit code {played.returncode}")
        raise typer.Exit(1)
    result(f"{file}  played")
