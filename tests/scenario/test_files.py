"""Files come back as they went, and broken ones are refused with the place."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.errors import InputError, VocabularyError
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import from_data, json_schema, load, load_any, to_json, to_yaml
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.logical import LogicalSet
from scegen.scenario.parsing import parse
from scegen.scenario.vocabulary import Approach, Maneuver

participants = st.builds(
    Participant,
    id=st.from_regex(r"\A[a-z][a-z0-9_]{0,8}\Z"),
    approaches=st.frozensets(st.sampled_from(Approach)),
    maneuvers=st.frozensets(st.sampled_from(Maneuver)),
    entries=st.frozensets(st.integers(0, 3)),
)
scenarios = st.builds(
    lambda text, others: FunctionalScenario(
        description=text,
        junction=Junction(kind="four_way", arms=4),
        participants=(Participant(id="ego", role="ego"), *others),
    ),
    st.text(max_size=60),
    st.lists(participants.filter(lambda p: p.id != "ego"), max_size=3, unique_by=lambda p: p.id),
)


@given(scenarios)
def test_yaml_and_json_bring_back_the_same(scenario):
    for text in (to_yaml(scenario), to_json(scenario)):
        again = from_data(FunctionalScenario, parse(text, where="test"), where="test")
        assert again == scenario


@given(scenarios)
def test_the_same_scenario_gives_the_same_bytes(scenario):
    again = FunctionalScenario.model_validate_json(scenario.model_dump_json())
    assert to_yaml(again) == to_yaml(scenario)
    assert to_json(again) == to_json(scenario)


@pytest.mark.parametrize("count", [0, 1, 3])
def test_logical_sets_have_a_line_for_each_scenario(count):
    one = {
        "slug": "ego-right",
        "pattern": (1,),
        "assignments": [
            {"participant": "ego", "entry": 0, "move": 1, "exit": 1, "turn": "right",
             "maneuver": "right"}
        ],
    }  # fmt: skip
    made = LogicalSet(
        functional=FunctionalScenario(
            description="A car turns right.",
            junction=Junction(kind="four_way", arms=4),
            participants=(Participant(id="ego", role="ego"),),
        ),
        reduction="none",
        arms="distinct",
        certificate={"total": count, "count": count, "complete": True, "method": "test"},
        scenarios=[one | {"index": i} for i in range(count)],
    )
    text = to_json(made)
    assert from_data(LogicalSet, json.loads(text), where="test") == made
    assert sum('"slug"' in line for line in text.splitlines()) == count


def test_sets_are_written_in_the_order_of_the_vocabulary():
    someone = Participant(id="ego", maneuvers={"left", "straight", "right"}, entries={3, 1})
    data = someone.model_dump(mode="json")
    assert data["maneuvers"] == ["straight", "left", "right"]
    assert data["entries"] == [1, 3]


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("level: functional\njunction: [", "not valid YAML"),
        ("level: martian\n", "its level is"),
        ("- 1\n- 2\n", "its level is"),
        ("level: functional\ndescription: x\n", "junction: is missing"),
        (
            "level: functional\ndescription: x\njunction: {kind: hexagon, arms: 6}\n"
            "participants: [{id: ego, role: ego}]\n",
            "junction.kind: 'hexagon' is not one of the words allowed: straight",
        ),
        ("[" * 5000, "nested too deeply|not valid"),
    ],
)
def test_broken_files_are_refused_with_the_place(tmp_path, content, words):
    path = tmp_path / "broken.yaml"
    path.write_text(content)
    with pytest.raises(VocabularyError, match=words) as caught:
        load_any(path)
    assert str(path) in str(caught.value)


def test_a_file_of_another_level_is_named(tmp_path):
    path = tmp_path / "functional.json"
    path.write_text(json.dumps({"level": "functional"}))
    with pytest.raises(VocabularyError, match="is a functional file, not a logical scenario"):
        load(path, LogicalSet)


def test_unreadable_files_are_named(tmp_path):
    with pytest.raises(InputError, match="No such file"):
        load(tmp_path / "nowhere.yaml", ConcreteScenario)
    (tmp_path / "latin.yaml").write_bytes(b"level: \xff\xfe")
    with pytest.raises(InputError, match="UTF-8"):
        load(tmp_path / "latin.yaml", ConcreteScenario)


def test_every_level_has_a_schema():
    for level in ("functional", "logical", "concrete"):
        schema = json_schema(level)
        assert schema["properties"]["level"]["const"] == level
    with pytest.raises(VocabularyError, match="unknown level"):
        json_schema("metaphysical")
