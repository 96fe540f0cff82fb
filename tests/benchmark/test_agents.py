"""The benchmark of language models: their score, their price, their steadiness, their faults."""

import json
import socket

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.benchmark.agents import AgentReader, quantile
from scegen.benchmark.stability import Stability, facts
from scegen.benchmark.understand import run
from scegen.errors import InputError
from scegen.llm import Budget, LlmSettings, parse_models
from scegen.llm.settings import Limits
from scegen.understanding import Case, paper_cases, read
from scegen.understanding.agents import READER

KEY = "sk-secret-0123456789"
KEYS = {"OPENAI_API_KEY": KEY}
EXPECT = {
    "junction": ["t"],
    "actors": {"car": [3, 3], "truck": [1, 1]},
    "hazards": {"must": ["speeding"], "may": ["unprotected_left_turn"]},
}


@pytest.fixture
def cases(story):
    """One description told by so many names."""

    def make(count):
        return [Case(f"story {k}", story, EXPECT) for k in range(count)]

    return make


@pytest.fixture
def reader_for(chat_server):
    def make(answers, models="openai:gpt-4o-mini", **changes):
        chat_server.answers = answers
        patient = Limits(request_s=60, run_s=300, attempts=2, first_wait_s=0.01)
        names = parse_models(models, url=chat_server.url)
        return AgentReader(LlmSettings(names, chat_server.url, limits=patient, **changes), KEYS)

    return make


def test_agents_are_scored_by_the_same_rule(cases, reader_for, good_answers):
    reader = reader_for(good_answers)
    result = run(cases(2), reader)
    assert (result.cases, result.readings, result.understood) == (2, 2, 2)
    assert result.kinds["car"].right == 6
    data = reader.measured.to_data(result)
    assert data["speakers"] == {"openai:gpt-4o-mini": {"readings": 2, "understood": 2}}
    assert (data["requests"], data["input_tokens"], data["output_tokens"]) == (10, 1000, 200)
    # 0.15 and 0.60 dollars for a million tokens in and out
    assert data["cost_usd"] == pytest.approx(0.00027)
    assert data["tokens_per_reading"] == 600
    assert 0 < data["latency_s"]["median"] <= data["latency_s"]["p95"]
    assert data["faults"] == {}


def test_a_model_that_is_wrong_fails(cases, reader_for, good_answers):
    good_answers["participants"]["participants"].append({"id": "bus_1", "kind": "bus"})
    result = run(cases(1), reader_for(good_answers))
    assert result.understood == 0
    assert result.kinds["bus"].wrong == 1
    assert "unexpected bus" in result.failures[0].problems[0]


def test_models_that_waver_are_unstable(cases, reader_for, good_answers):
    steady = good_answers["road"]
    foggy = {**steady, "environment": {"weather": "rain", "visibility": "poor"}}
    good_answers["road"] = [steady, steady, foggy, steady]
    good_answers["hazards"] = [good_answers["hazards"]] * 3 + [
        {"hazards": [{"kind": "swerving", "by": ["car_3"]}]}
    ]
    result = run(cases(3), reader_for(good_answers), repeat=2)
    assert result.readings == 6
    # told of the first description nothing differs; of the second the fog and then the dangers
    whole = result.stability.whole
    assert (whole.cases, whole.identical) == (3, 2)
    assert result.stability.fields["environment"].identical == 2
    assert result.stability.fields["junction"].identical == 3
    assert result.stability.fields["hazards"].identical == 2
    assert result.stability.fields["hazards"].equally_judged == 2
    assert [f.runs for f in result.failures] == [(2,), (1, 2)]


def test_a_provider_that_breaks_loses_nothing_scored(cases, reader_for, good_answers, chat_server):
    good = good_answers["participants"]
    good_answers["participants"] = [good, good, chat_server.kinds["Status"](401, "expired")]
    reader = reader_for(good_answers)
    result = run(cases(10), reader)
    speakers = reader.measured.by_speaker(result)
    assert speakers == {"openai:gpt-4o-mini": (2, 2), READER: (3, 3)}
    assert (result.readings, result.left) == (5, 5)
    assert "expired" in result.stopped
    assert not result.perfect
    assert reader.measured.faults == {"authentication": 3}


def test_a_provider_that_comes_back_is_asked_on(cases, reader_for, good_answers, chat_server):
    good = good_answers["participants"]
    good_answers["participants"] = [chat_server.kinds["Status"](401), good]
    result = run(cases(4), reader_for(good_answers))
    assert result.stopped is None
    assert result.readings == 4


def test_the_budget_is_for_all_descriptions(cases, reader_for, good_answers):
    reader = reader_for(good_answers, budget=Budget(tokens=20_000))
    result = run(cases(40), reader)
    assert 0 < result.readings < 40
    assert "budget" in result.stopped
    assert reader.measured.usage.tokens <= 20_000
    # what nobody but the offline reader read is not scored as the agents'
    assert set(reader.measured.by_speaker(result)) == {"openai:gpt-4o-mini"}


