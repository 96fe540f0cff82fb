"""What is said of lights that no field holds is reported."""

import pytest

from scegen.understanding import read


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("The ego drives towards a traffic light; the light turns red and it brakes.", "turns red"),
        ("A van from the left crosses on amber while the ego goes straight on green.", "amber"),
        ("A pedestrian crosses on green while the ego turns right at the lights.", "green"),
    ],
)
def test_is_reported(text, words):
    assert words in [remark.text for remark in read(text).unsupported]


def test_what_the_rules_say_is_not():
    text = "The car from the left runs the red light and hits the ego, which has green."
    assert read(text).unsupported == ()
