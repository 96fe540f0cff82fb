"""A scripted model that answers well: what comes out, in which order it is asked, how often."""

import asyncio
import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

from scegen.scenario.evidence import EvidenceSource
from scegen.scenario.files import from_data
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.glossary import meaning_of
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.vocabulary import HazardKind, JunctionKind, Maneuver


def evidence(understanding, field):
    found = [e for e in understanding.functional.evidence if e.field == field]
    assert len(found) == 1, field
    return found[0]


def test_the_answers_become_a_scenario(understood, good_answers):
    result = understood(good_answers)
    scenario = result.functional
    assert result.speaker == "openai:scripted"
    assert not result.fell_back
    assert result.faults == ()
    assert scenario.junction.kind is JunctionKind.T
    assert [p.id for p in scenario.participants] == ["car_1", "car_2", "car_3", "truck_1"]
    kinds = [h.kind for h in scenario.hazards]
    assert kinds == [HazardKind.SPEEDING, HazardKind.UNPROTECTED_LEFT_TURN]
    # valid by the types of the contract, not by luck
    assert from_data(FunctionalScenario, scenario.model_dump(mode="json"), where="x") == scenario


def test_quotes_are_looked_up_in_the_text(understood, good_answers, story):
    result = understood(good_answers)
    kind = evidence(result, "junction.kind")
    assert kind.source is EvidenceSource.STATED
    assert story[kind.start : kind.end] == "T-intersection"
    speeding = evidence(result, "hazards.speeding")
    assert speeding.text == "speeds at 72 km/h"  # as the text has it, not as the model wrote it
    assert story[speeding.start : speeding.end] == speeding.text


def test_every_filled_field_has_a_ground(understood, good_answers):
    fields = {e.field for e in understood(good_answers).functional.evidence}
    assert {
        "junction.kind",
        "junction.arms",
        "junction.control",
        "participants.car_1.kind",
        "participants.car_1.speed_mps",
        "participants.car_2.role",
        "participants.truck_1.maneuvers",
        "hazards.speeding",
        "environment.weather",
    } <= fields


def test_an_invented_quote_is_downgraded(understood, good_answers):
    # away from what the reader states, which would come in its place
    good_answers["road"]["environment"]["visibility"] = "poor"
    good_answers["road"]["basis"] += [{"field": "visibility", "words": "thick fog everywhere"}]
    result = understood(good_answers)
    item = evidence(result, "environment.visibility")
    assert item.source is EvidenceSource.INFERRED
    assert "thick fog everywhere" in item.reason
    assert any("thick fog everywhere" in note for note in result.notes)


def test_unsupported_words_keep_their_place(understood, good_answers, story):
    (phrase,) = understood(good_answers).functional.unsupported
    assert story[phrase.start : phrase.end] == phrase.text == "in front of it"


def test_independent_agents_are_asked_at_the_same_time(understood, good_answers, chat_server):
    chat_server.meeting = threading.Barrier(2, timeout=60)
    assert understood(good_answers).speaker == "openai:scripted"
    order = [agent for agent, _, _ in chat_server.requests]
    assert set(order[:2]) == {"road", "participants"}
    assert set(order[2:4]) == {"hazards", "acts"}
    assert order[4:] == ["reviewer"]


def test_tokens_are_counted(understood, good_answers):
    usage = understood(good_answers).usage
    assert (usage.requests, usage.retries) == (5, 0)
    assert (usage.input_tokens, usage.output_tokens) == (500, 100)


@pytest.mark.parametrize(
    ("models", "cost"), [("ollama:anything", 0.0), ("openai:gpt-4o-mini", 0.000135)]
)
def test_cost_by_list_price(understood, good_answers, models, cost):
    # gpt-4o-mini: 0.15 and 0.60 dollars for a million tokens in and out
    assert understood(good_answers, models=models).usage.to_data()["cost_usd"] == cost


def test_an_unknown_price_is_not_called_nothing(understood, good_answers):
    assert understood(good_answers).usage.to_data()["cost_usd"] is None


