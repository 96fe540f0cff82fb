"""What is said twice is claimed once."""

import pytest
from saying import person, said

from scegen.claims import claims_of
from scegen.enumeration import enumerate_scenarios


def claimed(*acts):
    people = [
        person("ego", speed=80.0),
        person("van", "van", approaches=["adjacent", "left"], maneuvers=["lane_change"]),
    ]
    functional = said("straight", *people, junction={"lanes": [2, 2]}, acts=list(acts))
    logical = enumerate_scenarios(functional).scenarios[0]
    return logical, {claim.id for claim in claims_of(functional, logical)}


def test_a_change_of_lane_is_claimed_as_a_manoeuvre_where_it_is_no_act():
    _, ids = claimed()
    assert "maneuver.lane_change.van" in ids


@pytest.mark.parametrize("side", ["left", "right"])
def test_and_as_an_act_where_it_is_one_to_the_same_side(side):
    logical, ids = claimed(
        {"id": "over", "participant": "van", "kind": "change_lane", "side": side}
    )
    (van,) = (drive for drive in logical.drives if drive.participant == "van")
    assert "act.over" in ids
    assert ("maneuver.lane_change.van" in ids) is (van.changes_to not in {None, side})
