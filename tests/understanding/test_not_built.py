"""Roads that are not built as they are told of: refused, or told what stands for them."""

import pytest

from scegen.errors import InfeasibleError
from scegen.understanding.reader import read


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("A bus in the bus lane pulls into the ego's lane.", "bus lane"),
        ("On a cycle street the ego follows a cyclist.", "cycle street"),
        ("At a roundabout with a bypass lane the ego takes the first exit.", "bypass lane"),
        ("At a roundabout with three lanes the ego takes the first exit.", "three lanes"),
        ("At a crossroads with four lanes per direction the car ahead brakes.", "four lanes"),
        ("The ego stops at a pelican crossing for a man.", "pelican crossing"),
        ("At a signalised mid-block crossing a man walks over the road.", "signalised"),
    ],
)
def test_what_stands_for_it_is_told(text, words):
    assert words in [u.text for u in read(text).unsupported]


@pytest.mark.parametrize(
    ("text", "lanes"),
    [("An eight-lane motorway; the car ahead brakes.", 4), ("A three-lane motorway.", 3)],
)
def test_as_many_lanes_as_can_be_had_are(text, lanes):
    assert read(text).junction.lanes == (lanes, lanes)


@pytest.mark.parametrize("lanes", ["five lanes per direction", "12 lanes"])
def test_more_lanes_than_are_built_are_refused(lanes):
    with pytest.raises(InfeasibleError, match="at most 4"):
        read(f"On a motorway with {lanes} the car ahead of the ego brakes.")


@pytest.mark.parametrize(
    ("text", "most"),
    [
        ("The ego drives in lane 6 of a freeway.", 4),
        ("The ego drives in lane 4 at a crossroads.", 3),
    ],
)
def test_a_lane_beyond_those_that_are_built_is_refused(text, most):
    with pytest.raises(InfeasibleError, match=f"at most {most}"):
        read(text)


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("At a roundabout with five flags a van turns off in front of the ego.", "five"),
        ("The ego follows a van that brakes five times.", "five"),
        ("The ego drives in lane 7 of a motorway.", "7"),
    ],
)
def test_a_number_that_counts_nothing_here_is_told(text, number):
    assert number in [u.text for u in read(text).unsupported]


def test_a_number_that_counts_those_who_are_there_is_not():
    assert not read("At a crossroads four cars arrive, one from each of the four arms.").unsupported
