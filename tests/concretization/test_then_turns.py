"""Who slows down, or stands, and is to turn does turn; who walks up to the kerb stops there."""

import numpy as np
import pytest
from saying import made, missed, person, said

from scegen.motion import simulate
from scegen.motion.paths import build_paths
from scegen.road import build_network
from scegen.scenario.concrete import CrossingMotion

THEN = {"type": "after", "act": "first"}
TURNS = {
    "a leader that brakes": said(
        "t",
        person("car", approaches=["ahead"], maneuvers=["right"]),
        person("ego", maneuvers=["straight"]),
        acts=[{"id": "first", "participant": "car", "kind": "brake"}],
        hazards=[{"kind": "hard_braking", "by": ["car"]}],
    ),
    "who waits first": said(
        "t",
        person("car", approaches=["ahead"], maneuvers=["left"]),
        person("ego", maneuvers=["straight"]),
        acts=[
            {"id": "first", "participant": "car", "kind": "wait"},
            {"id": "turns", "participant": "car", "kind": "turn", "when": THEN},
        ],
    ),
}


def turned_deg(concrete, name):
    network = build_network(concrete.road, name=concrete.name)
    trace = simulate(concrete, build_paths(concrete, network))[name]
    return abs(np.degrees(np.unwrap(trace.heading_rad)[-1] - trace.heading_rad[0]))


@pytest.mark.parametrize("name", TURNS)
def test_the_turn_is_completed(name):
    functional = TURNS[name]
    concrete = made(functional).concrete
    assert turned_deg(concrete, "car") == pytest.approx(90.0, abs=2.0)
    assert missed(functional, concrete) == set()


def test_who_walks_up_to_the_kerb_stops_before_the_lanes():
    functional = said(
        "straight",
        person("ego", maneuvers=["straight"], speed=50),
        person("child", "pedestrian", approaches=["right"], maneuvers=["cross"], speed=6),
        acts=[
            {"id": "a", "participant": "child", "kind": "cross", "distance_m": 0.0},
        ],
    )
    concrete = made(functional).concrete
    child = next(p for p in concrete.participants if p.id == "child")
    assert isinstance(child.motion, CrossingMotion)
    assert child.motion.stops_after_m == child.motion.setback_m > 1.5
    assert missed(functional, concrete) == set()
