"""Tools outside the package: where they are, and how to get them.

The ASAM checkers and the interoperability validators pin libraries that the package must not
be tied to, so each set lives in an environment of its own inside ours. Run
``python -m scegen.checking.environment asam`` (or ``interop``) to install one.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from importlib.resources import as_file, files
from pathlib import Path
from typing import NamedTuple

from scegen.errors import InputError, MissingToolError

ASAM_VARIABLE = "SCEGEN_ASAM_PYTHON"
"""Names the python of an environment that has the ASAM checkers, instead of our own."""
INTEROP_VARIABLE = "SCEGEN_INTEROP_PYTHON"
ASAM_PACKAGES = ("asam-qc-opendrive", "asam-qc-openscenarioxml")
INTEROP_PACKAGES = ("carla", "eclipse-sumo")
ASAM_HINT = "run: make asam (or: python -m scegen.checking.environment asam)"
INTEROP_HINT = "run: make interop (or: python -m scegen.checking.environment interop)"
ESMINI_HINT = "put esmini (3.6 or newer) on PATH; its releases are on its GitHub page"


class Tool(NamedTuple):
    """A tool outside the package: where it was found (None = nowhere), and how to get it."""

    name: str
    found: str | None
    hint: str


def asam_python() -> Path | None:
    """The python of the ASAM checkers' environment, if it is installed."""
    return _python(ASAM_VARIABLE, "asam")


def interop_python() -> Path | None:
    """The python of the interoperability validators' environment, if it is installed."""
    return _python(INTEROP_VARIABLE, "interop")


def esmini() -> Path | None:
    """The esmini player, if it is on PATH."""
    found = shutil.which("esmini")
    return Path(found) if found else None


def site_packages(python: Path) -> Path | None:
    """The folder of an environment's packages, found without running its python."""
    found = sorted(python.parent.parent.glob("lib/python3*/site-packages"))
    windows = python.parent.parent / "Lib" / "site-packages"
    return found[0] if found else windows if windows.is_dir() else None


def installed_tools() -> tuple[Tool, ...]:
    """What is installed beside the package, what is missing, and how to get it."""

    def text(path: Path | None) -> str | None:
        return str(path) if path else None

    return (
        Tool("esmini", text(esmini()), ESMINI_HINT),
        Tool("ASAM checkers", text(asam_python()), ASAM_HINT),
        Tool("carla and netconvert", text(interop_python()), INTEROP_HINT),
    )


def install_asam() -> Path:
    """Create the ASAM checkers' environment, in exact versions; its python."""
    return _install("asam", ASAM_PACKAGES)


def install_interop() -> Path:
    """Create the interoperability validators' environment, in exact versions; its python."""
    return _install("interop", INTEROP_PACKAGES)


def _python(variable: str, name: str) -> Path | None:
    named = os.environ.get(variable)
    python = Path(named) if named else _own(name)
    return python if python.is_file() else None


def _own(name: str) -> Path:
    folder = Path(sys.prefix, name)
    return folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def _install(name: str, packages: Sequence[str]) -> Path:
    python = _own(name)
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


def main(arguments: Sequence[str] | None = None) -> int:
    """Install the environment named by the only argument; the exit code."""
    names = list(sys.argv[1:] if arguments is None else arguments)
    installers = {"asam": install_asam, "interop": install_interop}
    if len(names) != 1 or names[0] not in installers:
        sys.stderr.write("name one environment: asam or interop\n")
        return InputError.exit_code
    try:
        python = installers[names[0]]()
    except MissingToolError as problem:
        sys.stderr.write(f"{problem}\n")
        return problem.exit_code
    sys.stderr.write(f"installed: {python}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
