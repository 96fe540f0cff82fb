"""scegen campaign run: make a campaign, go on with it, or verify it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    SpinnerColumn,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)

from scegen.cli.console import INTERRUPTED, result, say, stderr
from scegen.cli.options import CAMPAIGN, WhereOption
from scegen.errors import InputError, of_extra

if TYPE_CHECKING:
    from scegen.campaign.claiming import Finished


def run(
    source: Annotated[
        Path | None,
        typer.Argument(
            metavar="RUN.yaml|DESCRIPTIONS",
            help="What to make (scegen schema campaign), or descriptions: .jsonl with id and "
            "text, .txt with one a line.",
        ),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Folder; one that is there goes on.")
    ] = None,
    workers: Annotated[
        int | None, typer.Option(min=1, help="Worker processes; all processors if not given.")
    ] = None,
    engine: Annotated[Literal["joblib", "ray"], typer.Option(help="Who runs the work.")] = "joblib",
    address: Annotated[
        str | None, typer.Option(help="Ray cluster to use; DIR must be seen by all its nodes.")
    ] = None,
    verify: Annotated[
        bool, typer.Option("--verify", help="Only look whether all is there, once and whole.")
    ] = False,
    seed: Annotated[int | None, typer.Option(min=0, help="Seed of everything random.")] = None,
    pick: Annotated[
        str | None, typer.Option(help="Logical scenarios of each description: all, numbers, names.")
    ] = None,
    count: Annotated[
        int | None, typer.Option(min=1, help="How many where --pick names none, richest first.")
    ] = None,
    where: WhereOption = None,
    concretizations: Annotated[
        int | None, typer.Option("--concretizations", "-k", min=1, help="How many of each.")
    ] = None,
    target: Annotated[
        str | None, typer.Option(help="What the danger is raised to, as in scegen generate.")
    ] = None,
    confirm: Annotated[
        float | None, typer.Option(min=0.0, max=1.0, help="Share to play in esmini, too.")
    ] = None,
    pictures: Annotated[
        bool, typer.Option("--pictures", help="Draw a preview of every scenario.")
    ] = False,
) -> None:
    """Make a campaign; the same command goes on with one that was stopped."""
    if verify:
        _verify(output or source)
        return
    if source is None:
        raise InputError("names no order", where="RUN.yaml", hint="scegen campaign RUN.yaml -o DIR")
    if output is None:
        raise InputError("names no folder", where="--output", hint="give one with -o DIR")
    given = {
        "seed": seed,
        "pick": pick,
        "count": count,
        "where": where,
        "concretizations": concretizations,
        "target": target,
        "confirm": confirm,
        "pictures": pictures or None,
    }
    changes = {name: value for name, value in given.items() if value is not None}
    with of_extra(*CAMPAIGN):
        finished = _run(source, output, changes, engine, workers, address)
    counted = finished.counted
    result(f"{counted.rows} scenarios, {counted.failed} of them failed")
    took = f"{finished.fresh} made now in {finished.seconds:.1f} s"
    say(f"{took}; all rows together: {finished.digest[:16]}")
    if counted.unheld:
        say(f"a statement does not hold in {counted.unheld}")
    if counted.unsound:
        say(f"a check fails in {counted.unsound}")
    if counted.failed or counted.unheld or counted.unsound:
        say(f"why: scegen campaign report {output}")
        raise typer.Exit(1)


def _run(
    source: Path,
    output: Path,
    changes: dict[str, Any],
    engine: str,
    workers: int | None,
    address: str | None,
) -> Finished:
    import os

    from scegen.campaign.engines import Engine, Workforce
    from scegen.campaign.order import load_campaign
    from scegen.campaign.running import run_campaign

    campaign = load_campaign(source, changes)
    force = Workforce(Engine(engine), workers or os.cpu_count() or 1, address)
    with _watching() as watch:
        try:
            return run_campaign(campaign, output, force, watch)
        except KeyboardInterrupt:
            watch.stop()
            say("interrupted: what is finished is kept, and the same command goes on")
            raise typer.Exit(INTERRUPTED) from None


def _verify(folder: Path | None) -> None:
    if folder is None:
        raise InputError("names no folder", where="--verify", hint="scegen campaign DIR --verify")
    with of_extra(*CAMPAIGN):
        from scegen.campaign.verifying import verify

        found, problems = verify(folder)
    for line in (*found.in_words(), *problems):
        say(line)
    if found.bad or problems:
        result(f"{len(found.done)} scenarios are whole; the same scegen campaign goes on")
        raise typer.Exit(1)
    result(f"{len(found.done)} scenarios, each once, nothing missing, every file as written")
    if found.stray:
        say(f"{found.stray} files in objects/ belong to nothing (left by workers that were killed)")


class _Bars:
    """Bars on a terminal: how many, how fast, how long it still takes."""

    def __init__(self, progress: Progress | None) -> None:
        self.progress = progress
        self.tasks: dict[str, Any] = {}
        self.first: int | None = None

    def planning(self, done: int, total: int) -> None:
        """So many descriptions are planned."""
        self._show("planning", done, total, "")

    def making(self, done: int, failed: int, total: int) -> None:
        """So many scenarios are done."""
        self._show("making", done, total, f"{failed} failed" if failed else "")

    def note(self, text: str) -> None:
        """A line of its own."""
        say(text)

    def stop(self) -> None:
        """Take the bars away."""
        if self.progress is not None:
            self.progress.stop()

    def _show(self, step: str, done: int, total: int, more: str) -> None:
        if self.progress is None:
            return
        if step not in self.tasks:
            self.tasks[step] = self.progress.add_task(step, total=total, more="")
            self.first = done
        task = self.tasks[step]
        seconds = self.progress.tasks[task].elapsed or 0.0
        rate = (done - (self.first or 0)) / seconds if seconds > 0.0 else 0.0
        told = f"{rate:.1f}/s {more}" if rate else more
        self.progress.update(task, completed=done, total=total, more=told)


@contextmanager
def _watching() -> Iterator[_Bars]:
    if not stderr.is_terminal:
        yield _Bars(None)
        return
    done = (SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn())
    left = (TimeElapsedColumn(), TextColumn("left"), TimeRemainingColumn())
    columns = (*done, TextColumn("{task.fields[more]}"), *left)
    with Progress(*columns, console=stderr, transient=True, redirect_stdout=False) as progress:
        yield _Bars(progress)
