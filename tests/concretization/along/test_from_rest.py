"""Who stops and then moves aside sets off before it does: nobody moves aside on the spot."""

import numpy as np
import pytest
from saying import made, missed, person, said

from scegen.motion import simulate
from scegen.motion.paths import build_paths
from scegen.road import build_network

STOPS = {
    "id": "stops",
    "participant": "car",
    "kind": "brake",
    "target_speed_mps": 0.0,
}
AFTER = {"type": "after", "act": "stops"}


def then(when, **stop):
    return said(
        "straight",
        person("ego", maneuvers=["straight"], speed=60),
        person("car", approaches=["ahead"], maneuvers=["lane_change"], speed=60),
        junction={"lanes": [2, 2]},
        acts=[
            {**STOPS, **stop},
            {
                "id": "over",
                "participant": "car",
                "kind": "change_lane",
                "side": "left",
                "when": when,
            },
        ],
        hazards=[{"kind": "stopping", "by": ["car"]}],
    )


@pytest.mark.parametrize(
    "functional",
    [
        then(AFTER),
        then({**AFTER, "delay_s": {"low": 4.0, "high": 4.0}}),
        then(AFTER, kind="stop", target_speed_mps=None),
    ],
    ids=["some time later", "after 4 s", "stops"],
)
def test_it_rolls_before_it_moves_aside(functional):
    concrete = made(functional).concrete
    assert not missed(functional, concrete)
    paths = build_paths(concrete, build_network(concrete.road))
    trace = simulate(concrete, paths, dt_s=0.05)["car"]
    speed, y = trace.speed_mps, trace.y_m
    stood = int(np.argmax(speed < 0.05))
    assert speed[stood] < 0.05
    aside = np.flatnonzero(np.abs(y - y[0]) > 0.2)
    assert aside.size
    assert aside[0] > stood
    assert speed[aside[0]] > 2.0
