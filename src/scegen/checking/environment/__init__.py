"""Tools outside the package: where they are, and how to get them.

The ASAM checkers and the interoperability validators pin libraries that the package must not
be tied to, so each set lives in an environment of its own inside ours. Run
``python -m scegen.checking.environment asam`` (or ``interop``) to install one.
"""

import os
import shutil
import sys
from pathlib import Path
from typing import NamedTuple

ASAM_VARIABLE = "SCEGEN_ASAM_PYTHON"
"""Names the python of an environment that has the ASAM checkers, instead of our own."""
INTEROP_VARIABLE = "SCEGEN_INTEROP_PYTHON"
ASAM_HINT = "run: make asam (or: python -m scegen.checking.environment asam)"
INTEROP_HINT = "run: make interop (or: python -m scegen.checking.environment interop)"
ESMINI_HINT = (
    "get a release of esmini (3.6 or newer) from github.com/esmini/esmini, "
    "unpack it and put its bin folder on PATH"
)


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


def _python(variable: str, name: str) -> Path | None:
    named = os.environ.get(variable)
    python = Path(named) if named else own_python(name)
    return python if python.is_file() else None


def own_python(name: str) -> Path:
    """Where the python of one of our own environments is, or would be."""
    folder = Path(sys.prefix, name)
    return folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
