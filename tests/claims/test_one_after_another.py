"""What comes after another act: at once, so much later, or some time later."""

import pytest
from saying import made, missed, person, said
from told import act, after

from scegen.claims import claims_of
from scegen.enumeration import enumerate_scenarios
from scegen.understanding import read

BEFORE = "act.moves.when"


def story(delay, since="end"):
    """The car slows for some 3 s, and 5 s later changes to the left lane."""
    return said(
        "straight",
        person("ego", maneuvers=["straight"], speed=80),
        person("car", approaches=["ahead"], maneuvers=["straight", "lane_change"], speed=80),
        acts=[
            act("slows", "car", "brake", target_speed_mps=12, rate_mps2=3),
            act("moves", "car", "change_lane", side="left", when=after("slows", delay, since)),
        ],
    )


def follows(judged, laid):
    """Whether what is laid one way keeps the claim of what is told another."""
    logical = enumerate_scenarios(judged).scenarios[0]
    return BEFORE not in missed(judged, made(laid).concrete, logical)


@pytest.mark.parametrize(
    ("laid", "judged", "holds"),
    [
        (5.0, 5.0, True),
        (5.0, None, True),
        (5.0, 0.0, False),
        (0.0, 0.0, True),
        (0.0, None, True),
        (None, 0.0, True),
        (None, None, True),
    ],
)
def test_some_time_later_is_an_order_and_at_once_a_moment(laid, judged, holds):
    assert follows(story(judged), story(laid)) is holds


@pytest.mark.parametrize("delay", [None, 0.0])
def test_what_begins_before_it_is_no_follower(delay):
    """Laid 0.5 s after the braking has begun, which is long before it has ended."""
    early = story(0.5, "begin")
    assert not follows(story(delay), early)
    assert follows(story(delay, "begin"), early)


@pytest.mark.parametrize(
    ("delay", "words"),
    [(None, "some time after"), (0.0, "right after"), (2.0, "2 s after")],
)
def test_the_statement_says_how_much_later(delay, words):
    functional = story(delay)
    logical = enumerate_scenarios(functional).scenarios[0]
    (claim,) = (c for c in claims_of(functional, logical) if c.id == BEFORE)
    assert f"{words} it has braked" in claim.statement


def test_what_lies_in_the_way_is_passed_on_the_side_that_is_said():
    text = "The car in front swerves to the left around a crate, and then accelerates to 70 km/h."
    functional = read(f"{text} The ego follows it 40 m behind at 60 km/h.")
    assert missed(functional, made(functional).concrete) == set()
