"""One scenario, raised with the scripted model's proposals."""

import pytest

from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.criticality.agent import ParameterAgent
from scegen.enumeration import enumerate_scenarios
from scegen.llm import Session
from scegen.pipeline.picking import pick
from scegen.understanding import read

TEXT = (
    "Two speeding vehicles approach a T-intersection simultaneously from opposite directions, one "
    "trying to make an unprotected left turn."
)


@pytest.fixture(scope="session")
def scenario():
    """A functional and a concrete scenario whose numbers have to change."""
    functional = read(TEXT)
    logical = enumerate_scenarios(functional)
    return functional, concretize(functional, pick(logical, None)[0], seed=0)


@pytest.fixture
def session_for(settings_for, environment):
    return lambda **changes: Session(settings_for(**changes), environment)


@pytest.fixture
def advised(chat_server, session_for, scenario):
    """Raises the scenario with the script's answers; gives back the result and the session."""

    def run(answers, *, session=None, concrete=None, **changes):
        chat_server.answers = answers if isinstance(answers, dict) else {"parameters": answers}
        session = session or session_for(**changes)
        functional, own = scenario
        agent = ParameterAgent(session)
        return raise_criticality(functional, concrete or own, proposer=agent), session

    return run


def change(parameter, value, reason="for the near-miss"):
    return {"parameter": parameter, "value": value, "reason": reason}


@pytest.fixture
def good_changes():
    """Changes that lead to a near-miss at once."""
    return {
        "changes": [
            change("car_1.start_m", 42.0, "car_1 comes 1.2 s earlier"),
            change("car_2.start_m", 2.0, "car_2 comes 0.3 s later"),
        ]
    }
