"""Stated directions of the arms, and lanes of a roundabout."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.errors import InfeasibleError
from scegen.understanding import read


@pytest.mark.parametrize(
    ("text", "kind", "angles"),
    [
        (
            "Two cars meet at a junction with arms at 0, 40, 180 and 220 degrees.",
            "skewed",
            (0, 40, 180, 220),
        ),
        ("A van reaches a junction whose roads lie at 0°, 120° and 240°.", "y", (0, 120, 240)),
        ("A T-intersection with legs at 0, 90 and 180 degrees and a car.", "t", (0, 90, 180)),
        ("A junction with arms at 270, 0, 90 and 180 degrees and a car.", "four_way", None),
        ("Two roads cross at an angle of 60 degrees; a car turns left.", "skewed", None),
    ],
)
def test_angles_give_the_shape(text, kind, angles):
    junction = read(text).junction
    assert junction.kind == kind
    assert len(junction.arm_angles_deg) == junction.arms
    if angles is not None:
        assert junction.arm_angles_deg == angles


def test_the_words_are_the_evidence():
    scenario = read("Two cars meet at a junction with arms at 0, 40, 180 and 220 degrees.")
    held = [e.text for e in scenario.evidence if e.field == "junction.arm_angles_deg"]
    assert held == ["0, 40, 180 and 220 degrees"]
    assert len(scenario.participants) == 2
    assert scenario.unsupported == ()


@given(st.lists(st.integers(0, 359), min_size=3, max_size=6, unique=True))
def test_any_listed_angles_are_kept_in_order(angles):
    listed = ", ".join(map(str, angles[:-1])) + f" and {angles[-1]} degrees"
    junction = read(f"A car at a junction with arms at {listed}.").junction
    assert junction.arm_angles_deg == tuple(sorted(map(float, angles)))
    assert junction.arms == len(angles)


def test_angles_that_contradict_the_number_of_arms():
    with pytest.raises(InfeasibleError):
        read("A T-intersection with arms at 0, 90, 180 and 270 degrees and a car.")


def test_a_speed_or_a_temperature_is_no_angle():
    assert read("A car turns left at 30 km/h at 20 degrees.").junction.arm_angles_deg == ()


@pytest.mark.parametrize("text", ["A roundabout with two lanes.", "A two-lane roundabout."])
def test_two_lanes_of_a_roundabout_are_its_ring(text):
    assert read(f"{text} A car enters.").junction.ring_lanes == 2


def test_two_branches_of_a_junction_are_not_all_of_it():
    assert (
        read("A van overtakes a bus where the two branches of a Y-junction meet.").junction.arms
        == 3
    )
