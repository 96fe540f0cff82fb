"""Who comes up behind somebody brakes as late as leaves a little room, and not before it can."""

from __future__ import annotations

import pytest
from gaps import gap_m
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from roads import AHEAD, BEHIND, STAY, ego, kmh, one, road
from told import act, apart, as_soon_as

from scegen.concretization.along.compose import lay
from scegen.concretization.along.reactions import REACTION_S, traffic_of
from scegen.concretization.along.telling import story_of
from scegen.concretization.traffic import contacts
from scegen.enumeration import enumerate_scenarios


def laid(functional):
    story = story_of(functional, enumerate_scenarios(functional).scenarios[0])
    lay(story)
    return story


def least_m(story, first, second):
    one_, two = story.runners[first], story.runners[second]
    return min(gap_m(one_, two, n * 0.05) for n in range(600))


@given(
    st.floats(20.0, 130.0), st.floats(0.6, 3.0), st.floats(2.0, 8.0), st.sampled_from([0.0, 0.5])
)
@settings(max_examples=40)
def test_the_latest_braking_leaves_a_little_room(speed, headway, rate, share):
    said = road(
        [ego(speed), one("lead", "car", AHEAD, speed=speed)],
        acts=[act("slows", "lead", "brake", rate_mps2=rate, target_speed_mps=kmh(share * speed))],
        spacings=[apart("ego", "lead", "headway_s", headway, "slows")],
    )
    story = laid(said)
    assume(not list(contacts(traffic_of(story))))  # too close behind one who brakes too hard
    ego_ = story.ego
    body = ego_.body
    if not ego_.steps:
        return  # no need: the lead drives on, far enough ahead
    (step,) = ego_.steps
    assert step.reacts_to == "lead"
    assert step.begins_s >= story.begins_s["slows"] + REACTION_S - 1e-6
    assert step.rate_mps2 <= body.max_deceleration_mps2
    assert 0.3 < least_m(story, "ego", "lead") < 1.2


def test_a_queue_of_followers_stops_one_behind_the_other():
    people = [
        ego(60),
        one("lead", "car", AHEAD, speed=60),
        one("tail", "truck", BEHIND, speed=60),
    ]
    story = laid(road(people, acts=[act("halts", "lead", "stop", rate_mps2=5.0)]))
    assert not list(contacts(traffic_of(story)))
    late = 40.0
    gaps = [gap_m(story.ego, story.runners[name], late) for name in ("lead", "tail")]
    assert all(0.3 < gap < 1.5 for gap in gaps), gaps
    assert all(r.speed_at_mps(late) == 0.0 for r in story.runners.values())


def test_nobody_brakes_for_one_who_is_to_be_hit():
    people = [ego(50), one("wreck", "car", AHEAD, STAY)]
    outcome = {"kind": "collision", "between": ["ego", "wreck"]}
    story = laid(road(people, outcome=outcome))
    assert story.ego.steps == []
    assert len(list(contacts(traffic_of(story)))) == 1


def test_nobody_brakes_where_there_is_no_need():
    story = laid(road([ego(50), one("lead", "car", AHEAD, speed=50)]))
    assert all(runner.steps == [] for runner in story.runners.values())


@pytest.mark.parametrize("rate", [4.0, 7.0])
def test_the_rate_that_is_said_is_the_rate_of_the_reaction(rate):
    people = [ego(50), one("wreck", "car", AHEAD, STAY)]
    acts = [act("brakes", "ego", "brake", rate_mps2=rate, target_speed_mps=0.0)]
    story = laid(road(people, acts=acts))
    (step,) = story.ego.steps
    assert (step.rate_mps2, step.act) == (rate, "brakes")
    assert 0.3 < gap_m(story.ego, story.runners["wreck"], 60.0) < 1.5


@pytest.mark.parametrize(("other", "ends"), [(80, 80 - 28.8), (60, 60), (None, 0)])
def test_who_brakes_behind_one_that_is_no_slower_falls_back_and_does_not_stop(other, ends):
    lead = [] if other is None else [one("lead", "car", AHEAD, speed=other)]
    story = laid(road([ego(80), *lead], acts=[act("b", "ego", "brake")]))
    (step,) = story.ego.steps
    assert step.target_mps * 3.6 == pytest.approx(ends)


@pytest.mark.parametrize("gap", [60, 40, 25, 15])
def test_who_brakes_where_it_is_said_does_so_as_hard_as_it_needs(gap):
    """From 50 km/h, however far away it begins: it ends near what stands there."""
    said = road(
        [ego(50), one("van", "van", AHEAD, maneuvers=STAY)],
        acts=[act("b", "ego", "brake", when=as_soon_as("ego", "van", "gap_m", gap))],
    )
    story = laid(said)
    (step,) = story.ego.steps
    assert step.rate_mps2 == pytest.approx((50 / 3.6) ** 2 / 2 / gap, rel=0.1)
    assert 0.3 < least_m(story, "ego", "van") < 1.2


def test_who_has_been_passed_closely_brakes_no_sooner_than_it_has_to():
    people = [ego(70), one("hurries", "car", BEHIND, ["overtake"], speed=90)]
    acts = [
        act("passes", "hurries", "overtake"),
        act("returns", "hurries", "change_lane", side="right", into="ego"),
        act("halts", "hurries", "brake", rate_mps2=5.0, when={"type": "after", "act": "returns"}),
    ]
    story = laid(road(people, acts=acts, hazards=[("overtaking", "hurries", "ego")]))
    (step,) = story.ego.steps
    assert step.begins_s > story.begins_s["halts"]
    assert not list(contacts(traffic_of(story)))
