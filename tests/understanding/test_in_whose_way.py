"""In whose way somebody comes, who stays at the kerb, and what tells of no danger."""

import pytest

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


@pytest.mark.parametrize(
    ("text", "strip"),
    [
        ("The ego is parked at the roadside and a van scrapes past it.", Strip.PARKING),
        ("Our car stands on the hard shoulder as a coach goes by.", Strip.HARD_SHOULDER),
    ],
)
def test_an_ego_that_stays_beside_the_lanes_stands_there(text, strip):
    found = read(text)
    assert (found.ego.strip, found.ego.maneuvers) == (strip, {Maneuver.STAY})
    assert not found.unsupported


@pytest.mark.parametrize(
    ("text", "strip"),
    [
        ("A woman walks along the verge ahead of the ego.", Strip.PAVEMENT),
        ("A woman walks along the edge of the road ahead of the ego.", Strip.PAVEMENT),
        ("A woman stands at the side of the road.", Strip.PAVEMENT),
        ("A woman walks along the lane ahead of the ego.", None),
        ("The ego hits a woman who walks along the edge of the road.", None),
        ("The ego passes a woman on the edge of the road 1 m to its side.", None),
    ],
)
def test_who_keeps_to_the_edge_is_beside_the_lanes_unless_somebody_comes_near(text, strip):
    scenario = read(text)
    assert scenario.participant("pedestrian_1").strip is strip
