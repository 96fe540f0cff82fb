"""Some of several alike: what they do is said of the group, and of nobody in it."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scegen.scenario.vocabulary import Maneuver
from scegen.understanding import read

LEFT, RIGHT, STRAIGHT = Maneuver.LEFT, Maneuver.RIGHT, Maneuver.STRAIGHT
_WORDS = {2: "Two", 3: "Three", 4: "Four", 5: "Five", 6: "Six", 7: "Seven", 8: "Eight", 9: "Nine"}


def _groups(text):
    scenario = read(text)
    members = {name for group in scenario.groups for name in group.members}
    bound = [p for p in scenario.participants if p.id in members and p.maneuvers]
    assert bound == []
    return [(len(g.members), g.number, set(g.maneuvers)) for g in scenario.groups]


@pytest.mark.parametrize(
    ("text", "groups"),
    [
        (
            "Six cars reach an intersection. Two of them turn left, one of them turns right.",
            [(6, 2, {LEFT}), (6, 1, {RIGHT})],
        ),
        (
            "Five cars meet at a junction. Two turn left, the others go straight.",
            [(5, 2, {LEFT}), (5, 3, {STRAIGHT})],
        ),
        ("Four cars meet at a crossroads; half of the cars turn left.", [(4, 2, {LEFT})]),
        ("Three cars, one of which turns left, reach a T-junction.", [(3, 1, {LEFT})]),
        (
            "Five vehicles wait at a crossroads with traffic lights: two lorries and three cars, "
            "one of the cars turning left.",
            [(3, 1, {LEFT})],
        ),
        (
            "The ego and three other cars meet at a junction; one of the other cars turns right.",
            [(3, 1, {RIGHT})],
        ),
    ],
)
def test_what_some_do_is_a_group(text, groups):
    assert _groups(text) == groups


@settings(max_examples=20)
@given(total=st.integers(3, 9), data=st.data())
def test_any_number_of_any(total, data):
    some = data.draw(st.integers(2, total - 1))
    way = data.draw(st.sampled_from(("left", "right")))
    text = f"{_WORDS[total]} cars meet at a crossroads. {_WORDS[some]} of them turn {way}."
    assert _groups(text) == [(total, some, {Maneuver(way)})]


def test_a_number_that_is_not_said_is_reported():
    scenario = read("Eight cars meet at a crossroads. Most of them turn left.")
    assert scenario.groups == ()
    assert all(not p.maneuvers for p in scenario.participants)
    assert "Most of them" in [u.text for u in scenario.unsupported]


def test_who_is_named_is_no_member_of_a_group():
    scenario = read("Four cars and a bus meet at a crossroads. The bus turns left.")
    assert scenario.groups == ()
    assert {p.id for p in scenario.participants if p.maneuvers} == {"bus_1"}


def test_where_some_come_from_does_not_bind_the_ego():
    scenario = read("Four cars meet at a crossroads; two of the four cars come from the left.")
    assert sum(bool(p.approaches) for p in scenario.participants) == 2
    assert not scenario.ego.approaches


def test_the_ego_is_none_of_those_who_come_towards_it():
    scenario = read("One of the two oncoming cars turns left in front of the ego.")
    ways = [(p.id, sorted(a.value for a in p.approaches)) for p in scenario.participants]
    assert ways == [("car_1", ["opposite"]), ("car_2", ["opposite"]), ("ego", [])]
