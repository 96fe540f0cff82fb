"""Where a result goes: stdout, or the file that was named."""

from __future__ import annotations

from pathlib import Path

from scegen.cli.console import result
from scegen.errors import InputError


def write_text(text: str, output: Path | None) -> None:
    """Write to a file, or to stdout."""
    if output is None:
        result(text)
        return
    write_bytes(text.encode(), output)


def write_bytes(content: bytes, output: Path) -> None:
    """Write to a file."""
    try:
        output.write_bytes(content)
    except OSError as error:
        raise InputError(f"cannot be written: {error.strerror}", where=str(output)) from error
