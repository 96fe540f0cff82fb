"""One limit of participants, told in the same words by everybody."""

from __future__ import annotations

import pytest

from scegen.enumeration import enumerate_scenarios
from scegen.errors import InfeasibleError
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.size import MAX_PARTICIPANTS
from scegen.understanding import read


def crowd(count):
    others = [{"id": f"car_{n}", "kind": "car"} for n in range(1, count)]
    return FunctionalScenario.model_validate(
        {
            "description": "",
            "junction": {"kind": "four_way", "arms": 4},
            "participants": [{"id": "ego", "kind": "car", "role": "ego"}, *others],
        }
    )


def test_the_reader_and_a_file_meet_the_same_limit():
    with pytest.raises(InfeasibleError) as by_text:
        read("40 cars enter a four-way intersection.")
    with pytest.raises(InfeasibleError) as by_file:
        enumerate_scenarios(crowd(MAX_PARTICIPANTS + 1))
    assert by_text.value.render() == by_file.value.render()
    assert str(MAX_PARTICIPANTS) in by_text.value.render()


def test_as_many_as_the_limit_are_counted():
    assert enumerate_scenarios(crowd(MAX_PARTICIPANTS), limit=2).scenarios
