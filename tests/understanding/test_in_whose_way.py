"""In whose way somebody comes, who stays at the kerb, and what tells of no danger."""

import pytest

from scegen.pipeline.raising import chosen_target
from scegen.scenario.acts import ActKind
from scegen.scenario.roadway import Strip
from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding import read


def crossing(scenario):
    kinds = {HazardKind.CROSSING_PEDESTRIAN, HazardKind.CROSSING_ANIMAL}
    return next(h for h in scenario.hazards if h.kind in kinds)


@pytest.mark.parametrize(
    ("text", "who"),
    [
        ("A woman strides across in front of the ego.", "ego"),
        ("A goat dashes out in front of the ego.", "ego"),
        (
            "A man walks over the road in front of a van, the ego follows the van.",
            "van_1",
        ),
    ],
)
def test_who_comes_in_front_of_somebody_is_in_that_ones_way(text, who):
    scenario = read(text)
    assert crossing(scenario).to == (who,)
    assert not any(u.text == "in front of" for u in scenario.unsupported)


@pytest.mark.parametrize(
    "text",
    [
        "The ego overtakes a van and a girl runs out in front of the van.",
        "A girl runs out in front of a parked van as the ego comes along.",
        "A girl runs out from in front of a van as the ego comes along.",
    ],
)
def test_who_stands_or_is_overtaken_is_not_the_one_who_is_met(text):
    assert not {"van_1", "parked_van_1"} & set(crossing(read(text)).to)


def test_words_in_whose_way_one_pulls_out_are_not_left_over():
    scenario = read("A van parked at the kerb pulls out in front of a bus.")
    assert HazardKind.FAILURE_TO_YIELD in {h.kind for h in scenario.hazards}
    assert not scenario.unsupported


@pytest.mark.parametrize(
    "text",
    [
        "A girl runs towards the street but stops at the kerb.",
        "A woman walks towards the road and waits at the roadside as the ego passes.",
        "A child walks up to the kerb from the left and stops there.",
        "Someone on foot comes up to the edge of the road at 4 km/h and halts there.",
    ],
)
def test_who_walks_up_to_the_kerb_stops_there(text):
    scenario = read(text)
    (act,) = scenario.acts
    assert (act.participant, act.kind) == ("pedestrian_1", ActKind.CROSS)
    assert act.distance_m is not None
    assert act.distance_m.high == 0.0
    assert not scenario.hazards


def test_who_waits_at_the_kerb_stands_there():
    scenario = read("A man waits at the kerb.")
    person = scenario.participant("pedestrian_1")
    assert person.maneuvers == {Maneuver.STAY}
    assert person.strip is Strip.PAVEMENT
    assert not scenario.hazards


@pytest.mark.parametrize(
    "text",
    [
        "A girl walks towards the street, stops at the kerb and then runs across.",
        "A girl crosses the street and stops at the kerb.",
        "A girl runs towards the street.",
    ],
)
def test_who_has_crossed_or_goes_on_crosses(text):
    scenario = read(text)
    assert scenario.participant("pedestrian_1").maneuvers == {Maneuver.CROSS}
    assert crossing(scenario).by == ("pedestrian_1",)


@pytest.mark.parametrize(
    ("text", "target"),
    [
        ("The lorry in front accelerates and leaves the ego behind.", "avoided"),
        ("A coach is parked on the hard shoulder of the motorway as the ego drives by.", "avoided"),
        ("The lorry in front accelerates and then brakes hard.", "near-miss"),
        ("The lorry behind accelerates.", "near-miss"),
        ("The lorry in front accelerates and the ego hits it.", "collision"),
        ("A coach is parked in a bay and opens its door as the ego drives by.", "near-miss"),
    ],
)
def test_no_near_miss_is_looked_for_where_no_danger_is_told(text, target):
    assert chosen_target(None, read(text)) == target


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("At a crossroads a van from the right hits the ego on its right side.", "right"),
        ("At a crossroads the ego is hit on its left side by a van from the left.", "left"),
        ("At a crossroads a van from the left hits the ego in its left side.", "left"),
    ],
)
def test_the_side_on_which_somebody_is_hit_is_that_ones(text, side):
    outcome = read(text).outcome
    assert outcome is not None
    assert outcome.struck == side


@pytest.mark.parametrize(
    "text",
    [
        "The ego is parked at the roadside and pulls out as a van comes up from behind.",
        "The ego pulls out from the kerb as a van comes up from behind.",
    ],
)
def test_an_ego_that_pulls_out_stands_in_a_bay_at_first(text):
    found = read(text)
    assert found.ego.strip == Strip.PARKING
    assert not found.unsupported


def test_an_ego_that_stays_parked_is_said_to_drive():
    found = read("The ego is parked at the roadside and a van scrapes past it.")
    assert any("drives from the start" in u.instead for u in found.unsupported)


@pytest.mark.parametrize(
    ("text", "strip", "target"),
    [
        ("A woman walks along the verge ahead of the ego.", Strip.PAVEMENT, "avoided"),
        ("A woman walks along the edge of the road ahead of the ego.", Strip.PAVEMENT, "avoided"),
        ("A woman stands at the side of the road.", Strip.PAVEMENT, "avoided"),
        ("A woman walks along the lane ahead of the ego.", None, "near-miss"),
        ("The ego hits a woman who walks along the edge of the road.", None, "collision"),
        ("The ego passes a woman on the edge of the road 1 m to its side.", None, "avoided"),
    ],
)
def test_who_keeps_to_the_edge_is_beside_the_lanes_unless_somebody_comes_near(text, strip, target):
    scenario = read(text)
    assert scenario.participant("pedestrian_1").strip is strip
    assert chosen_target(None, scenario) == target
