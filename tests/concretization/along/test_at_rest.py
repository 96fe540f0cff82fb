"""Who is said to come to rest so far from another does so, and is judged by where it stands."""

from __future__ import annotations

import pytest
from gaps import gap_m
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from pydantic import ValidationError
from roads import AHEAD, CROSS, STAY, ego, kmh, one, road
from told import act, apart

from scegen.concretization import concretize
from scegen.concretization.along.compose import lay
from scegen.concretization.along.reactions import traffic_of
from scegen.concretization.along.telling import story_of
from scegen.concretization.traffic import contacts
from scegen.criticality import raise_criticality
from scegen.enumeration import enumerate_scenarios
from scegen.scenario.spacings import Measure, Spacing

LONG_S = 60.0


def at_rest(name, other, value, moment):
    """A gap once who does the act has come to rest."""
    return {**apart(name, other, "gap_m", value, moment), "since": "end"}


def stopping(gap, speed=50.0, **amounts):
    """The ego stops so far behind a car that stands."""
    return road(
        [ego(speed), one("lead", "car", AHEAD, STAY)],
        acts=[act("halts", "ego", "stop", **amounts)],
        spacings=[at_rest("ego", "lead", gap, "halts")],
    )


@given(st.floats(20.0, 110.0), st.floats(1.0, 12.0), st.sampled_from([None, 3.0, 5.0]))
@settings(max_examples=30)
def test_it_stops_so_far_behind_one_that_stands(speed, gap, rate):
    said = stopping(gap, speed, **({} if rate is None else {"rate_mps2": rate}))
    story = story_of(said, enumerate_scenarios(said).scenarios[0])
    lay(story)
    assert story.ego.speed_at_mps(LONG_S) == 0.0
    assert gap_m(story.ego, story.runners["lead"], LONG_S) == pytest.approx(gap, abs=0.5)


@given(st.floats(30.0, 100.0), st.floats(1.5, 8.0), st.floats(2.0, 6.0))
@settings(max_examples=30)
def test_it_stops_so_far_behind_one_that_stops(speed, gap, rate):
    said = road(
        [ego(speed), one("lead", "car", AHEAD, speed=speed)],
        acts=[
            act("brakes", "lead", "brake", rate_mps2=rate, target_speed_mps=kmh(0)),
            act("halts", "ego", "stop"),
        ],
        spacings=[at_rest("ego", "lead", gap, "halts")],
    )
    story = story_of(said, enumerate_scenarios(said).scenarios[0])
    lay(story)
    assume(not list(contacts(traffic_of(story))))
    assert gap_m(story.ego, story.runners["lead"], LONG_S) == pytest.approx(gap, abs=0.5)


def claims_of(functional, concrete):
    """What holds of what is said, by claim."""
    proof = raise_criticality(functional, concrete, target="avoided", seed=0).proof
    return {claim.id: claim for claim in proof.claims}


@pytest.mark.parametrize("person", [("car", AHEAD, STAY), ("pedestrian", (), CROSS)])
def test_the_claim_is_of_where_it_stands_and_no_other_place(person):
    kind, *how = person
    said = road(
        [ego(40), one("other", kind, *how)],
        acts=[act("halts", "ego", "stop")],
        spacings=[at_rest("ego", "other", 3.0, "halts")],
    )
    concrete = concretize(said, enumerate_scenarios(said).scenarios[0], seed=0)
    assert claims_of(said, concrete)["spacing.0"].holds
    (spacing,) = said.spacings
    begins = said.model_copy(update={"spacings": (spacing.model_copy(update={"since": "begin"}),)})
    assert not claims_of(begins, concrete)["spacing.0"].holds


def test_rest_is_that_of_an_act():
    with pytest.raises(ValidationError, match="is of an act"):
        Spacing(
            participant="ego",
            reference="car_1",
            measure=Measure.GAP_M,
            value=kmh(3.0),
            since="end",
        )
