"""``python -m scegen.checking.environment asam|interop``: install an environment."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from scegen.checking.environment.install import PACKAGES, install
from scegen.errors import InputError, MissingToolError


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
