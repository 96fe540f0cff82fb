"""What is said of distances along the road holds exactly once places are given."""

from __future__ import annotations

import numpy as np
import pytest
from gaps import gap_m
from roads import AHEAD, BEHIND, LEFT_LANE, SCENARIOS, STAY, ego, one, road
from told import act, apart

from scegen.concretization.along.compose import lay
from scegen.concretization.along.performing import perform_known
from scegen.concretization.along.placing import place_all
from scegen.concretization.along.telling import story_of
from scegen.concretization.boxes import missing_m
from scegen.enumeration import enumerate_scenarios
from scegen.scenario.acts import WhenMeasure
from scegen.scenario.spacings import CONTACT, LENGTHWISE, START


def story(functional):
    return story_of(functional, enumerate_scenarios(functional).scenarios[0])


@pytest.mark.parametrize("name", sorted(SCENARIOS))
def test_every_distance_along_the_road_holds_when_it_is_said_to(name):
    told = story(SCENARIOS[name])
    lay(told)
    runners = told.runners
    said = [
        (s.measure, s.participant, s.reference, s.value.middle, s.at)
        for s in told.functional.spacings
        if s.at != CONTACT and s.since == "begin"
    ]
    for done in told.functional.acts:
        when = done.when
        if isinstance(when, WhenMeasure):
            said.append(
                (when.measure, when.participant, when.reference, when.value.middle, done.id)
            )
    for measure, who, other, value, moment in said:
        if measure not in LENGTHWISE or not {who, other} <= runners.keys():
            continue
        at = np.array([0.0 if moment == START else told.begins_s[moment]])
        tracks = runners[other].track(at), runners[who].track(at)
        # It has the value if it is not reached by a fiftieth less, and is by a fiftieth more.
        less, more = (missing_m(measure, share * value, *tracks) for share in (0.98, 1.02))
        assert less >= 0.0 >= more, (measure, who, other)


def test_distances_in_a_chain_hold_one_after_the_other():
    told = story(
        road(
            [
                ego(80),
                one("near", "car", AHEAD, speed=80),
                one("far", "truck", AHEAD, speed=80),
                one("tail", "van", BEHIND, speed=80),
            ],
            spacings=[
                apart("far", "near", "gap_m", 40.0),
                apart("ego", "near", "headway_s", 1.5),
                apart("tail", "ego", "gap_m", 12.0),
            ],
            relations=[{"participant": "far", "reference": "near", "approaches": ["ahead"]}],
        )
    )
    perform_known(told, told.acts, placed=False)
    place_all(told)
    at = told.runners
    assert at["tail"].at_m < at["ego"].at_m < at["near"].at_m < at["far"].at_m
    assert gap_m(at["far"], at["near"], 0.0) == pytest.approx(40.0)
    assert gap_m(at["tail"], at["ego"], 0.0) == pytest.approx(12.0)
    assert gap_m(at["ego"], at["near"], 0.0) == pytest.approx(1.5 * 80 / 3.6)


@pytest.mark.parametrize("wider", [1.0, 2.0])
def test_what_is_usual_is_stretched_and_what_is_said_is_not(wider):
    people = [ego(60), one("near", "car", AHEAD, speed=60), one("tail", "car", BEHIND, speed=60)]
    told = story(road(people, spacings=[apart("ego", "near", "gap_m", 25.0)]))
    place_all(told, wider=wider)
    assert gap_m(told.ego, told.runners["near"], 0.0) == pytest.approx(25.0)
    tail = gap_m(told.ego, told.runners["tail"], 0.0)
    assert tail == pytest.approx(wider * 1.8 * 60 / 3.6)


def test_who_cuts_in_is_ahead_by_then_wherever_it_comes_from():
    people = [ego(80), one("fast", "car", ["behind", *LEFT_LANE], speed=100)]
    changes = act("changes", "fast", "change_lane", side="right", into="ego")
    gap = apart("fast", "ego", "gap_m", 10.0, "changes")
    told = story(road(people, acts=[changes], hazards=[("cut_in", "fast", "ego")], spacings=[gap]))
    perform_known(told, told.acts, placed=False)
    place_all(told)
    fast, moment = told.runners["fast"], told.begins_s["changes"]
    assert gap_m(fast, told.ego, moment) == pytest.approx(10.0)
    assert fast.at_m < told.ego.at_m


def test_who_comes_over_is_ahead_of_the_one_into_whose_lane_it_comes():
    people = [ego(80, []), one("fast", "car", LEFT_LANE, speed=100)]
    told = story(road(people, acts=[act("changes", "ego", "change_lane", side="left")]))
    lay(told)
    moment = told.begins_s["changes"]
    assert told.ego.x_m(moment) > told.runners["fast"].x_m(moment)


@pytest.mark.parametrize("lanes", [([1], [2]), ([2], [1])])
def test_two_who_stand_side_by_side_stand_level(lanes):
    own, other = lanes
    people = [
        ego(60),
        one("here", "van", AHEAD, STAY, lanes=own),
        one("there", "car", [], STAY, lanes=other),
    ]
    beside = {"participant": "there", "reference": "here", "approaches": ["adjacent"]}
    told = story(road(people, relations=[beside]))
    lay(told)
    here, there = told.runners["here"], told.runners["there"]
    assert here.lane != there.lane
    assert here.middle_m(0.0) == pytest.approx(there.middle_m(0.0))


def test_one_who_drives_before_the_ego_comes_upon_who_stands_there():
    people = [
        ego(60),
        one("leads", "car", AHEAD, speed=60),
        one("stands", "truck", AHEAD, STAY),
    ]
    told = story(road(people, acts=[act("dodges", "leads", "swerve", side="left")]))
    lay(told)
    assert gap_m(told.runners["leads"], told.ego, 0.0) > 10.0
    assert gap_m(told.runners["stands"], told.runners["leads"], 0.0) > 10.0
    assert told.runners["stands"].at_m > told.runners["leads"].at_m
