"""Impacts and injuries."""

import numpy as np
import pytest
from criticality_geometry import cruising, line

from scegen.measures import build_tables, measure
from scegen.measures.bodies import body_of
from scegen.measures.impact import delta_v
from scegen.measures.injury import injury_probability
from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ParticipantKind

CAR, PED, TRUCK = (BODIES[ParticipantKind(kind)] for kind in ("car", "pedestrian", "truck"))


@pytest.mark.parametrize(
    ("heading", "speeds", "expected"),
    [
        (np.pi, (10.0, 15.0), 25.0),  # head on
        (0.0, (20.0, 5.0), 15.0),  # rear end
        (np.pi / 2, (12.0, 5.0), 13.0),  # crossing
    ],
)
def test_impact_speed_is_vectorial(heading, speeds, expected):
    start = {np.pi: (60.0, 0.0), 0.0: (20.0, 0.0), np.pi / 2: (36.0, -15.0)}[heading]
    paths = [line(0, 0, 0, 200), line(*start, heading, 200)]
    scene = build_tables(paths, (CAR, TRUCK))
    traces = cruising(paths, [0, 0], speeds)
    found = measure(traces, scene)
    assert found.impact_mps[0, 0] == pytest.approx(expected)
    # Momentum is conserved, and the two changes make up the impact speed.
    changes, chances = found.delta_v_mps[0, 0], found.injury[0, 0]
    assert changes[0] * CAR.mass_kg == pytest.approx(changes[1] * TRUCK.mass_kg)
    assert changes.sum() == pytest.approx(expected)
    assert chances[0] > chances[1]  # the lighter one fares worse


def test_without_contact_there_is_nothing():
    paths = [line(0, 0, 0, 200), line(0, 10, 0, 200)]
    scene = build_tables(paths, (CAR, CAR))
    found = measure(cruising(paths, [0, 0], [9, 9]), scene)
    assert np.isnan(found.impact_mps).all()
    assert np.isnan(found.injury).all()


def test_equal_masses_share_the_change():
    assert delta_v(10.0, 1000.0, 1000.0) == 5.0


def test_injury_curves_go_through_their_published_points():
    scene = build_tables([line(0, 0, 0, 9), line(0, 9, 0, 9)], (CAR, PED))
    car, pedestrian = body_of(scene.bodies, 0), body_of(scene.bodies, 1)
    # Occupants: 50 % where 6.9540 = 0.1637 * delta-v in mph.
    assert injury_probability(car, 99.0, 6.9540 / 0.1637 * 0.44704) == pytest.approx(0.5)
    # Pedestrians: 10 % at 30.8 km/h impact speed, 50 % at 59 km/h, whatever delta-v.
    assert injury_probability(pedestrian, 30.8 / 3.6, 0.0) == pytest.approx(0.1, abs=0.001)
    assert injury_probability(pedestrian, 4.6 / 0.078 / 3.6, 0.0) == pytest.approx(0.5)
