"""How long a story along a road goes on: until the last of those who are met has been passed."""

import pytest
from saying import KMH, person, said

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios


@pytest.mark.parametrize("away", [60.0, 250.0, 491.0])
def test_one_who_stands_far_ahead_is_passed_before_the_end(away):
    people = [
        person("ego", speed=60.0),
        person("walker", "pedestrian", approaches=["ahead"], maneuvers=["stay"]),
    ]
    apart = [
        {"participant": "walker", "reference": "ego", "measure": "gap_m", "value": away},
        {
            "participant": "walker",
            "reference": "ego",
            "measure": "lateral_offset_m",
            "value": -5.25,
        },
    ]
    functional = said("straight", *people, spacings=apart)
    concrete = concretize(functional, enumerate_scenarios(functional).scenarios[0])
    assert concrete.duration_s >= away / (60.0 * KMH) + 2.0
