"""Settings with short times, and one understanding by the scripted model."""

import pytest

from scegen.llm import LlmSettings, parse_models
from scegen.llm.settings import Limits
from scegen.understanding.agents import understand

KEY = "sk-secret-0123456789"
QUICK = Limits(
    request_s=0.5, run_s=5.0, attempts=3, first_wait_s=0.01, longest_wait_s=0.2, answer_bytes=50_000
)


@pytest.fixture
def environment():
    return {"OPENAI_API_KEY": KEY, "DEEPSEEK_API_KEY": KEY}


@pytest.fixture
def settings_for(chat_server):
    def make(models="openai:scripted", **changes):
        url = changes.pop("url", chat_server.url)
        changes.setdefault("limits", QUICK)
        return LlmSettings(models=parse_models(models, url=url), url=url, **changes)

    return make


@pytest.fixture
def understood(chat_server, settings_for, environment, story):
    """Understands the story with the script's answers."""

    def run(answers, text=story, **changes):
        chat_server.answers = answers
        return understand(text, settings_for(**changes), environment=environment)

    return run
