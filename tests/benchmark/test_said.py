"""From sentences to what runs: records and judges are files, esmini or our own simulation plays."""

import json
from pathlib import Path

import pytest

from scegen.benchmark import said
from scegen.checking import recording
from scegen.checking.recording import Player
from scegen.errors import InputError

SHARED = Path(__file__).parents[3] / "shared" / "descriptions"
JUDGE = """
def judge(facts, path):
    rows = open(path).read().splitlines()
    top = next(i for i, row in enumerate(rows) if row.startswith("Index"))
    count = sum("Entity_Name" in cell for cell in rows[top].split(","))
    return [(name, wanted, count - 1, count - 1 == wanted) for name, wanted in facts.items()]
"""


@pytest.fixture
def judged(tmp_path):
    path = tmp_path / "judge.py"
    path.write_text(JUDGE)
    return said.load_judge(path)


def _rows(judged, *facts):
    text = "At a crossing the ego turns left while an oncoming car goes straight on."
    return list(said.run([said.Record(f"r{n}", text, f) for n, f in enumerate(facts)], judged))


def test_facts_are_judged_on_what_is_played(judged):
    right, wrong = _rows(judged, {"others": 1}, {"others": 3})
    assert right.right
    assert right.player is not None
    assert not wrong.right
    assert wrong.facts[0].measured == 1
    assert said.tally([right, wrong]) == {"others": (1, 2)}


def test_wrong_is_told_apart_by_whether_anything_was_said_of_it(judged):
    plain, loose = "The ego follows a van.", "The ego follows a zorbling van in a flurb."
    for text, unsaid in ((plain, True), (loose, False)):
        (row,) = said.run([said.Record("a", text, {"others": 3})], judged)
        assert not row.right
        assert row.unsaid == unsaid, row.left_out
    assert "zorbling" in row.to_data()["left_out"]


def test_without_esmini_our_own_simulation_plays(judged, monkeypatch):
    monkeypatch.setattr(recording, "esmini", lambda: None)
    (row,) = _rows(judged, {"others": 1})
    assert row.player is Player.OWN
    assert row.right


def test_what_cannot_be_made_says_why_and_holds_nothing(judged):
    (row,) = said.run([said.Record("a", "My cat sleeps on the sofa.", {"others": 1})], judged)
    assert not row.right
    assert row.problem
    assert said.tally([row]) == {"others": (0, 1)}


def test_a_judge_that_fails_costs_its_row_and_no_other():
    def judge(facts, _path):
        return [(name, wanted, 1 / wanted, True) for name, wanted in facts.items()]

    fails, stands = _rows(judge, {"others": 0}, {"others": 1})
    assert "the judge" in fails.problem
    assert "ZeroDivisionError" in fails.problem
    assert not fails.right
    assert stands.right


def test_records_are_lines_of_json(tmp_path):
    file = tmp_path / "records.jsonl"
    file.write_text(json.dumps({"id": "a", "text": "b", "facts": {}}) + "\n\n")
    assert [record.id for record in said.load_records(file)] == ["a"]
    file.write_text('{"id": "a"}\n')
    with pytest.raises(InputError, match="line 1"):
        said.load_records(file)
    with pytest.raises(InputError, match="no judge"):
        said.load_judge(tmp_path / "none.py")


@pytest.mark.skipif(not SHARED.exists(), reason="the judge does not lie beside the checkout")
@pytest.mark.parametrize("player", ["esmini", "own"])
def test_the_judge_beside_the_checkout_reads_both_players_alike(player, monkeypatch):
    if player == "own":
        monkeypatch.setattr(recording, "esmini", lambda: None)
    text = "The ego goes straight on at a crossing at 50 km/h. A car comes from the right."
    facts = {"ego_speed_kph": 50, "others": 1, "ego_turn": "straight", "approach": "right"}
    judge = said.load_judge(SHARED / said.JUDGE_FILE)
    (row,) = said.run([said.Record("a", text, facts)], judge)
    assert row.problem is None
    assert [fact.name for fact in row.facts] == ["ego_speed_kph", "others", "ego_turn", "approach"]
    assert {f.name for f in row.facts if f.holds} >= {"others", "ego_turn", "approach"}
