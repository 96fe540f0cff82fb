"""Playing a made scenario in the reference player, with or without a window."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

from scegen.checking.environment import ESMINI_HINT, esmini
from scegen.errors import InputError, MissingToolError


def has_screen() -> bool:
    """Whether a window can be opened here."""
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def play(file: Path, *, window: bool) -> int:
    """Play a scenario to its end; the player's exit code.

    Raises:
        MissingToolError: there is no player.
    """
    program = esmini()
    if program is None:
        raise MissingToolError("esmini is not on PATH", hint=ESMINI_HINT)
    view = "--window 60 60 1200 700" if window else "--headless --fixed_timestep 0.05"
    arguments = [str(program), "--osc", file.name, *view.split(), "--logfile_path", os.devnull]
    return subprocess.run(arguments, cwd=file.parent, check=False).returncode


def scenario_file(folder: Path, scenario: str | None) -> Path:
    """The file of a scenario in a folder: the first, or the one of this name or number.

    Raises:
        InputError: there is none.
    """
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
