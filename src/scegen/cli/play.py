"""scegen play: a scenario in esmini, with or without a window."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import Annotated

import typer

from scegen.cli.console import say
from scegen.errors import InputError, MissingToolError


def play(
    folder: Annotated[Path, typer.Argument(help="A scenario folder, or one made by generate.")],
    scenario: Annotated[
        str | None, typer.Option(help="Which scenario of the folder, by name or its number.")
    ] = None,
    headless: Annotated[bool, typer.Option("--headless", help="Play without a window.")] = False,
) -> None:
    """Play a scenario in esmini."""
    from scegen.checking.environment import ESMINI_HINT, esmini

    file = _scenario_file(folder, scenario)
    program = esmini()
    if program is None:
        raise MissingToolError("esmini is not on PATH", hint=ESMINI_HINT)
    if not headless and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        say("no screen here: playing without a window")
        headless = True
    view = "--headless --fixed_timestep 0.05" if headless else "--window 60 60 1200 700"
    arguments = [str(program), "--osc", file.name, *view.split(), "--logfile_path", os.devnull]
    code = subprocess.run(arguments, cwd=file.parent, check=False).returncode
    if code:
        say(f"esmini ended with exit code {code}")
        raise typer.Exit(1)


def _scenario_file(folder: Path, scenario: str | None) -> Path:
    if folder.is_file():
        return folder
    found = [folder / "scenario.xosc"] if (folder / "scenario.xosc").is_file() else []
    found = found or sorted(folder.glob("scenarios/*/scenario.xosc"))
    if not found:
        raise InputError(
            "holds no scenario.xosc",
            where=str(folder),
            hint="name a folder made by scegen generate, or one of its scenarios",
        )
    if scenario is None:
        return found[0]
    for file in found:
        if scenario == file.parent.name or (
            scenario.isdigit() and file.parent.name.startswith(f"{int(scenario):03d}-")
        ):
            return file
    names = ", ".join(file.parent.name for file in found)
    raise InputError(
        f"there is no scenario {scenario!r}", where=str(folder), hint=f"there are: {names}"
    )
