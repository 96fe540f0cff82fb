"""Check reports as a table for the terminal."""

from collections import defaultdict
from collections.abc import Iterable

from rich.markup import escape
from rich.table import Table

from scegen.checking.results import CheckReport, CheckResult, CheckStatus, Severity

MARKS = {
    CheckStatus.PASSED: "[green]passed[/]",
    CheckStatus.FAILED: "[bold red]FAILED[/]",
    CheckStatus.NOT_RUN: "[bold yellow]NOT RUN[/]",
}
COLOURS = {
    Severity.ERROR: "red",
    Severity.WARNING: "yellow",
    Severity.INFO: "dim",
    Severity.UNCHECKED: "cyan",
}
ORDER = (Severity.ERROR, Severity.UNCHECKED, Severity.WARNING, Severity.INFO)
KINDS = {Severity.WARNING: "remark: ", Severity.UNCHECKED: "not looked at: "}
SHOWN = 12
"""How many findings of one checker are shown; JSON has them all."""
PLACES = 4
"""How many places of the same finding are named."""


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
    alike: dict[tuple[Severity, str, str], list[str]] = defaultdict(list)
    for finding in sorted(result.findings, key=lambda found: ORDER.index(found.severity)):
        alike[finding.severity, finding.rule, finding.message].append(finding.place)
    for (severity, rule, message), places in list(alike.items())[:SHOWN]:
        named = ", ".join(places[:PLACES])
        if len(places) > PLACES:
            named += f" and {len(places) - PLACES} more"
        text = escape(f"{KINDS.get(severity, '')}{named}: {message} [{rule}]")
        lines.append(f"[{COLOURS[severity]}]{text}[/]")
    if len(alike) > SHOWN:
        lines.append(f"and {len(alike) - SHOWN} more")
    return "\n".join(lines)
