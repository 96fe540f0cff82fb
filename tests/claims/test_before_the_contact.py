"""A danger that is said to end in a contact happens before it."""

import numpy as np
from saying import made, missed, person, said
from told import act

from scegen.checking.esmini.layout import simulated_csv
from scegen.checking.esmini.recording import read_recording
from scegen.enumeration import enumerate_scenarios
from scegen.understanding import read

TEXT = (
    "A pedestrian runs onto the road from the right and stops in the middle of the ego's lane, "
    "where the ego hits him."
)


def test_who_stops_and_is_hit_stands_when_it_is_hit():
    raised = made(read(TEXT))
    assert not raised.proof.missed
    moved = {m.entity: m for m in read_recording(simulated_csv(raised.concrete))}
    (hit,) = (
        c for c in raised.proof.claims if c.field == "outcome.kind" and "touch" in c.statement
    )
    walker = moved["pedestrian_1"]
    step = int(np.searchsorted(walker.time_s, hit.time_s))
    assert walker.speed_mps[step] < 0.2
    assert walker.speed_mps[:step].max() > 1.0


def collision(braking):
    """The ego runs into the car ahead, which brakes if it is said to."""
    brakes = [act("brakes", "car", "brake", target_speed_mps=9)] if braking else []
    return said(
        "straight",
        person("ego", maneuvers=["straight"], speed=70),
        person("car", approaches=["ahead"], maneuvers=["straight"], speed=50),
        acts=brakes,
        outcome={"kind": "collision", "between": ["ego", "car"]},
    )


def test_what_a_contact_does_to_somebody_is_no_braking():
    told = collision(braking=True)
    logical = enumerate_scenarios(told).scenarios[0]
    assert "act.brakes" in missed(told, made(collision(braking=False)).concrete, logical)
    assert not made(told).proof.missed
