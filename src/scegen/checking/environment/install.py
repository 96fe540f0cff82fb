"""Installs the environments of tools outside the package, in exact versions."""

from __future__ import annotations

import subprocess
import sys
from importlib.resources import as_file, files
from pathlib import Path

from scegen.checking.environment import own_python
from scegen.errors import MissingToolError

PACKAGES = {
    "asam": ("asam-qc-opendrive", "asam-qc-openscenarioxml"),
    "interop": ("carla", "eclipse-sumo"),
}
"""By name of the environment."""


def install(name: str) -> Path:
    """Create one of the environments, in exact versions; its python.

    Raises:
        MissingToolError: that did not work.
    """
    python = own_python(name)
    constraints = files("scegen.checking").joinpath("data", f"{name}-constraints.txt")
    with as_file(constraints) as path:
        commands = (
            [sys.executable, "-m", "venv", str(Path(sys.prefix, name))],
            [str(python), "-m", "pip", "install", "-q", "-c", str(path), *PACKAGES[name]],
        )
        for command in commands:
            try:
                subprocess.run(command, check=True)
            except (OSError, subprocess.CalledProcessError) as failure:
                raise MissingToolError(
                    f"the environment {name!r} could not be installed: {failure}",
                    hint="see what pip says above; it needs the usual package index",
                ) from failure
    return python
