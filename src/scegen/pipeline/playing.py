"""Playing a made scenario in the reference player, with or without a window."""

import os
import subprocess
from pathlib import Path

from scegen.checking.environment import ESMINI_HINT, esmini
from scegen.errors import MissingToolError


def has_screen() -> bool:
    """Whether a window can be opened here."""
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def play(file: Path, *, window: bool) -> subprocess.CompletedProcess[str]:
    """Play a scenario to its end; the player's exit code, and in ``stdout`` all it told.

    Raises:
        MissingToolError: there is no player.
    """
    program = esmini()
    if program is None:
        raise MissingToolError("esmini is not on PATH", hint=ESMINI_HINT)
    view = "--window 60 60 1200 700" if window else "--headless --fixed_timestep 0.05"
    arguments = [str(program), "--osc", file.name, *view.split(), "--logfile_path", os.devnull]
    return subprocess.run(
        arguments,
        cwd=file.parent,
        check=False,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    )
