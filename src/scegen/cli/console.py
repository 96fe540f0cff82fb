"""Where words go: results to stdout or into a file, everything else to stderr."""

import json
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeVar

from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    SpinnerColumn,
    TextColumn,
    TimeElapsedColumn,
)

from scegen.errors import InputError

T = TypeVar("T")

INTERRUPTED = 130
"""Exit code after Ctrl-C."""

stderr = Console(stderr=True, highlight=False, soft_wrap=True, emoji=False)


def say(text: str) -> None:
    """A remark for the person, on stderr."""
    stderr.print(text, markup=False)


def warn(text: str) -> None:
    """A remark that should not be overlooked."""
    stderr.print("warning:", style="bold yellow", end=" ")
    say(text)


def result(text: str) -> None:
    """A result, on stdout, exactly as it is."""
    sys.stdout.write(text if text.endswith("\n") else text + "\n")
    sys.stdout.flush()


def result_json(data: object) -> None:
    """A result as indented JSON, on stdout."""
    result(json.dumps(data, indent=2, ensure_ascii=False))


def write_bytes(content: bytes, output: Path | None) -> None:
    """Write to a file; without one, a text to stdout."""
    if output is None:
        result(content.decode())
        return
    try:
        output.write_bytes(content)
    except OSError as error:
        raise InputError.unwritable(error, output) from error


@contextmanager
def working() -> Iterator[Callable[[str], None]]:
    """Show the step under way on a terminal; nothing where stderr is no terminal."""
    if not stderr.is_terminal:
        yield lambda _: None
        return
    columns = (SpinnerColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
    with Progress(*columns, console=stderr, transient=True) as progress:
        task = progress.add_task("starting", total=None)
        yield lambda step: progress.update(task, description=step)


@contextmanager
def counting(total: int | None = None) -> Iterator[Callable[[Iterable[T]], Iterator[T]]]:
    """Show how many are done, where that does not run into results on a terminal.

    Without ``total`` there are as many as the iterable has.
    """
    if not stderr.is_terminal or sys.stdout.isatty():
        yield iter
        return
    columns = (SpinnerColumn(), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    # Results go to stdout themselves: rich would print them between its bars, on stderr.
    with Progress(*columns, console=stderr, transient=True, redirect_stdout=False) as progress:
        yield lambda items: iter(progress.track(items, total=total))
