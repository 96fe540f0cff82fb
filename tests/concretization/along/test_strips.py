"""Who is on a strip beside the lanes is there, in the claims and in the road that is written."""

import pytest
from pydantic import ValidationError
from saying import made, missed, person, said

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.motion.paths import build_paths
from scegen.road import build_network
from scegen.road.model import LaneType

AHEAD = {"approaches": ["ahead"], "maneuvers": ["straight"]}
RIGHT = {"approaches": ["right"], "maneuvers": ["straight"]}
WAITS = {"approaches": ["right"], "maneuvers": ["stay"]}
PARKED = {"parked": True, "approaches": ["ahead"], "maneuvers": ["stay"]}


def beside(strip, kind, where, also=(), road="straight"):
    """One on a strip of the road that the ego drives."""
    ego = person("ego", speed=50, maneuvers=["straight"])
    junction = {"strips": [strip, *also]}
    return said(road, ego, person("x", kind, strip=strip, **where), junction=junction)


CASES = {
    "rides": (beside("cycle_lane", "bicycle", AHEAD), LaneType.BIKING),
    "rides beside bays": (beside("cycle_lane", "bicycle", AHEAD, ["parking"]), LaneType.BIKING),
    "walks": (beside("pavement", "pedestrian", RIGHT), LaneType.SIDEWALK),
    "walks beyond a cycle lane": (
        beside("pavement", "pedestrian", RIGHT, ["cycle_lane"]),
        LaneType.SIDEWALK,
    ),
    "waits": (beside("pavement", "pedestrian", WAITS), LaneType.SIDEWALK),
    "drives on the shoulder": (beside("hard_shoulder", "car", AHEAD), LaneType.SHOULDER),
    "stands at a stop": (beside("bus_stop", "bus", PARKED), LaneType.PARKING),
    "blocks the cycle lane": (beside("cycle_lane", "van", PARKED), LaneType.BIKING),
}


@pytest.mark.parametrize("case", CASES)
def test_who_is_on_a_strip_is_on_its_lane_and_everything_said_holds(case):
    functional, kind = CASES[case]
    for logical in enumerate_scenarios(functional).scenarios:
        concrete = concretize(functional, logical)
        assert not missed(functional, concrete, logical)
        network = build_network(concrete.road)
        start = build_paths(concrete, network)["x"].spans[0]
        found = network.road(start.road).lane(start.lane).type
        # Who walks against the traffic is told from the lane of those who come towards it.
        against = concrete.participant("x").motion.type == "drive" and (
            concrete.participant("x").motion.entry_lane == 0
        )
        assert found is (LaneType.DRIVING if against else kind)


def test_a_claim_of_a_strip_fails_off_it():
    functional, _ = CASES["rides"]
    concrete = concretize(functional, enumerate_scenarios(functional).scenarios[0])
    rider = concrete.participant("x")
    aside = rider.model_copy(update={"motion": rider.motion.model_copy(update={"offset_m": 1.2})})
    people = tuple(aside if p.id == "x" else p for p in concrete.participants)
    off = concrete.model_copy(update={"participants": people})
    assert "strip.x" in missed(functional, off)


@pytest.mark.parametrize(
    ("road", "strips", "told"),
    [
        ("four_way", ["cycle_lane"], "only for a road without"),
        ("straight", ["hard_shoulder", "cycle_lane"], "not both"),
        ("straight", ["pavement"], "not one of junction.strips"),
    ],
)
def test_a_strip_that_cannot_be_is_refused(road, strips, told):
    ego = person("ego", maneuvers=["straight"])
    rider = person("x", "bicycle", strip="cycle_lane", **AHEAD)
    with pytest.raises(ValidationError, match=told):
        said(road, ego, rider, junction={"strips": strips})


@pytest.mark.parametrize("keeps", ["left", "right"])
@pytest.mark.parametrize("swerves", [False, True])
def test_who_rides_on_a_strip_goes_round_one_that_stands_there(keeps, swerves):
    functional = said(
        "straight",
        person("ego", speed=45, maneuvers=["straight"]),
        person("van", "van", strip="cycle_lane", **PARKED),
        person("x", "bicycle", strip="cycle_lane", approaches=["ahead"], maneuvers=["overtake"]),
        junction={"strips": ["cycle_lane"], "driving_side": keeps},
        relations=[{"participant": "van", "reference": "x", "approaches": ["ahead"]}],
        hazards=[{"kind": "swerving", "by": ["x"], "to": ["ego"]}] if swerves else [],
    )
    concrete = made(functional).concrete
    assert not missed(functional, concrete)
    lanes = [change.lane_after for change in concrete.participant("x").motion.lane_changes]
    assert lanes == [1, concrete.participant("x").motion.entry_lane]
