"""What a campaign may be told, and what is said of what it may not."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.campaign.order import Sweep, load_campaign
from scegen.errors import InputError, VocabularyError


def test_both_ends_of_a_sweep_belong_to_it():
    sweep = Sweep.model_validate({"from": 10, "to": 60, "step": 5})
    assert sweep.points == tuple(float(v) for v in range(10, 61, 5))
    assert Sweep.model_validate({"from": 0.0, "to": 0.3, "step": 0.1}).points == (0, 0.1, 0.2, 0.3)


@given(st.floats(-50, 50), st.integers(0, 200), st.floats(0.01, 10))
def test_every_step_of_a_sweep_is_one(first, count, step):
    points = Sweep.model_validate({"from": first, "to": first + count * step, "step": step}).points
    assert len(points) == count + 1
    assert points == tuple(sorted(points))


@pytest.mark.parametrize(
    "said",
    [
        {"from": 10, "to": 60},
        {"from": 60, "to": 10, "step": 5},
        {"from": 1, "to": 2, "step": 0},
        {"from": 0, "to": 1, "step": 1e-9},
        {"from": 1, "to": 2, "step": 1, "values": [3]},
        {},
    ],
)
def test_a_sweep_that_is_none_is_refused(tmp_path, said):
    order = {"level": "campaign", "sweep": {"ego.speed_kph": said}}
    (tmp_path / "run.json").write_text(json.dumps(order), encoding="utf-8")
    with pytest.raises(VocabularyError, match="sweep"):
        load_campaign(tmp_path / "run.json", {})


def test_descriptions_come_from_files_of_every_kind(tmp_path):
    (tmp_path / "some.jsonl").write_text(
        '{"id": "a", "text": "Two cars meet.", "facts": {}}\n\n{"id": "b", "text": "x"}\n',
        encoding="utf-8",
    )
    (tmp_path / "more.txt").write_text("First.\n\nSecond.\n", encoding="utf-8")
    (tmp_path / "run.yaml").write_text(
        "level: campaign\nfiles: [some.jsonl, more.txt]\ndescriptions: [{id: own, text: Own.}]\n",
        encoding="utf-8",
    )
    order = load_campaign(tmp_path / "run.yaml", {"seed": 7})
    assert [d.id for d in order.descriptions] == ["own", "a", "b", "more-1", "more-2"]
    assert order.seed == 7
    assert [d.text for d in load_campaign(tmp_path / "more.txt", {}).descriptions] == [
        "First.",
        "Second.",
    ]


@pytest.mark.parametrize(
    ("content", "word"),
    [
        ('{"id": "a"', "no JSON"),
        ('{"id": "a"}', "text or a file"),
        ('{"id": "a", "text": "x"}\n{"id": "a", "text": "y"}', "two descriptions"),
        ("[1]", "no object"),
        ("", "names no description"),
    ],
)
def test_what_is_no_list_of_descriptions_is_told(tmp_path, content, word):
    file = tmp_path / "list.jsonl"
    file.write_text(content, encoding="utf-8")
    with pytest.raises(InputError, match=word):
        load_campaign(file, {})


def test_a_wrong_target_or_field_is_told(tmp_path):
    file = tmp_path / "list.txt"
    file.write_text("Two cars meet.", encoding="utf-8")
    with pytest.raises(InputError, match="target"):
        load_campaign(file, {"target": "disaster"})
    (tmp_path / "run.yaml").write_text("level: campaign\ncuont: 3\n", encoding="utf-8")
    with pytest.raises(VocabularyError, match="cuont"):
        load_campaign(tmp_path / "run.yaml", {})
