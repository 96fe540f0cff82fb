"""Claims name the words that they rest on."""

import pytest

from scegen.claims.told import Told
from scegen.enumeration import enumerate_scenarios
from scegen.understanding import read

TEXT = "The ego follows a van at 72 km/h. The van brakes with 5 m/s2 and the ego hits it."


@pytest.fixture(scope="module")
def told():
    functional = read(TEXT)
    return Told(functional, enumerate_scenarios(functional).scenarios[0])


@pytest.mark.parametrize(
    ("field", "words"),
    [
        ("acts.brake_1", "brakes"),
        ("acts.brake_1.rate_mps2", "5 m/s2"),
        ("acts.brake_1.when", "brakes"),
        ("outcome", "hits"),
        ("outcome.between", "hits"),
        ("environment.weather", None),
    ],
)
def test_words(told, field, words):
    assert told.words(field) == words
