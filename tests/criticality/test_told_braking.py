"""Braking that is told without where and how hard: the search finds both, so that all holds."""

import pytest
from playing import play

from scegen.understanding import read

PULLS_OUT = (
    "A parked car on the right pulls out in front of the ego; the ego brakes.",
    "A parked car on the right pulls out in front of the ego, which brakes and avoids a collision.",
    "A parked car pulls out in front of the ego, which manages to stop.",
    "A van pulls out of a parking space; the ego brakes, and nothing happens.",
)
BACKS_UP = (
    "The ego waits at a red light behind a van. The van rolls back and hits the ego.",
    "The ego stands at a stop sign, and the car in front rolls back into it.",
    "At a T-junction the ego is standing, and the lorry ahead of it backs into it at 5 km/h.",
)


@pytest.mark.parametrize("text", PULLS_OUT)
def test_who_pulls_out_is_braked_for_so_late_that_it_was_a_danger(text):
    made = play(read(text), files=False)
    assert made.proof.in_band
    assert not made.missed


@pytest.mark.parametrize("text", BACKS_UP)
def test_who_stands_behind_one_that_backs_up_is_there_all_the_time(text):
    made = play(read(text), files=False)
    assert made.proof.in_band
    assert not made.missed
    assert made.concrete.ego.speed_mps == 0.0
