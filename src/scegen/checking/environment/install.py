"""Installs the environments of tools outside the package, in exact versions."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from importlib.resources import as_file, files
from pathlib import Path

from scegen.checking.environment import own_python
from scegen.errors import MissingToolError

ASAM_PACKAGES = ("asam-qc-opendrive", "asam-qc-openscenarioxml")
INTEROP_PACKAGES = ("carla", "eclipse-sumo")


def install_asam() -> Path:
    """Create the ASAM checkers' environment, in exact versions; its python."""
    return _install("asam", ASAM_PACKAGES)


def install_interop() -> Path:
    """Create the interoperability validators' environment, in exact versions; its python."""
    return _install("interop", INTEROP_PACKAGES)


def _install(name: str, packages: Sequence[str]) -> Path:
    python = own_python(name)
    constraints = files("scegen.checking").joinpath("data", f"{name}-constraints.txt")
    with as_file(constraints) as path:
        commands = (
            [sys.executable, "-m", "venv", str(Path(sys.prefix, name))],
            [str(python), "-m", "pip", "install", "-q", "-c", str(path), *packages],
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
