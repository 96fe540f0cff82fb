"""scegen play: a scenario in esmini, with or without a window."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import Annotated

import typer

from scegen.cli.console import result, say
from scegen.cli.place import scenario_file
from scegen.errors import MissingToolError


def play(
    folder: Annotated[Path, typer.Argument(help="A scenario folder, or one made by generate.")],
    scenario: Annotated[
        str | None, typer.Option(help="Which scenario of the folder, by name or its number.")
    ] = None,
    headless: Annotated[bool, typer.Option("--headless", help="Play without a window.")] = False,
) -> None:
    """Play a scenario in esmini."""
    from scegen.checking.environment import ESMINI_HINT, esmini

    file = scenario_file(folder, "scenario.xosc", scenario)
    program = esmini()
    if program is None:
        raise MissingToolError("esmini is not on PATH", hint=ESMINI_HINT)
    if not headless and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        say("no screen here: playing without a window")
        headless = True
    view = "--headless --fixed_timestep 0.05" if headless else "--window 60 60 1200 700"
    arguments = [str(program), "--osc", file.name, *view.split(), "--logfile_path", os.devnull]
    # What it tells of its own doings interests only where it fails.
    told = subprocess.run(
        arguments,
        cwd=file.parent,
        check=False,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    )
    if told.returncode:
        say(told.stdout.rstrip())
        say(f"esmini ended with exit code {told.returncode}")
        raise typer.Exit(1)
    result(f"{file}  played")
