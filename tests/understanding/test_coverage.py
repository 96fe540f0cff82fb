"""Words of manner, direction, state and measure are used or reported, never dropped."""

import pytest

from scegen.understanding import read


def reported(text):
    return {u.text: u.instead for u in read(text).unsupported}


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("The ego must react suddenly because a boy crosses the road.", "suddenly"),
        ("A northbound van brakes.", "northbound"),
        ("A van parks quickly.", "quickly"),
        ("The ego drives past a van that is 3 m high.", "3 m"),
    ],
)
def test_what_fills_no_field_is_reported(text, word):
    assert word in reported(text)


@pytest.mark.parametrize(
    "text",
    [
        "The ego turns left at a crossroads.",
        "A van coming from the right of the ego suddenly brakes.",
        "Vehicle 1 was northbound. Vehicle 2 was westbound.",
        "A van drives at 50 km/h at night.",
        "A girl comes from the left and walks across in front of the ego.",
        "Backing up at 4 km/h, the ego stops for a man who walks across behind it from the left.",
        "A cyclist rides ahead at 14 km/h and the ego comes up from behind at 55 km/h.",
    ],
)
def test_what_fills_a_field_is_not_reported(text):
    assert reported(text) == {}


def test_words_that_contradict_each_other_are_told():
    assert reported("In rain a van turns left. In snow a bus turns right.") == {
        "snow": "contradicts 'rain', which is kept"
    }


def test_what_hides_somebody_is_not_left_out():
    """The hedge is placed where it hides the man: nothing of the phrase is unsupported."""
    scenario = read("A man hidden behind a hedge on the right steps onto the road.")
    assert not {"behind", "a hedge", "right"} & {u.text for u in scenario.unsupported}
    words = [e.text for e in scenario.evidence if e.field.endswith(".approaches")]
    assert words == ["behind a hedge on the right"]
