"""scegen understand --report: the sentence with coloured spans, and a table of findings."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from scegen.cli.console import result, result_json

if TYPE_CHECKING:
    from rich.console import Console

    from scegen.errors import InfeasibleError
    from scegen.scenario.functional import FunctionalScenario
    from scegen.understanding import ParseReport

_STYLES = {
    "understood": "green",
    "inferred": "cyan",
    "assumed": "bright_black",
    "unsupported": "yellow",
    "contradicted": "bold red",
}
"""By standing, in the order in which later ones are painted over earlier ones."""


def show_report(functional: FunctionalScenario, *, as_json: bool = False) -> None:
    """Prints the report on an understood description.

    Args:
        functional: the scenario with its evidence.
        as_json: print JSON instead.
    """
    from scegen.understanding import report_on

    _show(report_on(functional), as_json)


def show_contradiction(source: str, error: InfeasibleError, *, as_json: bool = False) -> None:
    """Prints the report on a description that contradicts itself.

    Args:
        source: the description, or the file that holds it.
        error: what is wrong with it.
        as_json: print JSON instead.
    """
    from scegen.scenario.files import read_text
    from scegen.understanding import report_on_contradiction

    file = "\n" not in source and len(source) < 1024 and Path(source).is_file()
    text = read_text(Path(source)) if file else source
    _show(report_on_contradiction(text, error), as_json)


def _show(report: ParseReport, as_json: bool) -> None:
    from rich.console import Console

    console = Console()
    if as_json:
        result_json(report.to_data())
    elif console.is_terminal:
        _coloured(report, console)
    else:
        _plain(report)


def _coloured(report: ParseReport, console: Console) -> None:
    from rich.table import Table
    from rich.text import Text

    sentence = Text(report.text)
    for standing, style in _STYLES.items():
        for finding in report.findings:
            if finding.standing == standing and finding.start is not None:
                sentence.stylize(style, finding.start, finding.end)
    console.print(sentence)
    legend = Text("  ").join(Text(name, style) for name, style in _STYLES.items())
    console.print(legend, "")
    table = Table(box=None, pad_edge=False)
    for name in ("standing", "field", "value", "words", "reason"):
        table.add_column(name, overflow="fold")
    for finding in report.findings:
        table.add_row(
            Text(finding.standing, _STYLES[finding.standing]),
            Text(finding.field or ""),
            Text(finding.value),
            Text(finding.words or ""),
            Text(finding.reason or ""),
        )
    console.print(table)


def _plain(report: ParseReport) -> None:
    """One finding a line, columns parted by tabs: easy to read, cut and search."""
    result(report.text)
    result("")
    result("standing\tfield\tvalue\twords\treason")
    for finding in report.findings:
        cells = (finding.field, finding.value, finding.words, finding.reason)
        flat = (" ".join((cell or "-").split()) for cell in cells)
        result("\t".join((finding.standing.value, *flat)))
