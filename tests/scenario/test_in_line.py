"""Who is ahead of whom at an act, as dangers, acts and words have it."""

import pytest
from saying import person, said

from scegen.scenario.in_line import is_said_ahead

CHANGES = {"kind": "change_lane", "into": "ego"}
BRAKES = {"kind": "brake"}
BY = {"by": ["car"], "to": ["ego"]}


def told(approach, *acts, hazards=(), **fields):
    car = person("car", approaches=[approach], **fields)
    doings = [{"id": f"act_{n}", "participant": "car", **act} for n, act in enumerate(acts)]
    dangers = [{"kind": kind, **BY} for kind in hazards]
    return said("straight", person("ego"), car, acts=doings, hazards=dangers)


@pytest.mark.parametrize(
    ("functional", "act", "since", "expected"),
    [
        (told("behind", CHANGES, hazards=["cut_in"]), 0, "begin", True),
        (told("ahead", CHANGES), 0, "begin", True),
        (told("ahead", CHANGES), 0, "end", None),
        (told("ahead", CHANGES, BRAKES), 1, "begin", None),
        (told("ahead", BRAKES, CHANGES, maneuvers=["lane_change"]), 0, "begin", True),
        (told("ahead", BRAKES), 0, "begin", True),
        (told("behind", BRAKES), 0, "begin", False),
        (told("behind", BRAKES, maneuvers=["overtake"]), 0, "begin", None),
        (told("adjacent", BRAKES, hazards=["hard_braking"]), 0, "begin", True),
        (told("adjacent", BRAKES, hazards=["delayed_braking"]), 0, "begin", False),
        (told("behind", {"kind": "overtake", "into": "ego"}), 0, "begin", False),
        (told("behind", {"kind": "overtake", "into": "ego"}), 0, "end", True),
        (told("adjacent", {"kind": "change_lane"}, CHANGES, hazards=["cut_in"]), 0, "begin", None),
        (told("adjacent", {"kind": "change_lane"}, CHANGES, hazards=["cut_in"]), 1, "end", True),
    ],
)
def test_who_is_ahead_at_an_act(functional, act, since, expected):
    who = functional.hazards
    assert is_said_ahead(functional, who, "car", "ego", f"act_{act}", since) is expected
    turned = is_said_ahead(functional, who, "ego", "car", f"act_{act}", since)
    assert turned is (None if expected is None else not expected)


def test_nothing_tells_at_the_start():
    assert is_said_ahead(told("ahead"), (), "car", "ego", "start") is None
