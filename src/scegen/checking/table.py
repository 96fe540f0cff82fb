"""Check reports as a table for the terminal."""

from __future__ import annotations

from collections.abc import Iterable

from rich.markup import escape
from rich.table import Table

from scegen.checking.results import CheckReport, CheckResult, CheckStatus, Severity

MARKS = {
    CheckStatus.PASSED: "[green]passed[/]",
    CheckStatus.FAILED: "[bold red]FAILED[/]",
    CheckStatus.NOT_RUN: "[bold yellow]NOT RUN[/]",
}
COLOURS = {Severity.ERROR: "red", Severity.WARNING: "yellow", Severity.INFO: "dim"}
SHOWN = 12
"""How many findings of one checker are shown; JSON has them all."""


def reports_table(reports: Iterable[CheckReport]) -> Table:
    """One row per checker and report, with its findings below its detail."""
    table = Table(show_lines=False, expand=False)
    table.add_column("checked", overflow="fold")
    table.add_column("checker", no_wrap=True)
    table.add_column("verdict", no_wrap=True)
    table.add_column("what", overflow="fold")
    for report in reports:
        place = escape(report.folder)
        for result in report.results:
            table.add_row(place, result.checker, MARKS[result.status], _what(result))
            place = ""
        table.add_section()
    return table


def _what(result: CheckResult) -> str:
    lines = [escape(result.detail)] if result.detail else []
    for finding in result.findings[:SHOWN]:
        text = escape(f"{finding.place}: {finding.message} [{finding.rule}]")
        lines.append(f"[{COLOURS[finding.severity]}]{text}[/]")
    if len(result.findings) > SHOWN:
        lines.append(f"and {len(result.findings) - SHOWN} more")
    return "\n".join(lines)
