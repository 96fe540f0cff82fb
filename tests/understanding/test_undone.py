"""What somebody is told to do is in the scenario, or is said to be left out."""

import pytest

from scegen.understanding import read


def _left_out(text):
    return {u.text for u in read(text).unsupported}


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("The car ahead drives with one rear light and pulls onto the verge.", "pulls onto"),
        ("The ego waits behind a car that is waiting for a parking space.", "waits"),
        ("The lead car speeds up to 50 km/h, then returns to 30 km/h.", "returns"),
        ("At a roundabout a car goes round; the ego gives way and then enters.", "gives way"),
    ],
)
def test_what_became_no_act_is_said(text, words):
    assert any(words in left for left in _left_out(text))


@pytest.mark.parametrize(
    "text",
    [
        "The lead car brakes to a standstill, waits for 3 s and sets off again.",
        "The ego stops for a pedestrian who crosses.",
        "A pedestrian waits on the right and then crosses.",
        "The ego turns left and waits until two oncoming cars are through.",
        "The ego does not brake.",
        "A van wants to pull out.",
        "The car ahead brakes, and the ego changes to the left lane.",
    ],
)
def test_what_is_shown_wished_or_denied_is_not(text):
    acts = ("brakes", "waits", "sets off", "stops", "pull out", "changes", "brake")
    assert not _left_out(text) & {*acts}


def test_two_distances_at_one_moment_are_said():
    scenario = read("The bus ahead stops; the ego, 14 m behind it, stops and keeps 3 m to the bus.")
    assert [s.value.low for s in scenario.spacings] == [14]
    assert any("3 m" in u.text and "otherwise" in u.instead for u in scenario.unsupported)
