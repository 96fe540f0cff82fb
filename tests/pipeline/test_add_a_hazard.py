"""The worked example of docs/add-a-hazard.md, done in a copy of the program."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "add-a-hazard.md").read_text(encoding="utf-8")
STEP = re.compile(
    r"<!-- in (?P<file>\S+) (?P<where>after|before) (?P<anchor>.+?) -->\n"
    r"```python\n(?P<text>.*?)```",
    re.DOTALL,
)
KNOWN = """
from scegen.scenario.files import json_schema
from scegen.scenario.glossary import page
from scegen.understanding.agents.prompting import prompts
assert "too little room beside it" in page()
assert "too little room beside it" in str(json_schema("functional"))
assert "too little room beside it" in prompts()["hazards"]
"""


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """Runs the copy."""
    folder = tmp_path_factory.mktemp("copy")
    shutil.copytree(ROOT / "src", folder / "src")
    steps = list(STEP.finditer(PAGE))
    assert len(steps) == 7
    for step in steps:
        file = folder / step["file"]
        before = file.read_text(encoding="utf-8")
        assert before.count(step["anchor"]) == 1, step["anchor"]
        place, text = step["anchor"], step["text"]
        added = text + place if step["where"] == "before" else f"{place}\n{text.rstrip()}"
        file.write_text(before.replace(place, added), encoding="utf-8")

    def run(*arguments):
        done = subprocess.run(
            [sys.executable, *arguments],
            cwd=folder,
            env=os.environ | {"PYTHONPATH": str(folder / "src")},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        return folder

    return run


def test_every_part_that_reads_the_table_knows_it(run):
    run("-c", KNOWN)


def test_it_happens(run):
    (ask,) = re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL)
    folder = run("-c", "pass")
    (folder / "ask.yaml").write_text(ask, encoding="utf-8")
    run("-m", "scegen", "generate", "ask.yaml", "-o", "out", "--check", "none")
    (proof,) = (folder / "out" / "scenarios").glob("*/proof.json")
    (danger,) = json.loads(proof.read_text(encoding="utf-8"))["hazards"]
    assert danger["kind"] == "close_passing"
    assert danger["happened"]
