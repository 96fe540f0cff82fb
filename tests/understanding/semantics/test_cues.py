"""A row that cues pass over would not fit, and cues that were found once still hold."""

import json
from pathlib import Path

import pytest

from scegen.errors import ScegenError
from scegen.understanding import read
from scegen.understanding.semantics import cues
from scegen.understanding.semantics.rows import Families

SAID = Path(__file__).parents[1] / "said.jsonl"
TEXTS = [json.loads(line)["text"] for line in SAID.read_text(encoding="utf-8").splitlines()]


@pytest.fixture
def passed_over(monkeypatch):
    """Asks every row that is passed over all the same, and finds all cues anew."""
    asked = Families.asked
    wrong = []

    def watched(self, family, clause, context):
        found = asked(self, family, clause, context)
        if found and clause.cues != cues._found(clause.event, context.words):
            wrong.append(("stale", family, context.draft.text))
        left_out = [row for row in self.rows.get(family, ()) if row not in found]
        fitting = [row for row in left_out if all(test(clause, context) for test in row.tests)]
        wrong.extend((family, row.needs, context.draft.text) for row in fitting)
        return found

    monkeypatch.setattr(Families, "asked", watched)
    return wrong


@pytest.mark.parametrize("begin", range(7))
def test_no_row_is_passed_over_that_fits(passed_over, begin):
    for text in TEXTS[begin::7]:
        try:
            read(text)
        except ScegenError:
            continue
    assert passed_over == []
