"""scegen understand --report: the sentence with coloured spans, and a table of findings."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rich.console import Console

from scegen.cli.console import result, result_json, say
from scegen.errors import InfeasibleError, NotTrafficError

if TYPE_CHECKING:
    from collections.abc import Iterable

    from scegen.errors import InputError
    from scegen.scenario.functional import FunctionalScenario
    from scegen.understanding import ParseReport
    from scegen.understanding.report.parse_report import Disagreement


def tell_unsupported(functional: FunctionalScenario) -> None:
    """Words that no field expresses, beside the result."""
    for phrase in functional.unsupported:
        say(f'not expressed: "{phrase.text}" ({phrase.instead})')


def show_report(
    functional: FunctionalScenario,
    disagreements: Iterable[Disagreement] = (),
    *,
    as_json: bool = False,
) -> None:
    """Prints the report on an understood description."""
    from scegen.understanding import report_on

    _show(report_on(functional, disagreements), as_json)


def show_refusal(text: str, error: InputError, *, as_json: bool = False) -> None:
    """Prints the report on a description that contradicts itself, or is not about traffic."""
    from scegen.understanding import ParseReport, report_on_contradiction

    if isinstance(error, InfeasibleError):
        _show(report_on_contradiction(text, error), as_json)
    elif isinstance(error, NotTrafficError):
        _show(ParseReport(text, (), traffic=False), as_json)


def _show(report: ParseReport, as_json: bool) -> None:
    console = Console(highlight=False)
    if as_json:
        result_json(report.to_data())
    elif console.is_terminal:
        from scegen.cli.findings import print_report

        print_report(report, console)
    else:
        _plain(report)


def _plain(report: ParseReport) -> None:
    """One finding a line, columns parted by tabs: easy to read, cut and search."""
    result(report.text)
    result("" if report.traffic else "not about traffic: nothing was understood")
    result("standing\tfield\tvalue\twords\treason")
    for finding in report.findings:
        cells = (finding.field, finding.value, finding.words, finding.reason)
        flat = (" ".join((cell or "-").split()) for cell in cells)
        result("\t".join((finding.standing.value, *flat)))
