"""An act of which nothing says when does not come before those that are told before it."""

import numpy as np
from saying import made, missed, person, said

from scegen.motion import build_paths, simulate
from scegen.road import build_network


def test_who_brakes_for_one_that_joins_does_so_after_it():
    """Acts of several happen in the order in which they are told."""
    functional = said(
        "straight",
        person("ego", maneuvers=["straight"], speed=95),
        person("van", "van", approaches=["adjacent", "right"], maneuvers=["merge"], speed=70),
        junction={"carriageway": "divided", "auxiliary": "on_ramp"},
        acts=[
            {"id": "joins", "participant": "van", "kind": "change_lane", "into": "ego"},
            {"id": "brakes", "participant": "ego", "kind": "brake"},
        ],
        spacings=[
            {
                "participant": "ego",
                "reference": "van",
                "measure": "gap_m",
                "value": 12,
                "at": "joins",
            }
        ],
        hazards=[{"kind": "merging_conflict", "by": ["van"], "to": ["ego"]}],
    )
    concrete = made(functional).concrete
    assert missed(functional, concrete) == set()
    network = build_network(concrete.road, name="x")
    trace = simulate(concrete, build_paths(concrete, network))
    slower = trace["ego"].time_s[np.argmax(trace["ego"].speed_mps < 95 / 3.6 - 0.1)]
    moves = trace["van"].time_s[np.argmax(np.abs(np.gradient(trace["van"].y_m)) > 1e-3)]
    assert slower > moves


def test_a_leader_that_first_gains_speed_leads_from_the_start():
    functional = said(
        "straight",
        person("ego", maneuvers=["straight"], speed=50),
        person("car", approaches=["ahead"], maneuvers=["straight"]),
        acts=[
            {"id": "gains", "participant": "car", "kind": "accelerate", "target_speed_mps": 20},
            {
                "id": "slows", "participant": "car", "kind": "brake", "target_speed_mps": 6,
                "rate_mps2": 2, "when": {"type": "after", "act": "gains", "delay_s": 5},
            },
        ],
        outcome={"kind": "avoided", "between": ["ego", "car"]},
    )  # fmt: skip
    assert missed(functional, made(functional).concrete) == set()
