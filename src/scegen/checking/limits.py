"""Other people's programs, run so that they cannot hang, fill the memory or the disk."""

import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

try:
    import resource
except ImportError:  # not on Windows: only the time limit holds there
    resource = None  # type: ignore[assignment]

MEMORY_BYTES = 4 * 1024**3
FILE_BYTES = 256 * 1024**2


class Ran(NamedTuple):
    """How a program ended: its exit code (None = stopped at the time limit) and its output."""

    code: int | None
    output: str


def run_limited(command: Sequence[str], folder: Path, timeout_s: float) -> Ran:
    """Run a program in ``folder``; output and errors come together.

    Raises:
        OSError: the program cannot be started.
    """
    try:
        done = subprocess.run(
            list(command),
            cwd=folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            check=False,
            timeout=timeout_s,
            preexec_fn=_limit if resource else None,
        )
    except subprocess.TimeoutExpired:
        return Ran(None, "")
    return Ran(done.returncode, done.stdout)


def _limit() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
    resource.setrlimit(resource.RLIMIT_FSIZE, (FILE_BYTES, FILE_BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
