"""Which side of the ego is touched first: clear of its corners, or nobody could say."""

import numpy as np
import pytest
from saying import made, missed, person, said

from scegen.checking.esmini.layout import simulated_csv
from scegen.checking.esmini.recording import read_recording
from scegen.understanding import read


def hit(side, approach="left"):
    people = person("ego", maneuvers=["straight"]), person("car", approaches=[approach])
    outcome = {"kind": "collision", "between": ["ego", "car"], "struck": side}
    return said("four_way", *people, junction={"lanes": [1] * 4}, outcome=outcome)


def reaches_m(concrete):
    """How far the other's box overlaps each side of the ego's at first contact (left, front)."""
    movements = {m.entity: m for m in read_recording(simulated_csv(concrete))}
    ego, car, body = movements["ego"], movements["car"], concrete.ego.body
    middles = [m.point + body.centre_ahead_m * np.exp(1j * m.heading_rad) for m in (ego, car)]
    turn = np.exp(-1j * ego.heading_rad)
    at = (middles[1] - middles[0]) * turn
    along = np.abs((np.exp(1j * car.heading_rad) * turn).real)
    across = np.abs((np.exp(1j * car.heading_rad) * turn).imag)
    length = (body.length_m * along + body.width_m * across) / 2
    width = (body.length_m * across + body.width_m * along) / 2
    front = at.real - length - body.length_m / 2
    left = at.imag - width - body.width_m / 2
    step = int((np.maximum(front, left) <= 0.0).argmax())
    return -left[step], -front[step]


@pytest.mark.parametrize("side", ["left", "front"])
def test_a_side_that_is_said_is_struck_clear_of_the_corners(side):
    raised = made(hit(side))
    assert not raised.proof.missed
    left, front = reaches_m(raised.concrete)
    assert (front if side == "left" else left) > 0.2


def test_a_corner_is_no_side():
    functional = hit("left")
    concrete = made(functional).concrete
    car = concrete.participant("car")
    struck = set()
    for metres in np.arange(-6.0, 6.0, 0.1):
        start = car.motion.start_m + metres
        moved = car.model_copy(update={"motion": car.motion.model_copy(update={"start_m": start})})
        people = tuple(moved if p is car else p for p in concrete.participants)
        tried = concrete.model_copy(update={"participants": people})
        lost = {side: missed(hit(side), tried) for side in ("left", "front")}
        if "outcome.kind" not in lost["left"]:
            struck.add(tuple(side for side in lost if "outcome.struck" not in lost[side]))
    assert struck > {()}
    assert ("left", "front") not in struck


@pytest.mark.parametrize("does", ["moves over", "drifts over", "cuts in"])
def test_who_comes_over_from_the_lane_beside_touches_the_side_that_is_said(does):
    text = f"A lorry beside the ego in the left lane of a motorway {does} and hits its left side."
    functional = read(text)
    assert functional.outcome.struck == "left"
    assert not made(functional).proof.missed


def test_who_is_alone_hits_nobody_anywhere():
    outcome = {"kind": "collision", "between": [], "struck": "front", "impact_percent": 25.0}
    raised = made(said("straight", person("ego", maneuvers=["straight"]), outcome=outcome))
    missed = {proof.id for proof in raised.proof.missed}
    assert missed == {"outcome.kind", "outcome.struck", "outcome.impact_percent"}
