"""Every block of the pages is true: commands print what follows them, Python runs, files are read.

A fence says what it holds: ``console`` commands after ``$`` (``…`` stands for whatever is there),
``python`` what is run, ``title="NAME"`` a file that the next ones find, and
``text`` nothing to be run. One folder a page, from top to bottom. A remark before a fence says what
it ``needs``, that it is ``not run`` and why, or that its last command ``ends with`` a code but 0.
"""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from contextlib import chdir
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

import pytest
import yaml
from command import SOURCE

from scegen.checking.environment import esmini
from scegen.closed_loop import esmini_library

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
FENCE = re.compile(
    r"(?P<remarks>(?:^ *<!-- (?:(?!-->).)*-->\n)*)"
    r"^(?P<indent> *)```(?P<language>\w*)(?P<more>[^\n]*)\n(?P<text>.*?)^ *```$",
    re.DOTALL | re.MULTILINE,
)
REMARK = re.compile(r"<!-- (in|new|needs|not run|ends with):? (.*?) -->", re.DOTALL)
TESTED_ELSEWHERE = {"in", "new"}  # changes to the program, by tests/pipeline/test_adding.py
HAVE = {
    "esmini": lambda: esmini() is not None,
    "esmini's library": lambda: esmini_library() is not None,
    "a model": lambda: find_spec("pydantic_ai") is not None,  # a scripted one answers
    "exchange": lambda: find_spec("mcap") is not None,
}
SHOWN = {"text", "json", "xml"}


class Block(NamedTuple):
    """One fence, and what is said before it."""

    language: str
    title: str | None
    text: str
    remarks: dict[str, str]


def blocks(text):
    for found in FENCE.finditer(text):
        title = re.search(r'title="([^"]+)"', found["more"])
        lines = [line.removeprefix(found["indent"]) for line in found["text"].splitlines(True)]
        remarks = dict(REMARK.findall(found["remarks"]))
        yield Block(found["language"], title and title[1], "".join(lines), remarks)


def commands(text):
    """Every command with what it shows."""
    for part in re.split(r"(?m)^\$ ", text)[1:]:
        asked, _, shown = part.replace("\\\n", "").partition("\n")
        yield asked, shown.splitlines()


def shows(lines, done):
    """Whether this was printed, line by line; of what goes to stderr lines may be left out.

    An ellipsis stands for anything within a line, alone for any lines of stdout.
    """
    stdout, stderr = (
        [line.rstrip() for line in s.splitlines()] for s in (done.stdout, done.stderr)
    )
    skipping = False
    for line in lines:
        if line == "…":
            skipping = True
            continue
        pattern = re.compile(".*".join(map(re.escape, line.rstrip().split("…"))))
        within = [n for n, told in enumerate(stdout) if pattern.fullmatch(told)]
        if within and (skipping or within[0] == 0):
            del stdout[: within[0] + 1]
            skipping = False
        else:
            within = [n for n, told in enumerate(stderr) if pattern.fullmatch(told)]
            if not within:
                return False
            del stderr[: within[0] + 1]
    return skipping or not stdout


def run_commands(block, scegen, folder):
    every = list(commands(block.text))
    assert every, "a console block without a command"
    for number, (command, shown) in enumerate(every):
        into = re.search(r" > ([\w.]+)$", command)
        asked = command.removesuffix(into[0]) if into else command
        program, *arguments = shlex.split(asked, comments=True)
        if program == "scegen":
            done = scegen(*arguments)
        else:
            python = program == "python"
            done = subprocess.run(
                [sys.executable if python else program, *arguments],
                cwd=folder,
                env={**os.environ, "PYTHONPATH": SOURCE},
                capture_output=True,
                text=True,
                check=False,
            )
        told = f"$ {command}\n{done.stdout}{done.stderr}"
        code = int(block.remarks.get("ends with", 0)) if number == len(every) - 1 else 0
        assert done.returncode == code, told
        if into:
            (folder / into[1]).write_text(done.stdout, encoding="utf-8")
            done.stdout = ""
        assert shows(shown, done), told


def test_nothing_escapes():
    """What is set off by indenting alone would not be run."""
    for page in PAGES:
        text = FENCE.sub("", page.read_text("utf-8"))
        assert "```" not in text, page
        assert not re.search(r"(?m)\A    \S|\n\n    (?![-*\d])\S", text), page


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_blocks_are_true(scegen, page, tmp_path, monkeypatch, request):
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    names, lacking, text = {}, set(), page.read_text("utf-8")
    if "<!-- needs: a model -->" in text and HAVE["a model"]():
        server = request.getfixturevalue("chat_server")
        server.answers = request.getfixturevalue("good_answers")
        monkeypatch.setenv("OPENAI_BASE_URL", server.url)
        monkeypatch.setenv("OPENAI_API_KEY", "sk-of-nobody")
    for block in blocks(text):
        remarks = block.remarks
        if TESTED_ELSEWHERE & set(remarks) or remarks.get("not run"):
            continue
        need = remarks.get("needs")
        if need and not HAVE[need]():
            lacking.add(need)
        elif block.title:
            (tmp_path / block.title).write_text(block.text, encoding="utf-8")
        elif block.language == "console":
            run_commands(block, scegen, tmp_path)
        elif block.language == "python":
            with chdir(tmp_path):
                exec(compile(block.text, str(page), "exec"), names)  # noqa: S102
        elif block.language == "yaml":
            assert yaml.safe_load(block.text)
        else:
            assert block.language in SHOWN, f"what is to be done with {block.language!r}?"
    if lacking:
        pytest.skip(f"all but what needs {', '.join(sorted(lacking))}")