def test_an_interrupt_keeps_the_scores(cases):
    def impatient(case, _):
        if case.id == "story 2":
            raise KeyboardInterrupt
        return read(case.text)

    result = run(cases(5), impatient)
    assert (result.readings, result.stopped, result.left) == (2, "interrupted", 3)


def test_a_refused_text_is_a_wrong_answer_that_costs(reader_for, good_answers):
    good_answers["participants"] = {"participants": [], "not_traffic": "it is a recipe"}
    reader = reader_for(good_answers)
    result = run([Case("cake", "Whisk three eggs with sugar.", EXPECT)], reader)
    assert (result.readings, result.understood) == (1, 0)
    assert reader.measured.usage.requests > 0


def test_a_replay_gives_the_same_result_without_network(
    cases, reader_for, good_answers, chat_server, tmp_path, monkeypatch
):
    dry = {**good_answers["road"], "environment": {}}
    good = good_answers["road"]
    good_answers["road"] = [good, dry, good, chat_server.kinds["Status"](401)]
    reader = reader_for(good_answers, record=tmp_path / "talk")
    result = run(cases(2), reader, repeat=2)
    chat_server.stop()
    monkeypatch.setattr(socket.socket, "connect", None)
    replayer = AgentReader(LlmSettings((), replay=tmp_path / "talk"), {})
    again = run(cases(2), replayer, repeat=2)
    first, second = (
        json.dumps(r.to_data() | m.measured.to_data(r))
        for r, m in ((result, reader), (again, replayer))
    )
    assert first == second
    assert "authentication" in first
    written = [p for p in (tmp_path / "talk").rglob("*") if p.is_file()]
    assert {p.parent.name for p in written} == {"1", "2"}
    assert all(KEY.encode() not in p.read_bytes() for p in written)


def test_a_recording_that_ends_early_loses_nothing(cases, reader_for, good_answers, tmp_path):
    run(cases(2), reader_for(good_answers, record=tmp_path / "talk"))
    result = run(cases(3), AgentReader(LlmSettings((), replay=tmp_path / "talk"), {}))
    assert (result.readings, result.left) == (2, 1)
    assert "run.json" in result.stopped


def test_nothing_is_asked_where_the_recording_cannot_go(reader_for, chat_server, tmp_path):
    (tmp_path / "thesis.txt").write_text("years of work")
    with pytest.raises(InputError, match="is not empty"):
        reader_for({}, record=tmp_path)


def test_a_missing_key_is_an_error_and_no_score(cases, chat_server):
    reader = AgentReader(LlmSettings(parse_models("deepseek:deepseek-chat")), {})
    with pytest.raises(InputError, match="DEEPSEEK_API_KEY"):
        run(cases(2), reader)


@given(st.lists(st.floats(0, 100), min_size=1), st.floats(0.01, 1))
def test_a_quantile_is_the_smallest_value_that_covers_the_share(values, share):
    found = quantile(values, share)
    assert found in values
    assert sum(v <= found for v in values) >= share * len(values) - 1e-9
    assert sum(v < found for v in values) < share * len(values)


def test_no_quantile_of_nothing():
    assert quantile([], 0.5) is None


@given(st.sampled_from(paper_cases()), st.randoms(use_true_random=False))
def test_names_and_their_order_do_not_matter_to_stability(case, rng):
    scenario = read(case.text)
    people = list(scenario.participants)
    rng.shuffle(people)
    names = {p.id: f"x{k}" for k, p in enumerate(people)}
    renamed = scenario.model_copy(
        update={
            "participants": tuple(p.model_copy(update={"id": names[p.id]}) for p in people),
            "relations": tuple(
                r.model_copy(
                    update={
                        "participant": names[r.participant],
                        "reference": names[r.reference],
                    }
                )
                for r in scenario.relations
            ),
            "hazards": tuple(
                h.model_copy(
                    update={
                        "by": tuple(names[n] for n in h.by),
                        "to": tuple(names[n] for n in h.to),
                    }
                )
                for h in scenario.hazards
            ),
        }
    )
    assert facts(renamed) == facts(scenario)


def test_the_offline_reader_is_stable():
    result = run(paper_cases(), repeat=3)
    assert (result.cases, result.readings) == (11, 33)
    for one in (result.stability.whole, *result.stability.fields.values()):
        assert one.identical == one.cases == 11
        assert one.equally_judged == one.judged


def test_unequal_readings_are_told_apart():
    stability = Stability(runs=2)
    one, other = facts(read("A van turns left.")), facts(read("A bus turns left."))
    stability.add([(one, {"actors": True}), (other, {"actors": True})])
    stability.add([(one, {"actors": True}), ({}, {"actors": False})])
    stability.add([(one, {"actors": True})])  # was interrupted
    data = stability.to_data()
    assert (data["cases"], data["identical"], data["equally_judged"]) == (2, 0, 1)
    assert data["fields"]["junction"]["identical"] == 1
    assert Stability(runs=1).to_data() is None
