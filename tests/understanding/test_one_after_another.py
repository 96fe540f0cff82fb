"""What follows another act does so some time later, but at once where a text says so."""

import pytest

from scegen.understanding import read


def last(text):
    """What sets off the last act of a text, of which every word is understood."""
    found = read(text)
    assert found.unsupported == ()
    return found.acts[-1].when


@pytest.mark.parametrize(
    "text",
    [
        "The car ahead brakes and then changes to the left lane.",
        "The car ahead brakes to 30 km/h. After a while it changes to the left lane.",
        "The car ahead brakes to 30 km/h and some time later accelerates to 60 km/h.",
        "After the car ahead has stopped, the ego changes lanes.",
        "A car cuts in immediately in front of the ego and brakes.",
        "The ego first brakes to 30 km/h, after a while accelerates to 60 km/h and finally stops.",
    ],
)
def test_then_is_some_time_later(text):
    assert last(text).delay_s is None


@pytest.mark.parametrize(
    "text",
    [
        "The car ahead brakes and immediately changes to the left lane.",
        "The car ahead brakes and changes to the left lane immediately after.",
        "The car ahead brakes to 30 km/h. Right afterwards it changes to the left lane.",
        "The car ahead stops, then at once the ego stops.",
        "As soon as the car ahead brakes, the ego changes lanes.",
        "Directly after the car ahead has stopped, the ego changes lanes.",
        "Right after the car ahead has stopped, the ego changes lanes.",
    ],
)
def test_at_once_is_no_time_later(text):
    assert last(text).delay_s.high == 0.0


def test_what_comes_first_comes_first():
    found = read("The ego first brakes to 30 km/h, and after a while accelerates to 60 km/h.")
    assert [(a.kind.value, a.when and a.when.act) for a in found.acts] == [
        ("brake", None),
        ("accelerate", "brake_1"),
    ]
