"""Lists while they are made: nothing held, whole at every interruption."""

from __future__ import annotations

import json
import signal
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import typer

from scegen.cli.certificates import head, line, tell_claim
from scegen.cli.console import INTERRUPTED, counting, result, say
from scegen.scenario.wording import counted

if TYPE_CHECKING:
    from scegen.enumeration import Listing
    from scegen.scenario.logical import LogicalScenario


@contextmanager
def listing_under_way(listing: Listing) -> Iterator[Iterator[LogicalScenario]]:
    """The scenarios, with progress shown; an interruption says how far it came."""
    try:
        with counting(listing.expected) as tick:
            yield _interruptible(tick(listing))
    except KeyboardInterrupt:
        looked = "" if listing.listed == listing.seen else f" ({listing.seen:,} looked at)"
        of = counted(listing.expected, "scenario")
        say(f"interrupted: {listing.listed:,} of {of} listed{looked}")
        raise typer.Exit(INTERRUPTED) from None


def _interruptible(scenarios: Iterable[LogicalScenario]) -> Iterator[LogicalScenario]:
    """The same, where Ctrl-C waits until a scenario is written; a second one does not wait."""
    asked: list[int] = []

    def note(number: int, _: object) -> None:
        if asked:
            raise KeyboardInterrupt
        asked.append(number)

    before = signal.getsignal(signal.SIGINT)
    if before is not signal.SIG_IGN:  # ignored in the background: it stays so
        signal.signal(signal.SIGINT, note)
    try:
        for scenario in scenarios:
            yield scenario
            if asked:
                raise KeyboardInterrupt
    finally:
        signal.signal(signal.SIGINT, before)


def stream_lines(listing: Listing) -> None:
    """Results line by line as they are found; what is claimed of them, at the end."""
    with listing_under_way(listing) as scenarios:
        for scenario in scenarios:
            result(line(scenario))
    tell_claim(listing.certificate(), listing.reduction, listing.arms, listing.notes)


def stream_json(listing: Listing) -> None:
    """One JSON document, written as scenarios are found; whole even if interrupted."""

    def claim() -> dict[str, object]:
        return head(listing.certificate(), listing.reduction, listing.arms)

    known = {name: claim()[name] for name in ("total", "count")}
    with listing_under_way(listing) as scenarios:
        write_json(
            known, scenarios, lambda: {n: value for n, value in claim().items() if n not in known}
        )


def write_json(
    first: dict[str, object],
    scenarios: Iterable[LogicalScenario],
    last: Callable[[], dict[str, object]],
) -> None:
    """The members of ``first``, the scenarios, one on a line, and what is known at the end."""
    write = sys.stdout.write
    write("{" + "".join(f"\n  {_member(*member)}," for member in first.items()))
    write('\n  "scenarios": [')
    try:
        for number, scenario in enumerate(scenarios):
            write(("," if number else "") + "\n    " + scenario.model_dump_json())
    finally:
        members = "".join(f",\n  {_member(*member)}" for member in last().items())
        write(f"\n  ]{members}\n}}\n")
        sys.stdout.flush()


def _member(name: str, value: object) -> str:
    nested = json.dumps(value, indent=2, ensure_ascii=False).replace("\n", "\n  ")
    return f"{json.dumps(name)}: {nested}"
