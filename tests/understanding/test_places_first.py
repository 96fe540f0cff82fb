"""Words of place before the one they place, and places named again."""

import pytest

from scegen.scenario.vocabulary import Approach
from scegen.understanding import read


def where(text):
    """Kind -> where it comes from, of everybody but the ego."""
    scenario = read(text)
    return {p.kind.value: set(p.approaches) for p in scenario.participants if p.role != "ego"}


@pytest.mark.parametrize(
    ("text", "kind", "approach"),
    [
        ("Behind the ego there is a lorry.", "truck", Approach.BEHIND),
        ("Behind the ego is a lorry.", "truck", Approach.BEHIND),
        ("In front of me stands a bus.", "bus", Approach.AHEAD),
        ("From the left comes a tram and the ego brakes.", "bus", Approach.LEFT),
        ("To the right of the ego rides a cyclist.", "bicycle", Approach.ADJACENT),
        ("In the oncoming lane a van approaches the ego.", "van", Approach.OPPOSITE),
        ("On the right, there is a parked van and the ego passes.", "van", Approach.RIGHT),
        ("The ego waits and from the right comes a bus.", "bus", Approach.RIGHT),
        ("The ego turns left and behind it, a van brakes.", "van", Approach.BEHIND),
        ("The ego moves into the next lane, where a bus drives.", "bus", Approach.ADJACENT),
        ("The ego changes to the left lane; a van in that lane brakes.", "van", Approach.ADJACENT),
        ("The ego passes a bus that is on the left.", "bus", Approach.ADJACENT),
        ("A van reverses out of a driveway on the left towards the ego.", "van", Approach.LEFT),
    ],
)
def test_who_stands_after_the_phrase_is_placed_by_it(text, kind, approach):
    sides = {Approach.LEFT, Approach.RIGHT}  # of the lane beside
    found = where(text)[kind]
    assert (found - sides if approach is Approach.ADJACENT else found) == {approach}


def test_the_words_are_the_evidence():
    scenario = read("Behind the ego there is a lorry.")
    held = [e.text for e in scenario.evidence if e.field == "participants.truck_1.approaches"]
    assert held == ["Behind the ego"]
    assert scenario.unsupported == ()


def test_each_clause_has_its_own_phrase():
    text = "From the right comes a bus, and from the left two vans; my car waits at the stop sign."
    assert where(text) == {"bus": {Approach.RIGHT}, "van": {Approach.LEFT}}


def test_a_joined_subject_stands_at_the_same_place():
    assert where("Behind the ego are a bus and a van.") == {
        "bus": {Approach.BEHIND},
        "van": {Approach.BEHIND},
    }


def test_a_hidden_one_is_not_placed_behind_the_ego():
    scenario = read("From behind a parked van, a child runs in front of the ego.")
    assert {h.kind for h in scenario.hazards} == {"occlusion", "crossing_pedestrian"}


def test_a_list_of_sides_is_shared_out():
    scenario = read("Two vans from the left and the right stop for the ego at a junction.")
    vans = [set(p.approaches) for p in scenario.participants if p.kind == "van"]
    assert vans == [{Approach.LEFT}, {Approach.RIGHT}]


def test_as_many_vehicles_as_sides_named():
    scenario = read("Cars coming from the north, the east and the south reach a crossroads.")
    assert len(scenario.participants) == 3
    seen = [set(p.approaches) for p in scenario.participants if p.role != "ego"]
    assert seen == [{Approach.LEFT}, {Approach.OPPOSITE}]


def test_nouns_after_a_side_begin_anew():
    scenario = read("From the left two vans come; the ego waits.")
    assert [p.kind.value for p in scenario.participants].count("van") == 2


def test_a_single_vehicle_from_a_side_is_seen_by_somebody():
    scenario = read("A bus comes from the left.")
    assert scenario.ego.kind == "car"
    assert where("A bus comes from the left.") == {"bus": {Approach.LEFT}}


@pytest.mark.parametrize(
    ("side", "driving", "expected"),
    [
        ("nearside", "", Approach.RIGHT),
        ("farside", "", Approach.LEFT),
        ("nearside", " Traffic drives on the left.", Approach.LEFT),
        ("farside", " Traffic drives on the left.", Approach.RIGHT),
    ],
)
def test_near_and_far_depend_on_the_driving_side(side, driving, expected):
    text = f"A child crosses from the {side} in front of the ego.{driving}"
    assert where(text)["pedestrian"] == {expected}
