"""``python -m scegen.checking.environment asam|interop``: install an environment."""

import subprocess
import sys
from collections.abc import Sequence
from importlib.resources import as_file, files
from pathlib import Path

from scegen.checking.environment import own_python
from scegen.errors import InputError, MissingToolError

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


def main(arguments: Sequence[str] | None = None) -> int:
    """Install the environment named by the only argument; the exit code."""
    names = list(sys.argv[1:] if arguments is None else arguments)
    if len(names) != 1 or names[0] not in PACKAGES:
        sys.stderr.write("name one environment: asam or interop\n")
        return InputError.exit_code
    try:
        python = install(names[0])
    except MissingToolError as problem:
        sys.stderr.write(f"{problem}\n")
        return problem.exit_code
    sys.stderr.write(f"installed: {python}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
