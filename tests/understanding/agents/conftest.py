"""One understanding by the scripted model."""

import pytest

from scegen.understanding.agents import understand


@pytest.fixture
def understood(chat_server, settings_for, environment, story):
    """Understands the story with the script's answers."""

    def run(answers, text=story, **changes):
        chat_server.answers = answers
        return understand(text, settings_for(**changes), environment=environment)

    return run
