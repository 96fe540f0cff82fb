"""Only understanding reads English: without its words a scenario gives the same simulator files."""

import ast
from pathlib import Path

import pytest

from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, Options
from scegen.pipeline.source import resolve_source

ROOT = Path(__file__).parents[2]
SOURCE = ROOT / "src" / "scegen"
WORDS = {"description", "evidence", "unsupported"}
MAY_SHOW_THEM = {
    "benchmark/agents.py": "names a run",
    "benchmark/said.py": "says what was not expressed",
    "claims/told.py": "names the words that a claim rests on",
    "claims/numbers.py": "hands them on",
    "cli/console.py": "a progress bar's own description",
    "campaign/planning.py": "names the description in a row",
    "campaign/parameters.py": "says that a sweep replaces what a number rested on",
    "cli/parse_report.py": "says what was not expressed",
    "concretization/written.py": "hands them on",
    "criticality/agent/agent.py": "names the transcript",
    "criticality/agent/prompting.py": "shows them to a language model",
    "criticality/raising/raising.py": "the evidence of a search, which is no text",
    "llm/transcript.py": "names the transcript",
    "pipeline/contents.py": "writes them into the summary",
    "report/evidence.py": "shows them",
    "report/html.py": "shows them",
    "web/deliveries.py": "shows them",
    "web/provenance.py": "says which of them a change by hand replaces",
    "web/steps/opening.py": "shows them",
    "web/work.py": "shows them, and hands them on",
}
TEXTS = (
    *sorted(str(path) for path in (ROOT / "examples").iterdir()),
    "A crate lies in the ego's lane on a straight road.",
    "A parked van hides a child who steps into the road in front of the ego.",
    "The ego follows a lorry at 20 m; the lorry brakes with 5 m/s² from 60 km/h to 20 km/h.",
    "A car cuts in from the left 15 m in front of the ego, which drives 90 km/h on a motorway.",
    "At a crossroads a cyclist from the right runs the red light while the ego turns left.",
    "Three cars meet at a roundabout with four exits; one of them does not give way to the ego.",
)
SEARCHED = TEXTS[3:5]


def test_nobody_else_touches_the_words():
    found = set()
    for path in SOURCE.rglob("*.py"):
        place = path.relative_to(SOURCE)
        if place.parts[0] in {"understanding", "scenario"}:
            continue
        tree = ast.parse(path.read_text(encoding="utf-8"))
        if any(isinstance(n, ast.Attribute) and n.attr in WORDS for n in ast.walk(tree)):
            found.add(place.as_posix())
    assert found <= set(MAY_SHOW_THEM)


def made(source, folder, target):
    generate(source, folder, Options(depth=CheckDepth.NONE, target=target))
    return {
        path.relative_to(folder): path.read_bytes()
        for path in folder.glob("scenarios/*/*")
        if path.suffix in {".xodr", ".xosc"}
    }


@pytest.mark.parametrize(
    ("text", "target"),
    [*((t, "none") for t in TEXTS), *((t, "near-miss") for t in SEARCHED)],
    ids=lambda value: Path(value).name[:30],
)
def test_the_same_files_without_the_words(tmp_path, text, target):
    told = resolve_source(text)
    untold = told.model_copy(update={"description": "", "evidence": (), "unsupported": ()})
    with_words = made(told, tmp_path / "told", target)
    assert {path.name for path in with_words} >= {"road.xodr", "scenario.xosc"}
    assert made(untold, tmp_path / "untold", target) == with_words
