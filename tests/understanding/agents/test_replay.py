"""A recorded run, repeated without network: the same result, byte for byte."""

import json
import socket

import pytest

from scegen.errors import InputError
from scegen.llm import Budget, LlmSettings
from scegen.llm.settings import Limits
from scegen.scenario.files import to_yaml
from scegen.understanding.agents import understand


def bytes_of(understanding):
    return to_yaml(understanding.functional) + json.dumps(understanding.to_data())


@pytest.fixture
def no_network(monkeypatch):
    def refuse(*_):
        raise AssertionError("a replay opened a connection")

    monkeypatch.setattr(socket.socket, "connect", refuse)
    monkeypatch.setattr(socket.socket, "connect_ex", refuse)


@pytest.fixture
def scripts(good_answers, chat_server):
    status, drip = chat_server.kinds["Status"], chat_server.kinds["Drip"]
    objection = {"about": "road", "problem": "no", "words": "T-intersection"}
    busy = status(429, "busy", (("Retry-After", "0"),))
    return {
        "good": good_answers,
        "corrected": {**good_answers, "road": [{"junction": 5}, good_answers["road"]]},
        "reviewed": {**good_answers, "reviewer": {"objections": [objection]}},
        "retried": {**good_answers, "road": [busy, good_answers["road"]]},
        "refused": {"*": status(401)},
        "slow": {**good_answers, "participants": drip()},
        "other number": {
            **good_answers,
            "participants": {"participants": [{"id": "car_1", "role": "ego"}]},
        },
    }


SCRIPTS = ("good", "corrected", "reviewed", "retried", "refused", "slow", "other number")


@pytest.mark.parametrize("name", SCRIPTS)
def test_a_replay_gives_the_same_bytes(
    tmp_path, understood, scripts, story, chat_server, request, name
):
    limits = {"limits": Limits(request_s=2, attempts=1)} if name == "slow" else {}
    recorded = understood(scripts[name], record=tmp_path / "t", **limits)
    asked = len(chat_server.requests)
    chat_server.stop()
    request.getfixturevalue("no_network")
    replayed = understand(story, LlmSettings(models=(), replay=tmp_path / "t"), environment={})
    assert bytes_of(replayed) == bytes_of(recorded)
    assert len(chat_server.requests) == asked


def test_a_replay_of_a_chain(tmp_path, understood, good_answers, chat_server, story):
    good_answers["road"] = [chat_server.kinds["Status"](404), good_answers["road"]]
    models = "openai:gone,deepseek:there"
    recorded = understood(good_answers, models=models, record=tmp_path / "t")
    replayed = understand(story, LlmSettings(models=(), replay=tmp_path / "t"), environment={})
    assert recorded.speaker == "deepseek:there"
    assert bytes_of(replayed) == bytes_of(recorded)


def test_a_run_over_budget_is_repeated_as_it_was(tmp_path, understood, good_answers, story):
    recorded = understood(good_answers, record=tmp_path / "t", budget=Budget(tokens=14_000))
    replayed = understand(story, LlmSettings(models=(), replay=tmp_path / "t"), environment={})
    assert recorded.fell_back
    assert bytes_of(replayed) == bytes_of(recorded)


def test_transcripts_hold_the_conversation_and_no_key(
    tmp_path, understood, good_answers, chat_server, environment, story
):
    understood(good_answers, record=tmp_path / "t")
    names = {p.name for p in (tmp_path / "t").iterdir()}
    assert names == {
        "run.json",
        *(f"1-{a}-1.json" for a in good_answers),
    }
    road = json.loads((tmp_path / "t" / "1-road-1.json").read_text())
    assert story in json.dumps(road["request"])
    assert "four_way" in json.dumps(road["request"])  # the instructions too
    assert road["usage"]["input_tokens"] == 100
    key = environment["OPENAI_API_KEY"]
    assert all(key not in p.read_text() for p in (tmp_path / "t").iterdir())
    # the key did travel, so its absence means something
    assert all(key in h["authorization"] for _, _, h in chat_server.requests)