def test_wrong_answers_go_back_with_the_reason(understood, good_answers, chat_server):
    wrong = {"junction": {"kind": "hexagon", "arms": 3}}
    good_answers["road"] = [wrong, good_answers["road"]]
    result = understood(good_answers)
    assert result.speaker == "openai:scripted"
    again = chat_server.asked("road")
    assert len(again) == 2
    assert "hexagon" in str(again[1]["messages"])
    assert "four_way" in str(again[1]["messages"][2:])  # what the vocabulary offers instead


def test_a_danger_by_nobody_we_know_goes_back(understood, good_answers, chat_server):
    wrong = {"hazards": [{"kind": "speeding", "by": ["car_9"]}]}
    good_answers["hazards"] = [wrong, good_answers["hazards"]]
    assert understood(good_answers).speaker == "openai:scripted"
    assert "car_9" in str(chat_server.asked("hazards")[1]["messages"][2:])


def test_the_reviewer_sends_a_part_back(understood, good_answers, chat_server):
    objection = {
        "about": "hazards",
        "problem": "the lorry is the victim, not the cause",
        "words": "a lorry turns left",
    }
    right = good_answers["hazards"]
    wrong = {"hazards": [{"kind": "speeding", "by": ["truck_1"]}]}
    good_answers["hazards"] = [wrong, right]
    good_answers["reviewer"] = [{"objections": [objection]}, {"objections": []}]
    result = understood(good_answers)
    assert result.functional.hazards[0].by == ("car_1",)
    assert [o.problem for o in result.objections] == [objection["problem"]]
    assert objection["problem"] in str(chat_server.asked("hazards")[1]["messages"])
    assert [len(chat_server.asked(a)) for a in ("road", "participants", "reviewer")] == [1, 1, 2]


def test_a_reviewer_who_is_never_content_ends(understood, good_answers, chat_server):
    objection = {"about": "road", "problem": "no", "words": "T-intersection"}
    good_answers["reviewer"] = {"objections": [objection]}
    result = understood(good_answers)
    assert result.speaker == "openai:scripted"
    assert len(chat_server.asked("reviewer")) == 2
    assert len(chat_server.asked("road")) == 3


def test_objections_to_words_that_are_not_there_are_ignored(understood, good_answers, chat_server):
    objection = {"about": "road", "problem": "it is a roundabout", "words": "the roundabout"}
    good_answers["reviewer"] = {"objections": [objection]}
    assert understood(good_answers).objections == ()
    assert len(chat_server.asked("road")) == 1


def test_new_participants_mean_new_dangers_and_acts(understood, good_answers, chat_server):
    objection = {"about": "participants", "problem": "the lorry is a truck", "words": "a lorry"}
    good_answers["reviewer"] = [{"objections": [objection]}, {"objections": []}]
    right = good_answers["participants"]
    wrong = {**right, "participants": [{**p, "parked": False} for p in right["participants"]]}
    wrong["participants"][3]["kind"] = "bus"
    good_answers["participants"] = [wrong, right]
    understood(good_answers)
    asked = [len(chat_server.asked(name)) for name in ("participants", "hazards", "acts", "road")]
    assert asked == [2, 2, 2, 1]
    assert "are others now" in str(chat_server.asked("acts")[1]["messages"])


def test_an_answer_that_stays_the_same_changes_nothing_for_others(
    understood, good_answers, chat_server
):
    objection = {"about": "participants", "problem": "the lorry is a van", "words": "a lorry"}
    good_answers["reviewer"] = [{"objections": [objection]}, {"objections": []}]
    understood(good_answers)
    assert [len(chat_server.asked(name)) for name in ("participants", "hazards")] == [2, 1]


def test_what_happens_is_asked_of_those_who_see_the_stage(understood, good_answers, chat_server):
    understood(good_answers)
    for name in ("hazards", "acts"):
        question = str(chat_server.asked(name)[0]["messages"])
        assert '\\"kind\\":\\"t\\"' in question or '"kind":"t"' in question
        assert "truck_1" in question


