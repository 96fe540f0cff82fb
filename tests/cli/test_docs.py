"""The examples in docs/ do what the text says: what a $ line prints is what follows it."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"
PAGES = [page for page in sorted(DOCS.glob("*.md")) if "```console\n$ " in page.read_text("utf-8")]


def test_there_are_examples():
    assert {"where.md", "rules.md", "choosing.md"} <= {page.name for page in PAGES}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_examples_print_what_they_say(scegen, page, tmp_path):
    """A ``% file: name`` block is written; ! lines are stderr, all others stdout."""
    text = page.read_text("utf-8")
    for name, content in re.findall(r"```\w+\n% file: (\S+)\n(.*?)```", text, re.DOTALL):
        (tmp_path / name).write_text(content, encoding="utf-8")
    blocks = re.findall(r"```console\n(.*?)```", text, re.DOTALL)
    commands = [part for block in blocks for part in re.split(r"(?m)^\$ ", block)[1:]]
    for command in commands:
        asked, _, shown = command.partition("\n")
        program, *arguments = shlex.split(asked)
        assert program == "scegen"
        done = scegen(*arguments)
        lines = shown.splitlines()
        assert done.stdout.splitlines() == [x for x in lines if not x.startswith("!")], asked
        for complaint in (x.removeprefix("! ") for x in lines if x.startswith("!")):
            assert complaint in done.stderr, asked