def test_a_key_in_an_answer_is_blotted_out(tmp_path, understood, good_answers, environment):
    key = environment["OPENAI_API_KEY"]
    good_answers["hazards"]["basis"] = [{"field": "speeding", "reason": f"you sent {key}"}]
    result = understood(good_answers, record=tmp_path / "t")
    assert result.speaker == "openai:scripted"
    assert "you sent [key]" in to_yaml(result.functional)
    assert all(key not in p.read_text() for p in (tmp_path / "t").iterdir())


def test_a_key_that_the_server_disguises_is_blotted_out(
    tmp_path, understood, good_answers, chat_server, environment
):
    key = environment["OPENAI_API_KEY"]
    road = {**good_answers["road"], "basis": [{"field": "junction.kind", "reason": "KEY"}]}
    function = {"name": "answer", "arguments": json.dumps(road)}
    call = {"id": "c", "type": "function", "function": function}
    message = {"role": "assistant", "content": None, "tool_calls": [call]}
    choice = {"index": 0, "finish_reason": "tool_calls", "message": message}
    body = {"id": "1", "object": "chat.completion", "created": 1, "model": "m", "choices": [choice]}
    disguised = "".join(f"\\u{ord(c):04x}" for c in key)
    raw = json.dumps(body).replace("KEY", disguised).encode()
    assert key.encode() not in raw
    good_answers["road"] = chat_server.kinds["Raw"](raw)
    result = understood(good_answers, record=tmp_path / "t")
    assert result.speaker == "openai:scripted"
    assert key not in to_yaml(result.functional) + json.dumps(result.to_data())
    assert all(key not in p.read_text() for p in (tmp_path / "t").iterdir())


def replay(folder, text):
    return understand(text, LlmSettings(models=(), replay=folder), environment={})


def test_a_recording_of_something_else_is_refused(tmp_path, understood, good_answers, story):
    understood(good_answers, record=tmp_path / "t")
    with pytest.raises(InputError, match="another description"):
        replay(tmp_path / "t", "Two cars meet at a four-way intersection.")
    run = json.loads((tmp_path / "t" / "run.json").read_text())
    (tmp_path / "t" / "run.json").write_text(json.dumps({**run, "prompts": "0"}))
    with pytest.raises(InputError, match="version of the prompts"):
        replay(tmp_path / "t", story)


@pytest.mark.parametrize(
    ("damage", "words"),
    [
        (lambda f: (f / "1-hazards-1.json").unlink(), "lacks 1-hazards-1.json"),
        (lambda f: (f / "1-hazards-1.json").write_text("{"), "1-hazards-1.json is damaged"),
        (lambda f: (f / "run.json").write_bytes(b"\xff"), "run.json is damaged"),
        (lambda f: (f / "run.json").unlink(), "lacks run.json"),
    ],
)
def test_a_damaged_recording_is_named(tmp_path, understood, good_answers, story, damage, words):
    understood(good_answers, record=tmp_path / "t")
    damage(tmp_path / "t")
    with pytest.raises(InputError, match=words):
        replay(tmp_path / "t", story)


def test_a_damaged_answer_is_no_crash(tmp_path, understood, good_answers, story):
    understood(good_answers, record=tmp_path / "t")
    path = tmp_path / "t" / "1-road-1.json"
    path.write_text(json.dumps({**json.loads(path.read_text()), "response": {"kind": "poem"}}))
    with pytest.raises(InputError, match="answer 1 of agent road is damaged"):
        replay(tmp_path / "t", story)


def test_transcripts_do_not_overwrite(tmp_path, understood, good_answers, chat_server):
    (tmp_path / "thesis.txt").write_text("years of work")
    with pytest.raises(InputError, match="is not empty"):
        understood(good_answers, record=tmp_path)
    assert chat_server.requests == []
