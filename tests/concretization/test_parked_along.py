"""Who is parked stands where it is said to: so far ahead of the ego, and so far to its side."""

import numpy as np
import pytest
from saying import made, missed, person, said

from scegen.motion import build_paths, simulate
from scegen.road import build_network


def beside(*spacings, **fields):
    return said(
        "straight",
        person("ego", maneuvers=["straight"], speed=60),
        person("van", "van", parked=True, approaches=["right"], maneuvers=["stay"], **fields),
        spacings=[
            {"participant": "van", "reference": "ego", "measure": measure, "value": value}
            for measure, value in spacings
        ],
        outcome={"kind": "avoided", "between": ["ego", "van"]},
    )


@pytest.mark.parametrize("gap_m", [25.0, 60.0, 140.0])
def test_its_place_ahead_is_as_said(gap_m):
    functional = beside(("gap_m", gap_m))
    concrete = made(functional).concrete
    assert missed(functional, concrete) == set()
    trace = simulate(concrete, build_paths(concrete, build_network(concrete.road, name="x")))
    van, ego = trace["van"], trace["ego"]
    apart = np.hypot(van.x_m[0] - ego.x_m[0], van.y_m[0] - ego.y_m[0])
    assert abs(apart - gap_m) < 10.0  # bumper to bumper is the claim; this is between references


def test_its_offset_is_as_said():
    functional = beside(("gap_m", 80.0), ("lateral_offset_m", -3.4))
    assert missed(functional, made(functional).concrete) == set()
