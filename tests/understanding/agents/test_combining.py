"""Where reader and agents differ on what the text states: shown with the words, numbers win."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.errors import InfeasibleError
from scegen.scenario.files import from_data
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding import Standing, paper_cases, read, report_on
from scegen.understanding.agents import Kept
from scegen.understanding.agents.combining import combine


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
            "acts": {},
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
    assert len(chat_server.asked("participants")) == 2
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


def test_a_stated_speed_of_all_wins_for_all(differ):
    people = [{"id": f"bus_{k}", "kind": "bus", "role": "other" if k else "ego"} for k in range(3)]
    text = "Three buses at 36 km/h meet at a four-way intersection."
    result = differ(text, participants={"participants": people})
    assert [p.speed_mps.low for p in result.functional.participants] == pytest.approx([10] * 3)
    assert {d.kept for d in result.disagreements} == {Kept.READER}


def test_a_stated_speed_that_the_agents_give_to_others_is_not_taken_from_them(differ):
    text = "A car waits for a pedestrian who crosses, and who walks at 4 km/h, at an intersection."
    words = "at 4 km/h"
    people = [
        {"id": "car_1", "role": "ego"},
        {
            "id": "pedestrian_1",
            "kind": "pedestrian",
            "speed_mps": {"low": 1.111, "high": 1.111},
            "maneuvers": ["cross"],
        },
    ]
    stated = {"field": "participants.pedestrian_1.speed_mps", "words": words}
    result = differ(text, participants={"participants": people, "basis": [stated]})
    assert result.functional.participant("car_1").speed_mps is None
    assert result.functional.participant("pedestrian_1").speed_mps.low == pytest.approx(1.111)


def test_a_stated_speed_of_one_of_several_is_shown(differ):
    people = [{"id": f"bus_{k}", "kind": "bus", "role": "other" if k else "ego"} for k in range(3)]
    people[2]["speed_mps"] = {"low": 5, "high": 5}
    text = "Three buses meet at a four-way intersection. One bus drives at 36 km/h."
    item = only(differ(text, participants={"participants": people}))
    assert (item.reader, item.agents, item.kept) == ("10.0 m/s", "5.0 m/s", "agents")
    assert "not clear whose" in item.reason


def test_a_value_that_does_not_fit_is_shown_and_left(differ):
    # the agents send somebody in at arm 4, which the reader's T has not
    people = [{"id": "car_1", "role": "ego"}, {"id": "car_2", "entries": [3]}]
    result = differ("Two cars meet at a T-intersection.", participants={"participants": people})
    item = only(result)
    assert item.kept is Kept.AGENTS
    assert "does not fit" in item.reason
    assert result.functional.junction.arms == 4


def read_as(name, value):
    return {
        "junction": {"kind": "roundabout", "arms": 4},
        "unsupported": [{"words": name, "instead": value}],
    }


CONTRADICTORY = "Two cars meet at a roundabout with 1 exit."


def test_a_contradiction_wins_over_silence(differ, chat_server):
    with pytest.raises(InfeasibleError, match="without a word on it") as refused:
        differ(CONTRADICTORY, ("car", "car"), road=read_as("meet", "anything"))
    assert "1 exit" in refused.value.message
    # the agents were told, and had their chance
    assert len(chat_server.asked("road")) == 2
    assert "contradict itself" in str(chat_server.asked("road")[1]["messages"])


def test_a_contradiction_that_the_agents_resolve_is_shown(differ, chat_server):
    silent = {"junction": {"kind": "roundabout", "arms": 4}}
    told = read_as("1 exit", "read as one exit to take, of four")
    result = differ(CONTRADICTORY, ("car", "car"), road=[silent, told])
    item = only(result)
    assert item.kept is Kept.AGENTS
    assert "cannot have 1 exits" in item.reader
    assert item.agents == "read as one exit to take, of four"
    assert result.functional.junction.arms == 4
    report = report_on(result.functional, result.disagreements)
    assert {f.words for f in report.of(Standing.CONTRADICTED)} == {item.words}


def test_a_limit_of_the_reader_is_not_the_agents(differ):
    text = "Sixty-five cars meet at a four-way intersection."
    result = differ(text, ("car",) * 40)
    assert result.disagreements == ()
    assert any("more than" in note for note in result.notes)


def test_what_is_not_traffic_to_the_reader_is_noted(differ):
    result = differ("The cat sleeps on the sofa.", ("car", "car"))
    assert result.speaker == "openai:scripted"
    assert any("does not describe a traffic situation" in note for note in result.notes)


def person(name, kind="car", **more):
    return {"id": name, "kind": kind, **more}


def test_a_kind_of_the_same_words_gives_way(differ):
    people = {
        "participants": [person("car_1", role="ego"), person("two", "truck")],
        "basis": [{"field": "two.kind", "words": "a bus"}],
    }
    people["basis"][0]["field"] = "participants.two.kind"
    result = differ("A car and a bus meet at a four-way intersection.", participants=people)
    item = only(result)
    assert (item.field, item.reader, item.agents) == ("participants.two.kind", "bus", "truck")
    assert result.functional.participant("two").kind == "bus"
    (evidence,) = (e for e in result.functional.evidence if e.field == item.field)
    assert "read in two ways, by the agents as: truck" in evidence.reason


def test_somebody_missing_is_shown(differ):
    text = "A car and a bus meet at a four-way intersection."
    item = only(differ(text, ("car",)))
    assert (item.field, item.words, item.reader) == ("participants", "a bus", "1 bus")
    assert item.kept is Kept.AGENTS


def test_what_one_does_is_compared(differ):
    text = "A bus turns left at a four-way intersection while a car waits."
    people = [person("bus_9", "bus", role="ego", maneuvers=["right"]), person("car_9")]
    result = differ(text, participants={"participants": people})
    item = next(d for d in result.disagreements if d.field == "participants.bus_9.maneuvers")
    assert (item.words, item.reader, item.agents) == ("turns left", "left", "right")
    assert {str(m) for m in result.functional.participant("bus_9").maneuvers} == {"left"}


def test_what_the_agents_conclude_stands_unless_only_the_side_differs(differ):
    text = "The ego overtakes a truck."
    people = [person("ego", role="ego", maneuvers=["straight"]), person("truck_1", "truck")]
    result = differ(text, participants={"participants": people})
    told = [d for d in result.disagreements if d.field == "participants.ego.maneuvers"]
    assert [(d.reader, d.kept) for d in told] == [("overtake", Kept.AGENTS)]
    assert {str(m) for m in result.functional.ego.maneuvers} == {"straight"}


def test_where_one_comes_from_is_compared_only_with_the_same_ego(differ):
    text = "The ego car drives straight at a crossroads; a truck comes from the left."
    for ego, shown in (("car_1", True), ("truck_1", False)):
        people = [person("car_1"), person("truck_1", "truck", approaches=["right"])]
        for one in people:
            one["role"] = "ego" if one["id"] == ego else "other"
        result = differ(text, participants={"participants": people})
        fields = {d.field for d in result.disagreements}
        assert ("participants.truck_1.approaches" in fields) == shown
        assert ("participants.car_1.role" in fields) == (not shown)
        assert result.functional.ego.kind == "car"
        truck = next(p for p in result.functional.participants if p.kind == "truck")
        assert {str(a) for a in truck.approaches} == {"left"}


BRAKES = "A van brakes hard at a four-way intersection; a car is there too."


def test_a_danger_that_the_agents_do_not_name_is_shown_and_not_added(differ):
    people = [person("car_1", role="ego"), person("van_7", "van")]
    result = differ(BRAKES, participants={"participants": people})
    item = only(result)
    assert (item.field, item.agents, item.kept) == ("hazards.hard_braking", "not said", "agents")
    assert item.reader == "hard_braking by van_7"
    assert not result.functional.hazards


def test_another_reading_of_the_same_words_stands(differ):
    people = [person("car_1", role="ego"), person("van_7", "van")]
    hazards = {
        "hazards": [{"kind": "stopping", "by": ["van_7"]}],
        "basis": [{"field": "hazards.stopping", "words": "brakes hard"}],
    }
    result = differ(BRAKES, participants={"participants": people}, hazards=hazards)
    item = only(result)
    assert (item.field, item.agents, item.kept) == ("hazards.hard_braking", "stopping", "agents")
    assert [h.kind for h in result.functional.hazards] == ["stopping"]


def test_who_causes_a_danger_is_compared(differ):
    people = [person("car_1", role="ego"), person("van_7", "van")]
    hazards = {"hazards": [{"kind": "hard_braking", "by": ["car_1"], "to": ["van_7"]}]}
    result = differ(BRAKES, participants={"participants": people}, hazards=hazards)
    item = only(result)
    assert (item.reader, item.agents) == ("hard_braking by van_7", "hard_braking by car_1")
    assert item.kept is Kept.AGENTS
    assert result.functional.hazards[0].by == ("car_1",)


def interval(value):
    return {"low": value, "high": value}


def test_a_number_that_the_agents_give_to_something_else_stays_there(differ):
    text = "A van hits a parked car at 36 km/h; before, it had slowed down."
    assert any(p.speed_mps for p in read(text).participants), "the reader takes it for the speed"
    people = [person("van_1", "van", role="ego"), person("car_1", parked=True, maneuvers=["stay"])]
    act = {"id": "brake_1", "participant": "van_1", "kind": "brake"}
    acts = {
        "acts": [{**act, "target_speed_mps": interval(10.0)}],
        "outcome": {"kind": "collision", "between": ["van_1", "car_1"]},
        "basis": [{"field": "acts.brake_1.target_speed_mps", "words": "at 36 km/h"}],
    }
    road = {"junction": {"kind": "straight", "arms": 2}}
    result = differ(text, road=road, participants={"participants": people}, acts=acts)
    assert result.functional.participant("van_1").speed_mps is None
    assert result.functional.acts[0].target_speed_mps.low == pytest.approx(10.0)
    told = next(d for d in result.disagreements if d.field == "participants.van_1.speed_mps")
    assert (told.kept, told.reader) == (Kept.AGENTS, "10.0 m/s")
    assert "acts.brake_1.target_speed_mps" in told.reason


def test_a_number_for_which_the_agents_find_no_field_stays_out(differ):
    text = "A van hits a parked car at 36 km/h; before, it had slowed down."
    people = {
        "participants": [
            person("van_1", "van", role="ego"),
            person("car_1", parked=True, maneuvers=["stay"]),
        ],
        "unsupported": [{"words": "hits a parked car at 36 km/h", "instead": "a speed at impact"}],
    }
    road = {"junction": {"kind": "straight", "arms": 2}}
    result = differ(text, road=road, participants=people)
    assert result.functional.participant("van_1").speed_mps is None
    told = next(d for d in result.disagreements if d.field == "participants.van_1.speed_mps")
    assert "a speed at impact" in told.reason


def test_whose_maneuver_it_is_the_agents_know_better(differ):
    text = "A bus turns left at a four-way intersection while a car waits."
    assert {str(m) for p in read(text).participants if p.kind == "bus" for m in p.maneuvers} == {
        "left"
    }
    people = {
        "participants": [person("bus_1", "bus", role="ego"), person("car_1", maneuvers=["left"])],
        "basis": [{"field": "participants.car_1.maneuvers", "words": "turns left"}],
    }
    result = differ(text, participants=people)
    assert not result.functional.participant("bus_1").maneuvers
    told = next(d for d in result.disagreements if d.field == "participants.bus_1.maneuvers")
    assert (told.kept, told.reader) == (Kept.AGENTS, "left")
    assert "participants.car_1.maneuvers" in told.reason


def test_disagreements_are_contradictions_of_the_parse_report(differ):
    result = differ("Two cars meet at a T-intersection.", ("car", "car"))
    (finding,) = report_on(result.functional, result.disagreements).of(Standing.CONTRADICTED)
    assert (finding.field, finding.words) == ("junction.kind", "T-intersection")
    assert finding.value == "t"
    assert "four_way" in finding.reason
    assert "reader" in finding.reason


SENTENCES = st.sampled_from([case.text for case in paper_cases()] + [BRAKES])


@given(SENTENCES, SENTENCES)
def test_any_two_readings_combine(one, other):
    theirs = read(one)
    ours = read(other).model_copy(update={"description": one, "evidence": (), "unsupported": ()})
    combined, disagreements = combine(ours, theirs)
    data = combined.model_dump(mode="json")
    assert from_data(FunctionalScenario, data, where="x") == combined
    assert all(one[d.start : d.end] == d.words for d in disagreements)
    fields = [e.field for e in combined.evidence]
    assert len(fields) == len(set(fields))


@given(SENTENCES)
def test_a_reading_agrees_with_itself(text):
    scenario = read(text)
    assert combine(scenario, scenario) == (scenario, [])
