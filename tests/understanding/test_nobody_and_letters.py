"""Denied subjects and ways, letters that name participants, and roles before a colon."""

import pytest

from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding.reader import read

_LEFT, _RIGHT, _STRAIGHT = Maneuver.LEFT, Maneuver.RIGHT, Maneuver.STRAIGHT


@pytest.mark.parametrize(
    "denied", ["nobody gives way", "no driver yields", "none of the drivers is willing to yield"]
)
def test_nobody_yields_means_that_everybody_fails_to(denied: str) -> None:
    scenario = read(f"At a four-way junction two cars meet and {denied}.")
    assert len(scenario.participants) == 2
    assert [h.kind for h in scenario.hazards] == [HazardKind.FAILURE_TO_YIELD]


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("The ego must not turn left at the crossroads.", {_RIGHT, _STRAIGHT}),
        ("The ego turns right, not left, at the crossroads.", {_RIGHT}),
        ("The ego turns neither left nor right at the crossroads.", {_STRAIGHT}),
    ],
)
def test_a_way_that_is_ruled_out_leaves_the_others(text: str, left: set[Maneuver]) -> None:
    assert set(read(text).participants[0].maneuvers) == left


def test_letters_stand_for_participants() -> None:
    scenario = read("Two cars A and B approach a T-junction. A turns left; B goes straight.")
    assert [set(p.maneuvers) for p in scenario.participants] == [{_LEFT}, {_STRAIGHT}]


def test_an_article_is_no_letter() -> None:
    assert len(read("A car stops behind a bus. A van waits.").participants) == 3


def test_the_noun_after_a_role_plays_it() -> None:
    scenario = read("Lead vehicle: truck, brakes hard. Ego: car.")
    assert [p.kind.value for p in scenario.participants] == ["truck", "car"]
