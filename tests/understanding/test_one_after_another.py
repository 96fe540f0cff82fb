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


@pytest.mark.parametrize(
    ("text", "delays"),
    [
        (
            "The car ahead brakes to 40 km/h. 3 s after this it accelerates to 60 km/h and then "
            "stops.",
            [("accelerate_1", "brake_1", 3.0), ("stop_1", "accelerate_1", None)],
        ),
        (
            "The van brakes, accelerates 2 s later and changes lanes 3 s after that.",
            [("accelerate_1", "brake_1", 2.0), ("change_lane_1", "accelerate_1", 3.0)],
        ),
        (
            "One second after that car begins to brake, the ego brakes. That car is ahead.",
            [("brake_2", "brake_1", 1.0)],
        ),
        (
            "The car ahead changes lanes, but before that it brakes to 50 km/h.",
            [("change_lane_1", "brake_1", None)],
        ),
    ],
)
def test_after_that_and_before_that(text, delays):
    acts = [a for a in read(text).acts if a.when is not None]
    found = [(a.id, a.when.act, a.when.delay_s and a.when.delay_s.middle) for a in acts]
    assert found == delays


@pytest.mark.parametrize(
    ("text", "ways"),
    [
        ("The ego changes to the left lane and overtakes the truck.", ["lane_change"]),
        ("The ego overtakes the truck by changing to the left lane.", ["lane_change"]),
        ("The ego swings out to the left and overtakes the truck.", ["overtake"]),
        ("The ego swings out to the left, overtakes the truck and stays there.", ["lane_change"]),
        ("The ego overtakes the truck and keeps to the left lane.", ["lane_change"]),
        ("The ego overtakes the truck on the left and does not come back.", ["lane_change"]),
        ("The ego changes to the left lane, passes the truck and then returns to the right lane.",
         ["overtake"]),
    ],
)  # fmt: skip
def test_going_over_to_pass_is_passing(text, ways):
    found = read(text)
    assert [m.value for m in found.participant("ego").maneuvers] == ways
    assert (found.acts[0].kind.value, found.acts[0].side.value) == ("overtake", "left")


@pytest.mark.parametrize("when", ["later", "2 s later", "at once", "afterwards", "a moment later"])
def test_brakes_is_a_verb_after_an_adverb_of_time(when):
    found = read(f"The van changes to the right lane and {when} brakes to 40 km/h.")
    assert [a.kind.value for a in found.acts] == ["change_lane", "brake"]
    assert found.acts[1].target_speed_mps is not None
