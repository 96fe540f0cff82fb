"""The parse report on a terminal: in colour, without, wide and narrow."""

import io
import re

import pytest
from rich.console import Console

from scegen.cli.findings import print_report, rows
from scegen.understanding import ParseReport, Standing, paper_cases, parse_report

TEXT = "In rain a purplish van turns left at a crossroads; several buses wait in snow."
ESCAPE = re.compile(r"\x1b\[[0-9;]*m")


def printed(report, width=80, colour="truecolor", **options):
    out = io.StringIO()
    console = Console(
        file=out, width=width, color_system=colour, force_terminal=True, highlight=False, **options
    )
    print_report(report, console)
    return out.getvalue()


def test_spans_are_coloured():
    first = printed(parse_report(TEXT)).splitlines()[0]
    assert ESCAPE.sub("", first) == TEXT
    assert "\x1b[4;33mpurplish\x1b[0m" in first
    assert "\x1b[1;4;31msnow\x1b[0m" in first
    assert "\x1b[32mturns left\x1b[0m" in first


@pytest.mark.parametrize("options", [{"colour": None}, {"no_color": True}])
def test_without_colours_marks_stand_below_the_words(options):
    text, marks, *_ = ESCAPE.sub("", printed(parse_report(TEXT), **options)).splitlines()
    assert text == TEXT
    by_mark = {}
    for match in re.finditer(r"([-~?!.])\1*", marks):
        by_mark.setdefault(match[1], []).append(text[match.start() : match.end()])
    assert by_mark["?"] == ["purplish", "wait"]
    assert by_mark["!"] == ["snow"]
    assert by_mark["~"] == ["several buses"]
    assert "turns left" in by_mark["-"]


def test_the_marks_are_explained():
    out = printed(parse_report(TEXT), colour=None)
    for line in ("- understood (said", "~ inferred (", "! contradicted (", "? unsupported ("):
        assert line in out


def test_wide_characters_take_two_marks():
    out = printed(parse_report("日本 A van turns left."), colour=None).splitlines()
    assert out[1].index("-") == 5


@pytest.mark.parametrize("width", [30, 48, 80, 200])
@pytest.mark.parametrize("colour", ["truecolor", None])
def test_lines_fit_and_no_word_is_cut(width, colour):
    for case in paper_cases():
        out = ESCAPE.sub("", printed(parse_report(case.text), width, colour))
        assert all(len(line.rstrip()) <= width for line in out.splitlines())
        words = set(out.replace('"', " ").split())
        assert set(case.text.replace('"', " ").split()) <= words


def test_equal_findings_of_several_are_one_row():
    (row,) = (r for r in rows(parse_report(TEXT).of(Standing.INFERRED)) if r.what == "kind")
    assert (row.who, row.value) == ("bus_1, bus_2, bus_3", "bus")


def test_nothing_commands_the_terminal():
    text = "A van\x1b[2J turns\tleft\r\nat a \x07crossroads \u202eeht."
    out = ESCAPE.sub("", printed(parse_report(text), 120))
    assert not set(out) & set("\x1b\r\x07\u202e\t")
    # spans still lie on the words
    coloured = printed(parse_report(text), 120)
    assert re.search(r"\x1b\[32mcrossroads\x1b\[0m", coloured)


def test_markup_is_text():
    out = ESCAPE.sub("", printed(parse_report("A [bold]van[/bold] turns left."), 120))
    assert out.splitlines()[0] == "A [bold]van[/bold] turns left."


def test_other_subjects_are_said_to_be_so():
    out = printed(ParseReport("The cat sleeps.", (), traffic=False))
    assert "The cat sleeps." in out
    assert "not about traffic" in out
