"""The functional level refuses what contradicts itself, and says which field."""

import pytest
from pydantic import ValidationError

from scegen.scenario.evidence import Evidence
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant, Relation
from scegen.scenario.junction import Junction


def scenario(**changes):
    fields = {
        "description": "Two cars meet.",
        "junction": Junction(kind="four_way", arms=4),
        "participants": (Participant(id="ego", role="ego"), Participant(id="car_1")),
    }
    return FunctionalScenario(**(fields | changes))


def test_the_ego_is_found():
    assert scenario().ego.id == "ego"


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"participants": (Participant(id="car_1"),)}, "exactly one participant"),
        (
            {"participants": (Participant(id="a", role="ego"), Participant(id="b", role="ego"))},
            "exactly one participant",
        ),
        (
            {"participants": (Participant(id="a", role="ego"), Participant(id="a"))},
            "two participants or objects are called 'a'",
        ),
        ({"hazards": (Hazard(kind="speeding", by=("ghost",)),)}, "unknown participant 'ghost'"),
        (
            {"relations": (Relation(participant="car_1", reference="ghost", approaches={"left"}),)},
            "unknown participant 'ghost'",
        ),
        (
            {"participants": (Participant(id="ego", role="ego", entries={7}),)},
            r"outside 0\.\.3",
        ),
        (
            {"participants": (Participant(id="ego", role="ego", circulating=True),)},
            "ego is circulating, but junction.kind is not roundabout",
        ),
        (
            {"participants": (Participant(id="ego", role="ego", crosses="entry"),)},
            "ego has `crosses`, but it does not cross",
        ),
    ],
)
def test_contradictions_are_refused(changes, words):
    with pytest.raises(ValidationError, match=words):
        scenario(**changes)


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"kind": "roundabout", "arms": 7}, "3 to 6 arms"),
        ({"kind": "t", "arms": 4}, "a t junction has 3 arms"),
        ({"kind": "t", "arms": 3, "arm_angles_deg": (0, 90)}, "2 angles for 3 arms"),
        ({"kind": "t", "arms": 3, "arm_angles_deg": (0, 270, 90)}, "must rise"),
        ({"kind": "t", "arms": 3, "lanes": (1, 1)}, "2 numbers for 3 arms"),
        ({"kind": "t", "arms": 3, "lanes": (1, 1, 9)}, "1, 2 or 3"),
        ({"kind": "t", "arms": 3, "crosswalks": {3}}, r"outside 0\.\.2"),
        ({"kind": "straight", "arms": 2, "crosswalks": {0, 1}}, "one crosswalk at most"),
        ({"kind": "straight", "arms": 2, "crosswalks": {0}, "auxiliary": "on_ramp"}, "not both"),
        ({"kind": "four_way", "arms": 4, "ring_lanes": 2}, "only for a roundabout"),
        ({"kind": "hexagon", "arms": 6}, "straight"),
    ],
)
def test_junctions_must_fit_their_kind(fields, words):
    with pytest.raises(ValidationError, match=words):
        Junction(**fields)


def test_who_is_parked_does_not_turn():
    with pytest.raises(ValidationError, match="car_1 is parked: its maneuvers are of lane_change"):
        Participant(id="car_1", parked=True, maneuvers={"left"})


def test_stated_fields_need_words_and_others_a_reason():
    with pytest.raises(ValidationError, match="names no words"):
        Evidence(field="junction.kind", source="stated")
    with pytest.raises(ValidationError, match="without a reason"):
        Evidence(field="junction.kind", source="default")


def test_those_who_cross_are_not_vehicles():
    people = (
        Participant(id="ego", role="ego"),
        Participant(id="pedestrian_1", kind="pedestrian", maneuvers={"cross"}),
        Participant(id="bicycle_1", kind="bicycle", maneuvers={"cross"}),
        Participant(id="bicycle_2", kind="bicycle", maneuvers={"left"}),
        Participant(id="parked_car_1", parked=True, maneuvers={"stay"}),
    )
    made = scenario(participants=people)
    assert [p.id for p in made.vehicles] == ["ego", "bicycle_2"]
    assert [p.id for p in made.crossers] == ["pedestrian_1", "bicycle_1"]