def test_the_reviewer_sees_what_fields_rest_on_and_what_words_mean(
    understood, good_answers, chat_server
):
    understood(good_answers)
    question = str(chat_server.asked("reviewer")[0]["messages"])
    assert "T-intersection" in question.split("What its fields rest on")[1]
    assert meaning_of(HazardKind.SPEEDING).text in question
    assert meaning_of(Maneuver.LEFT).text in question


ACTS = {
    "acts": [
        {
            "id": "turn_1",
            "participant": "truck_1",
            "kind": "turn",
            "side": "left",
            "when": {
                "type": "measure",
                "measure": "gap_m",
                "participant": "car_1",
                "reference": "truck_1",
                "value": 30,
            },
        }
    ],
    "spacings": [
        {
            "participant": "car_1",
            "reference": "truck_1",
            "measure": "gap_m",
            "value": {"low": 30, "high": 30},
            "at": "turn_1",
        }
    ],
    "outcome": {"kind": "near_miss", "between": ["car_1", "truck_1"]},
    "basis": [
        {"field": "acts[0].side", "words": "turns left"},
        {"field": "turn_1", "words": "turns left in front of it"},
        {"field": "spacings[0]", "words": "in front of it"},
    ],
}


def test_acts_spacings_and_outcome_become_part_of_it(understood, good_answers):
    good_answers["acts"] = ACTS
    result = understood(good_answers)
    scenario = result.functional
    assert scenario.acts[0].when.value.exact
    assert scenario.spacings[0].at == "turn_1"
    assert scenario.outcome.kind is OutcomeKind.NEAR_MISS
    assert evidence(result, "acts.turn_1.side").text == "turns left"
    assert evidence(result, "acts.turn_1.kind").text == "turns left in front of it"
    assert evidence(result, "spacings.0").text == "in front of it"
    assert evidence(result, "outcome.kind").source is EvidenceSource.INFERRED


def test_acts_by_nobody_we_know_go_back(understood, good_answers, chat_server):
    wrong = {"acts": [{**ACTS["acts"][0], "participant": "ego"}]}
    good_answers["acts"] = [wrong, ACTS]
    assert understood(good_answers).speaker == "openai:scripted"
    told = str(chat_server.asked("acts")[1]["messages"][2:])
    assert "acts.turn_1 names the unknown participant" in told
    assert "car_1, car_2, car_3, truck_1" in told


def test_objects_are_named_like_participants(understood, good_answers):
    good_answers["participants"]["objects"] = [
        {"id": "hedge_1", "kind": "hedge", "hides": ["truck_1"], "called": "hedge"}
    ]
    good_answers["hazards"]["hazards"].append(
        {"kind": "occlusion", "by": ["hedge_1"], "to": ["car_1"]}
    )
    result = understood(good_answers)
    assert result.functional.objects[0].hides == ("truck_1",)
    assert evidence(result, "objects.hedge_1.hides").source is EvidenceSource.INFERRED


def test_a_failing_reviewer_costs_nothing_but_the_review(understood, good_answers, chat_server):
    good_answers["reviewer"] = chat_server.kinds["Status"](400)
    result = understood(good_answers)
    assert result.speaker == "openai:scripted"
    assert [(f.agent, f.kind) for f in result.faults] == [("reviewer", "rejected")]


def test_parts_that_do_not_fit_together_go_back(understood, good_answers, chat_server):
    fitting = good_answers["participants"]
    outside = {
        "participants": [{**p, "entries": [7]} for p in fitting["participants"]],
    }
    good_answers["participants"] = [outside, fitting]
    result = understood(good_answers)
    assert result.speaker == "openai:scripted"
    assert any("outside 0..2" in o.problem for o in result.objections)
    assert len(chat_server.asked("reviewer")) == 1


def test_it_runs_inside_a_running_loop(understood, good_answers):
    """In a thread of its own: a browser that other tests drive holds the loop of this one."""

    async def notebook():
        return understood(good_answers)

    with ThreadPoolExecutor(1) as pool:
        result = pool.submit(asyncio.run, notebook()).result()
    assert result.speaker == "openai:scripted"
