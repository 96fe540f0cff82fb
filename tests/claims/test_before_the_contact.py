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


def touching(raised):
    """The claim that two touch."""
    fits = (c for c in raised.proof.claims if c.field == "outcome.kind" and "touch" in c.statement)
    (hit,) = fits
    return hit


def test_who_stops_and_is_hit_stands_when_it_is_hit():
    raised = made(read(TEXT))
    assert not raised.proof.missed
    moved = {m.entity: m for m in read_recording(simulated_csv(raised.concrete))}
    hit = touching(raised)
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


def test_who_speeds_up_into_another_is_as_fast_as_is_said_before():
    told = said(
        "straight",
        person("ego", maneuvers=["straight"]),
        person("car", approaches=["ahead"], maneuvers=["stay"]),
        acts=[act("speeds_up", "ego", "accelerate", target_speed_mps=15)],
        outcome={"kind": "collision", "between": ["ego", "car"]},
    )
    raised = made(told)
    assert not raised.proof.missed
    moved = {m.entity: m for m in read_recording(simulated_csv(raised.concrete))}
    (hit,) = (
        c for c in raised.proof.claims if "touch" in c.statement and c.field == "outcome.kind"
    )
    step = int(np.searchsorted(moved["ego"].time_s, hit.time_s))
    assert abs(moved["ego"].speed_mps[step - 5] - 15) < 0.2
    assert moved["ego"].speed_mps[step + 5 :].max() < 0.2
