"""Where somebody is across the road at first, and what it does to the side from there."""

import numpy as np
import pytest
from saying import made, missed, person, said

from scegen.motion import build_paths, simulate
from scegen.road import build_network


def played(functional):
    concrete = made(functional).concrete
    assert missed(functional, concrete) == set()
    return simulate(concrete, build_paths(concrete, build_network(concrete.road, name="x")))


@pytest.mark.parametrize(("at_m", "side", "by_m"), [(-2.5, "left", 1.5), (-1.0, "right", 0.5)])
def test_one_swerves_from_its_own_line(at_m, side, by_m):
    trace = played(
        said(
            "straight",
            person("ego", maneuvers=["straight"], speed=40),
            person("rider", "bicycle", approaches=["ahead"], maneuvers=["straight"], speed=16),
            hazards=[{"kind": "swerving", "by": ["rider"], "to": ["ego"]}],
            spacings=[
                {
                    "participant": "rider",
                    "reference": "ego",
                    "measure": "lateral_offset_m",
                    "value": at_m,
                }
            ],
            acts=[
                {
                    "id": "swerves",
                    "participant": "rider",
                    "kind": "swerve",
                    "side": side,
                    "lateral_m": by_m,
                }
            ],
            outcome={"kind": "avoided", "between": ["ego", "rider"]},
        )
    )["rider"]
    aside = np.abs(trace.y_m - trace.y_m[0])
    assert aside.max() == pytest.approx(by_m, abs=0.1)
    assert aside[-1] < 0.1  # back on its line


def test_an_overlap_stands_where_it_is_said_only_which_half_is_hit():
    functional = said(
        "straight",
        person("ego", maneuvers=["straight"], speed=70),
        person("car", approaches=["ahead"], maneuvers=["stay"]),
        spacings=[
            {
                "participant": "car",
                "reference": "ego",
                "measure": "overlap_percent",
                "value": 40,
                "side": "right",
            }
        ],
        hazards=[{"kind": "obstacle", "by": ["car"], "to": ["ego"]}],
        outcome={
            "kind": "collision",
            "between": ["ego", "car"],
            "impact_percent": {"low": 50, "high": 100},
        },
    )
    assert missed(functional, made(functional).concrete) == set()


def test_who_lets_a_faster_one_by_comes_into_its_lane_behind_it():
    trace = played(
        said(
            "straight",
            person("ego", maneuvers=["lane_change"], speed=100),
            person("car", approaches=["adjacent", "left"], maneuvers=["straight"], speed=160),
            junction={"lanes": [2, 2]},
            acts=[
                {"id": "waits", "participant": "ego", "kind": "give_way", "into": "car"},
                {
                    "id": "changes",
                    "participant": "ego",
                    "kind": "change_lane",
                    "side": "left",
                    "into": "car",
                },
            ],
        )
    )
    ego, car = trace["ego"], trace["car"]
    assert car.speed_mps == pytest.approx(160 / 3.6)  # it need not brake
    over = np.argmax(np.abs(ego.y_m - ego.y_m[0]) > 0.1)
    along = (car.x_m - ego.x_m) * np.cos(ego.heading_rad[0])
    assert along[0] < 0 < along[over]


def test_one_swerves_to_the_side_that_is_said_though_there_is_no_lane():
    trace = played(
        said(
            "straight",
            person("ego", maneuvers=["straight"], speed=50),
            person("truck", "truck", approaches=["opposite"], maneuvers=["straight"], speed=50),
            hazards=[{"kind": "oncoming_lane", "by": ["truck"], "to": ["ego"]}],
            acts=[{"id": "dodges", "participant": "ego", "kind": "swerve", "side": "right"}],
        )
    )["ego"]
    right = -(trace.y_m - trace.y_m[0]) * np.cos(trace.heading_rad[0])
    assert right.min() > -0.05
    assert 0.5 < right.max() < 1.0  # as far as its lane lets it
