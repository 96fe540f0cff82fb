"""Words that the reader knows stand in its lexicon and frames, not in its Python."""

import ast
import re
from pathlib import Path

import pytest
import yaml

import scegen.understanding
from scegen.scenario import vocabulary
from scegen.understanding.lexicon.loader import word_lists

PACKAGE = Path(scegen.understanding.__file__).parent
FEWEST = 3
"""So many words make a list."""
OF_OTHERS = {"agents", "report", "frames"}
"""Prompts, reports, and what tells how rows of numbers are matched."""
TABLES = {"words/numbers.py", "words/quantities.py", "semantics/patterns.py",
          "semantics/rows.py", "semantics/cues.py", "amounts/reading.py"}  # fmt: skip
"""Where words stand for numbers, or are the names of what rows may ask for."""
TAGS = {"unknown", "quantity", "num", "ordinal", "punct", "s", "ed", "ing", "base", "while"}
"""Classes, forms and conjunctions as tagging calls them."""
WORD = re.compile(r"[a-z']{2,}( [a-z']+)*")


def values() -> set[str]:
    """What the lexicon calls things by, and what the vocabulary does."""
    found = set(TAGS)
    for path in (PACKAGE / "lexicon").glob("*.yaml"):
        data = yaml.safe_load(path.read_text(encoding="utf-8"))
        for row in data if isinstance(data, list) else []:
            found.update(str(v) for k, v in row.items() if k != "words" and isinstance(v, str))
    kinds = (o for o in vars(vocabulary).values() if isinstance(o, type))
    return found | {
        str(m.value) for kind in kinds for m in getattr(kind, "__members__", {}).values()
    }


def lists(tree: ast.Module) -> list[tuple[int, list[str]]]:
    """Sets of words that a module defines for all its functions."""
    found = []
    for node in tree.body:
        for part in ast.walk(node) if isinstance(node, ast.Assign) else []:
            if isinstance(part, ast.Set):
                words = [e.value for e in part.elts if isinstance(e, ast.Constant)]
                words = [w for w in words if isinstance(w, str) and WORD.fullmatch(w)]
                found.append((part.lineno, words))
    return found


def modules() -> list[Path]:
    return [
        p
        for p in sorted(PACKAGE.rglob("*.py"))
        if p.relative_to(PACKAGE).parts[0] not in OF_OTHERS
        and str(p.relative_to(PACKAGE)) not in TABLES
    ]


def test_no_module_holds_a_list_of_words():
    known = values()
    held = [
        f"{path.relative_to(PACKAGE)}:{line}: {words}"
        for path in modules()
        for line, words in lists(ast.parse(path.read_text(encoding="utf-8")))
        if len(words) >= FEWEST and not set(words) <= known
    ]
    assert not held


def test_a_list_of_words_is_found():
    tree = ast.parse('_X = frozenset({"gently", "softly", "with care"})')
    assert lists(tree) == [(1, ["gently", "softly", "with care"])]


def test_every_list_is_asked_for():
    python = "".join(p.read_text(encoding="utf-8") for p in PACKAGE.rglob("*.py"))
    rows = "".join(p.read_text(encoding="utf-8") for p in (PACKAGE / "frames").glob("*.yaml"))
    unused = [n for n in word_lists("lists") if f'"{n}"' not in python and f"@{n}" not in rows]
    assert not unused


def test_words_that_yaml_takes_for_truth_values_are_words():
    assert all(isinstance(word, str) for words in word_lists("lists").values() for word in words)


@pytest.mark.parametrize("name", ["gently", "standing"])
def test_lists_have_words(name):
    assert len(word_lists("lists")[name]) >= FEWEST


def test_nothing_stands_twice_in_one_class():
    seen: dict[tuple[str, str], str] = {}
    twice = []
    for path in sorted((PACKAGE / "lexicon").glob("*.yaml")):
        data = yaml.safe_load(path.read_text(encoding="utf-8"))
        for row in data if isinstance(data, list) else []:
            kind = str(sorted((k, str(v)) for k, v in row.items() if k != "words"))
            for word in map(str, row.get("words", ())):
                twice += [word] if (kind, word) in seen else []
                seen[kind, word] = path.name
    assert not twice
