"""A parse report on a terminal: the sentence with its spans, then the findings in groups."""

from __future__ import annotations

import unicodedata
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rich.cells import cell_len
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from scegen.report.evidence import STANDS_FOR
from scegen.understanding import Standing, passages

if TYPE_CHECKING:
    from rich.console import Console

    from scegen.understanding import Finding, ParseReport

_STYLES = {
    Standing.UNDERSTOOD: "green",
    Standing.INFERRED: "cyan",
    Standing.ASSUMED: "bright_black",
    Standing.CONTRADICTED: "bold underline red",
    Standing.UNSUPPORTED: "underline yellow",
}
_MARKS = {
    Standing.UNDERSTOOD: "-",
    Standing.INFERRED: "~",
    Standing.ASSUMED: ".",
    Standing.CONTRADICTED: "!",
    Standing.UNSUPPORTED: "?",
}
"""Written below the words where there are no colours."""
_NARROWEST = (20, 18, 14)
"""Columns for who, what and value; more on wide terminals, in proportion."""
_SHARES = (0.22, 0.22, 0.18)
_GROUND = 20
"""Columns for words and reasons, below which they get a line of their own."""


def print_report(report: ParseReport, console: Console) -> None:
    """Prints a report for a person."""
    coloured = not console.no_color and console.color_system is not None
    if coloured:
        console.print(_sentence(report), soft_wrap=False)
    else:
        _ruled(report, console)
    if not report.traffic:
        console.print()
        console.print(Text("This is not about traffic: nothing was understood."))
    groups = {standing: rows(report.of(standing)) for standing in Standing}
    widths = _widths([row for group in groups.values() for row in group], console.width)
    for standing, group in groups.items():
        if group:
            console.print()
            style = _STYLES[standing] if coloured else ""
            mark = "" if coloured else f"{_MARKS[standing]} "
            title = Text(f"{mark}{standing.value}", style)
            console.print(title.append(f" ({STANDS_FOR[standing]})", "not bold not underline dim"))
            _group(group, widths, console)


def _sentence(report: ParseReport) -> Text:
    text = Text()
    for passage in passages(report):
        style = "" if passage.standing is None else _STYLES[passage.standing]
        text.append(_visible(report.text[passage.start : passage.end]), style)
    return text


def _ruled(report: ParseReport, console: Console) -> None:
    """The text line by line, with a line of marks below each that has any."""
    marks = "".join(
        (_MARKS[s.standing] if s.standing else " ") * (s.end - s.start) for s in passages(report)
    )
    text = Text()
    for character, mark in zip(_visible(report.text), marks, strict=True):
        text.append(character, mark)
    for line in text.wrap(console, console.width):
        console.print(Text(line.plain))
        below = [" "] * len(line.plain)
        for span in line.spans:
            below[span.start : span.end] = str(span.style) * (span.end - span.start)
        pairs = zip(line.plain, below, strict=True)
        ruler = "".join(mark * cell_len(character) for character, mark in pairs).rstrip()
        if ruler:
            console.print(Text(ruler))


def _visible(text: str) -> str:
    """As many characters, none of which moves the cursor or commands the terminal."""
    return "".join(map(_shown, text))


def _shown(character: str) -> str:
    if character == "\n":
        return character
    if character.isspace():
        return " "
    return "\ufffd" if unicodedata.category(character) in {"Cc", "Cf", "Cs"} else character


@dataclass(frozen=True, slots=True)
class Row:
    """A finding in words; the same of several participants is one row."""

    who: str
    what: str
    value: str
    ground: str


def rows(findings: tuple[Finding, ...]) -> list[Row]:
    """Findings of one standing as rows, in order."""
    merged: dict[tuple[object, ...], tuple[list[str], list[str], Finding]] = {}
    for finding in findings:
        who, what = _named(finding.field)
        # words that fill no field are told together where the same became of them
        place = finding.start if what else None
        key = (what or who, finding.value, finding.reason, place)
        names, words, _ = merged.setdefault(key, ([], [], finding))
        names.append(who)
        words += [] if finding.words is None else [f'"{_visible(finding.words)}"']
    found = []
    for names, words, finding in merged.values():
        quoted = ", ".join(" ".join(one.split()) for one in dict.fromkeys(words))
        ground = ": ".join(filter(None, (quoted, finding.reason)))
        who = ", ".join(dict.fromkeys(names))
        found.append(Row(who, _named(finding.field)[1], finding.value, ground))
    return found


def _named(field: str | None) -> tuple[str, str]:
    group, _, rest = (field or "").partition(".")
    if group == "participants" and rest:
        group, _, rest = rest.partition(".")
    if rest.isdigit():
        rest = ""
    if group == "hazards":
        group, rest = "hazard", rest if rest.endswith(".to") else f"{rest} by"
    return group, rest.replace(".", " ").replace("_mps", "").replace("_", " ")


def _widths(found: list[Row], width: int) -> tuple[int, ...] | None:
    """Columns for who, what and value, the same in all groups; None where that is too wide."""
    longest = (
        max((len(cell) for cell in cells), default=0)
        for cells in zip(*((row.who, row.what, row.value) for row in found), strict=True)
    )
    most = (max(least, int(s * width)) for least, s in zip(_NARROWEST, _SHARES, strict=True))
    widths = tuple(map(min, longest, most))
    return widths if width - sum(widths) - 2 * len(widths) - 2 >= _GROUND else None


def _group(found: list[Row], widths: tuple[int, ...] | None, console: Console) -> None:
    if widths is None:
        for row in found:
            head = " ".join(filter(None, (row.who, row.what)))
            head += f": {row.value}" if row.value and head else row.value
            if head:
                console.print(Padding(Text(head), (0, 0, 0, 2)))
            console.print(Padding(Text(row.ground), (0, 0, 0, 6 if head else 2)))
        return
    table = Table(box=None, show_header=False, pad_edge=False, padding=(0, 2, 0, 0))
    if any(row.who for row in found):
        for width in widths:
            table.add_column(width=width, overflow="fold")
    table.add_column(overflow="fold")
    for row in found:
        cells = (row.who, row.what, row.value) if len(table.columns) > 1 else ()
        table.add_row(*map(Text, cells), Text(row.ground))
    console.print(Padding(table, (0, 0, 0, 2)))
