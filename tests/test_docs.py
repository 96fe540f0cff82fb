"""Pages name only what is there."""

import re
from pathlib import Path

import pytest

from scegen.scenario.files import json_schema

ROOT = Path(__file__).parents[1]
PAGES = [*sorted((ROOT / "docs").rglob("*.md")), ROOT / "README.md", ROOT / "CONTRIBUTING.md"]
NEW = re.compile(r"<!-- new (\S+) -->")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_files_that_a_page_names_are_there(page):
    text = page.read_text(encoding="utf-8")
    named = set(re.findall(r"`((?:src|tests|benchmarks|docs)/[\w./-]+)`", text))
    missing = {name for name in named - set(NEW.findall(text)) if not (ROOT / name).exists()}
    assert not missing


@pytest.mark.parametrize("page", [p for p in PAGES if p.parent == ROOT], ids=lambda page: page.name)
def test_links_lead_somewhere(page):
    """Those of docs/ are for `make docs`, which refuses any that leads nowhere."""
    links = re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))
    missing = {link for link in links if not (page.parent / link).exists()}
    assert not missing


def test_the_architecture_names_every_package():
    text = (ROOT / "docs" / "explanation" / "architecture.md").read_text(encoding="utf-8")
    rows = [line.split("|")[1] for line in text.splitlines() if line.startswith("| `")]
    named = {name for row in rows for name in re.findall(r"`(\w+)`", row)}
    source = ROOT / "src" / "scegen"
    parts = {f.name for f in source.iterdir() if f.is_dir() and any(f.glob("*.py"))}
    parts |= {f.stem for f in source.glob("*.py") if not f.stem.startswith("_")}
    assert named == parts


def test_every_field_of_the_functional_level_is_told():
    """Level by level: the fields of the whole, and those of each of its parts."""
    text = (ROOT / "docs" / "reference" / "json.md").read_text(encoding="utf-8")
    schema = json_schema("functional")
    own = {"level", "description", "evidence", "unsupported"}
    parts = [schema["$defs"][name] for name in ("Junction", "Participant", "Act", "Group")]
    fields = set(schema["properties"]) | {name for part in parts for name in part["properties"]}
    assert not {name for name in fields - own if not re.search(rf"\b{name}\b", text)}
