"""The connection test, against a server that serves and against one that does not."""

import json
from dataclasses import replace

import pytest

from scegen.llm import ModelName
from scegen.llm.probe import probe
from scegen.llm.settings import Limits

KEY = {"OPENAI_API_KEY": "sk-secret-0123456789"}
PATIENT = Limits(request_s=60, run_s=120, attempts=2, first_wait_s=0.01, corrections=1)


def test_a_model_that_serves(chat_server):
    chat_server.answers = {"probe": {"arms": 4}}
    found = probe(ModelName("openai", "x"), KEY, url=chat_server.url, limits=PATIENT)
    assert found.fault is None
    assert (found.usage.requests, found.usage.tokens) == (1, 120)
    assert found.address == chat_server.url


@pytest.mark.parametrize(
    ("answer", "kind"),
    [
        (("Status", 401), "authentication"),
        (("Status", 404), "not_found"),
        (("Text", "four"), "invalid"),
    ],
)
def test_a_model_that_does_not(chat_server, answer, kind):
    name, *arguments = answer
    chat_server.answers = {"probe": chat_server.kinds[name](*arguments)}
    found = probe(ModelName("openai", "x"), KEY, url=chat_server.url, limits=PATIENT)
    assert found.fault.kind == kind


def test_the_protocol_of_anthropic(chat_server):
    answer = {
        "id": "m",
        "type": "message",
        "role": "assistant",
        "model": "claude-haiku-4-5",
        "content": [{"type": "tool_use", "id": "t", "name": "answer", "input": {"arms": 4}}],
        "stop_reason": "tool_use",
        "stop_sequence": None,
        "usage": {"input_tokens": 10, "output_tokens": 5},
    }
    chat_server.answers = {"probe": chat_server.kinds["Raw"](json.dumps(answer).encode())}
    url = chat_server.url.removesuffix("/v1")
    key = {"ANTHROPIC_API_KEY": "sk-secret-0123456789"}
    found = probe(ModelName("anthropic", "claude-haiku-4-5"), key, url=url, limits=PATIENT)
    assert found.fault is None
    assert found.usage.tokens == 15
    assert found.usage.cost_usd > 0
    ((_, _, headers),) = chat_server.requests
    assert any(key["ANTHROPIC_API_KEY"] in value for value in headers.values())


def test_a_model_that_never_ends(chat_server):
    chat_server.answers = {"probe": chat_server.kinds["Drip"]()}
    limits = replace(PATIENT, request_s=0.5)
    found = probe(ModelName("openai", "x"), KEY, url=chat_server.url, limits=limits)
    assert found.fault.kind == "timeout"
