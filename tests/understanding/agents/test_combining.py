"""Where reader and agents differ on what the text states: shown with the words, numbers win."""

import pytest

from scegen.understanding import read
from scegen.understanding.agents import Kept


@pytest.fixture
def differ(understood, good_answers):
    """Understands a text that the reader reads rightly, with parts answered otherwise."""

    def run(text, people=("car",), **answers):
        listed = [
            {"id": f"{kind}_{k}", "kind": kind, "role": "other" if k else "ego"}
            for k, kind in enumerate(people)
        ]
        answers = {
            "road": {"junction": {"kind": "four_way", "arms": 4}},
            "participants": {"participants": listed},
            "hazards": {"hazards": []},
            "environment": {"environment": {}},
            "reviewer": {"objections": []},
            **answers,
        }
        return understood(answers, text)

    return run


def only(result):
    (item,) = result.disagreements
    text = result.functional.description
    assert text[item.start : item.end] == item.words
    return item


def test_agreement_is_silent(differ):
    result = differ("Two cars meet at a four-way intersection.", ("car", "car"))
    assert result.disagreements == ()


def test_a_stated_number_of_arms_wins(differ):
    road = {
        "junction": {"kind": "roundabout", "arms": 4},
        "basis": [{"field": "arms", "words": "five exits"}],
    }
    result = differ("Two cars meet at a roundabout with five exits.", ("car", "car"), road=road)
    item = only(result)
    assert (item.field, item.reader, item.agents) == ("junction.arms", "5", "4")
    assert item.kept is Kept.READER
    assert "five exits" in item.words
    assert result.functional.junction.arms == 5


def test_a_stated_speed_limit_wins(differ):
    road = {"junction": {"kind": "four_way", "arms": 4, "speed_limit_mps": 30.0}}
    text = "Two cars meet at a four-way intersection. The speed limit is 36 km/h."
    result = differ(text, ("car", "car"), road=road)
    assert only(result).kept is Kept.READER
    assert result.functional.junction.speed_limit_mps == pytest.approx(10.0)


def test_a_rounded_number_is_no_disagreement(differ):
    road = {"junction": {"kind": "four_way", "arms": 4, "speed_limit_mps": 13.9}}
    text = "Two cars meet at a four-way intersection. The speed limit is 50 km/h."
    result = differ(text, ("car", "car"), road=road)
    assert result.disagreements == ()
    assert result.functional.junction.speed_limit_mps == pytest.approx(50 / 3.6)


Y_ROAD = {"kind": "y", "arms": 3}


def test_a_junction_that_rests_on_other_words_stands(differ):
    road = {
        "junction": Y_ROAD,
        "basis": [{"field": "junction.kind", "words": "a T-intersection that forks"}],
    }
    text = "Two cars meet at a T-intersection that forks like a tuning fork."
    result = differ(text, ("car", "car"), road=road)
    item = only(result)
    assert (item.field, item.reader, item.agents) == ("junction.kind", "t", "y")
    assert item.kept is Kept.AGENTS
    assert result.functional.junction.kind == "y"


def test_a_junction_that_rests_on_the_same_words_gives_way(differ):
    road = {
        "junction": Y_ROAD,
        "basis": [{"field": "junction.kind", "words": "T-intersection"}],
    }
    result = differ("Two cars meet at a T-intersection.", ("car", "car"), road=road)
    item = only(result)
    assert (item.agents, item.kept) == ("y", "reader")
    assert result.functional.junction.kind == "t"


def test_an_unquoted_junction_gives_way(differ):
    result = differ("Two cars meet at a T-intersection.", ("car", "car"))
    item = only(result)
    assert (item.reader, item.agents, item.kept) == ("t", "four_way", "reader")
    assert (result.functional.junction.kind, result.functional.junction.arms) == ("t", 3)
    fields = [e.field for e in result.functional.evidence]
    assert len(fields) == len(set(fields))


def test_a_stated_count_is_asked_for_again_and_then_wins(differ, chat_server):
    text = "Three cars meet at a four-way intersection."
    result = differ(text, ("car", "car"))
    assert len(chat_server.asked("participants")) == 3
    assert "Three cars" in str(chat_server.asked("participants")[1]["messages"])
    item = only(result)
    assert (item.reader, item.agents, item.kept) == ("3 car", "2 car", "reader")
    assert result.functional.participants == read(text).participants


def test_a_count_that_the_agents_correct_is_settled(differ, chat_server):
    two = [{"id": "car_0", "role": "ego"}, {"id": "car_1"}]
    answers = [{"participants": two}, {"participants": [*two, {"id": "car_2"}]}]
    text = "Three cars meet at a four-way intersection."
    result = differ(text, participants=answers)
    assert result.disagreements == ()
    assert [p.id for p in result.functional.participants] == ["car_0", "car_1", "car_2"]


def test_more_than_the_text_counts_may_be_right(differ):
    text = "Three cars meet at a four-way intersection."
    assert differ(text, ("car", "car", "car", "car")).disagreements == ()


def test_a_stated_speed_wins(differ):
    people = [
        {"id": "car_1", "role": "ego"},
        {"id": "truck_1", "kind": "truck", "speed_mps": {"low": 40.0, "high": 40.0}},
    ]
    text = "A car and a lorry meet at a four-way intersection. The lorry drives at 36 km/h."
    assert any(p.speed_mps for p in read(text).participants), "the reader states the speed"
    result = differ(text, participants={"participants": people})
    item = only(result)
    assert item.field == "participants.truck_1.speed_mps"
    assert (item.reader, item.agents) == ("10.0 m/s", "40.0 m/s")
    assert result.functional.participant("truck_1").speed_mps.low == pytest.approx(10.0)


def test_a_value_that_does_not_fit_is_shown_and_left(differ):
    # the agents send somebody in at arm 4, which the reader's T has not
    people = [{"id": "car_1", "role": "ego"}, {"id": "car_2", "entries": [3]}]
    result = differ("Two cars meet at a T-intersection.", participants={"participants": people})
    item = only(result)
    assert item.kept is Kept.AGENTS
    assert "does not fit" in item.reason
    assert result.functional.junction.arms == 4


def test_what_the_reader_refuses_is_noted(differ):
    result = differ("Two cars meet at a roundabout with 1 exit.", ("car", "car"))
    assert result.speaker == "openai:scripted"
    assert any("1 exit" in note for note in result.notes)
