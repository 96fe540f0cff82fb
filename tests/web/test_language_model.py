"""A description given to a language model from the page: what it takes is told, its key never."""

import pytest

pytestmark = pytest.mark.browser
KEY = "sk-secret-0123456789"


def test_a_model_understands_and_the_page_says_what_it_took(
    serve, visit, chat_server, good_answers, story, monkeypatch
):
    monkeypatch.setenv("OPENAI_API_KEY", KEY)
    chat_server.answers = good_answers
    server = serve("--llm", "openai:scripted", "--llm-url", chat_server.url)
    visitor = visit(server.url)
    visitor.understood(story)
    assert "openai:scripted: key found" in visitor.page.inner_text(".model")
    assert "understood by openai:scripted" in visitor.page.inner_text(".found")
    assert "5 requests" in visitor.page.inner_text(".model")
    assert KEY not in visitor.page.content() + server.log


def test_where_no_model_answers_the_offline_reader_does(serve, visit, story):
    server = serve("--llm", "openai:scripted", "--llm-url", "http://127.0.0.1:9/v1")
    visitor = visit(server.url)
    visitor.understood(story)
    assert "understood by offline reader" in visitor.page.inner_text(".found")


def test_a_missing_key_is_said_and_what_to_do(serve, visit, story, monkeypatch):
    for name in ("OPENAI_API_KEY", "SCEGEN_LLM_KEY"):
        monkeypatch.delenv(name, raising=False)
    visitor = visit(serve("--llm", "openai:scripted").url)
    visitor.say(story)
    visitor.page.wait_for_selector(".words .problem >> text=OPENAI_API_KEY")
    assert "no key in the environment" in visitor.page.inner_text(".model")
