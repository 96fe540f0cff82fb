"""What the pages on adding things say, done in copies of the program."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs" / "how-to"
CHANGE = re.compile(
    r"<!-- in (?P<file>\S+) (?P<where>after|before) (?P<anchor>.+?) -->\n"
    r"```(?:python|yaml)\n(?P<text>.*?)```",
    re.DOTALL,
)
FILE = re.compile(r"<!-- new (?P<file>\S+) -->\n```python\n(?P<text>.*?)```", re.DOTALL)


@pytest.fixture(scope="module")
def changed(tmp_path_factory):
    """Makes a copy with the changes of a page, and runs Python in it."""

    def change(page):
        folder = tmp_path_factory.mktemp(page)
        shutil.copytree(ROOT / "src", folder / "src")
        text = (DOCS / f"{page}.md").read_text(encoding="utf-8")
        for file in FILE.finditer(text):
            (folder / file["file"]).write_text(file["text"], encoding="utf-8")
        changes = list(CHANGE.finditer(text))
        assert len(changes) == text.count("<!-- in ") > 0
        for step in changes:
            _change(folder / step["file"], step["where"], step["anchor"], step["text"])
        return folder

    return change


def _change(file, where, anchor, text):
    before = file.read_text(encoding="utf-8")
    assert before.count(anchor) == 1, anchor
    added = text + anchor if where == "before" else f"{anchor}\n{text.rstrip()}"
    file.write_text(before.replace(anchor, added), encoding="utf-8")


def run(folder, *arguments):
    """What Python prints there; not compiled: the little that is moved is soon computed."""
    done = subprocess.run(
        [sys.executable, *arguments],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(folder / "src"), "NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


KNOWN = """
from scegen.scenario.files import json_schema
from scegen.scenario.glossary import page
from scegen.understanding.agents.prompting import prompts
assert "too little room beside it" in page()
assert "too little room beside it" in str(json_schema("functional"))
assert "too little room beside it" in prompts()["hazards"]
"""


def test_a_danger(changed):
    folder = changed("add-a-hazard")
    run(folder, "-c", KNOWN)
    page = (DOCS / "add-a-hazard.md").read_text(encoding="utf-8")
    (ask,) = re.findall(r"```yaml\n(.*?)```", page, re.DOTALL)
    (folder / "ask.yaml").write_text(ask, encoding="utf-8")
    run(folder, "-m", "scegen", "generate", "ask.yaml", "-o", "out", "--check", "none")
    (proof,) = (folder / "out" / "scenarios").glob("*/proof.json")
    (danger,) = json.loads(proof.read_text(encoding="utf-8"))["hazards"]
    assert danger["kind"] == "close_passing"
    assert danger["happened"]


MEASURED = """
from importlib import import_module
import numpy as np
from scegen.measures import MEASURES, measure_named
from scegen.measures.evaluation import Summary, evaluate
from scegen.measures.tables import build_tables
from scegen.motion.batch import build_program
from scegen.motion.paths import Path
from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ParticipantKind
measure = measure_named("closing_speed")
assert import_module(f"scegen.measures.{measure.defined_by}").__doc__
s = np.arange(0.0, 101.0)
east = Path(s, s - 50.0, 0.0 * s, 0.0 * s, ())
north = Path(s, 0.0 * s, s - 50.0, 0.0 * s + np.pi / 2, ())
program, candidates = build_program([east, north], [9.0, 12.0], [[], []])
scene = build_tables([east, north], [BODIES[ParticipantKind.CAR]] * 2, occlusions=[], friction=1.0)
summary = evaluate(program, candidates, scene, duration_s=1.0)
assert abs(getattr(summary, measure.field)[0, 0] - 15.0) < 1e-6
"""


def test_a_measure(changed):
    run(changed("add-a-measure"), "-c", MEASURED)


RULE = """
from scegen.checking.opendrive import RULES, check_opendrive
from scegen.export.opendrive import write_opendrive
from scegen.road import build_network, plan_road
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import JunctionKind
assert [rule for rule in RULES if rule.__name__ == "check_narrow"]
network = build_network(plan_road(Junction(kind=JunctionKind.FOUR_WAY, arms=4)))
content = write_opendrive(network)
assert check_opendrive("road.xodr", content.encode()).result.findings == ()
narrow = content.replace('a="3.5', 'a="1.5')
assert narrow != content
found = check_opendrive("road.xodr", narrow.encode()).result.findings
assert "xodr.lane_narrow" in {f.rule for f in found}
"""


def test_a_checker_rule(changed):
    run(changed("add-a-checker-rule"), "-c", RULE)


NAMED = """
import httpx2
from scegen.llm import parse_models
from scegen.llm.providers import build_model
(name,) = parse_models("github:openai/gpt-4o-mini")
model = build_model(name, url=None, key="none", http_client=httpx2.AsyncClient())
assert model.model_name == "openai/gpt-4o-mini"
"""


def test_a_provider(changed):
    pytest.importorskip("pydantic_ai")
    run(changed("add-a-provider"), "-c", NAMED)


TAUGHT = """
import json, sys
from scegen.understanding import read
for line in sys.stdin.read().splitlines():
    print(read(line).model_dump_json())
"""
SENTENCES = (
    "A van whooshes out in front of the ego from the next lane on a motorway.",
    "A child whooshes out from behind a parked van.",
    "The driver of an oncoming truck zonks out on a straight road.",
    "The ego follows a truck, hanging back 30 m.",
)


def readings(folder):
    done = subprocess.run(
        [sys.executable, "-c", TAUGHT],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(folder / "src")},
        input="\n".join(SENTENCES),
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    found = [json.loads(line) for line in done.stdout.splitlines()]
    return [
        ({h["kind"] for h in f["hazards"]}, len(f["unsupported"]), f["spacings"]) for f in found
    ]


def test_the_reader_is_taught(changed):
    page = (DOCS / "teach-the-reader.md").read_text(encoding="utf-8")
    assert all(sentence in page.replace("\n", " ") for sentence in SENTENCES)
    before = readings(ROOT)
    after = readings(changed("teach-the-reader"))
    assert [kinds for kinds, _, _ in after] == [
        {"cut_in"},
        {"crossing_pedestrian", "occlusion"},
        {"loss_of_control"},
        set(),
    ]
    assert all(unknown for _, unknown, _ in before)
    assert [unknown for _, unknown, _ in after] == [0, 0, 0, 0]
    (gap,) = after[3][2]
    assert (gap["measure"], gap["value"]["low"]) == ("gap_m", 30.0)
