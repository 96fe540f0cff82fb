"""Who brakes at a junction does so for the one that endangers it, where it meets that one."""

import pytest
from saying import missed
from told import first

from scegen.understanding import read

SENTENCES = [
    "At a crossroads a car from the right does not yield. The ego at 50 km/h brakes at 7 m/s².",
    "At a crossroads a car from the right does not yield to the ego, which goes straight on and "
    "brakes.",
    "A car runs the red light from the right at 50 km/h. The ego, 50 km/h, brakes just in time.",
    "A learner driver ahead stalls at the green light and does not move; the ego, 15 m behind it "
    "at 30 km/h, stops.",
]


@pytest.mark.parametrize("text", SENTENCES)
def test_it_holds_from_the_first(text):
    functional = read(text)
    assert functional.acts
    assert not missed(functional, first(functional))


def test_who_backs_out_of_a_bay_comes_from_beside_at_the_speed_that_is_said():
    text = "A car backs out of a parking space on the right at 6 km/h into the ego's path."
    functional = read(text)
    concrete = first(functional)
    assert concrete.participant("car_1").motion.reversal.side == "right"
    assert not missed(functional, concrete) & {"speed.car_1", "approach.car_1"}
