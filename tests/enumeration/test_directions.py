"""Who may enter where, as the road has it."""

import pytest

from scegen.enumeration import enumerate_scenarios
from scegen.errors import InfeasibleError

EGO = {"id": "ego", "role": "ego"}


def listed(functional):
    return enumerate_scenarios(functional).scenarios


def test_everybody_goes_one_way(describe):
    people = [EGO, {"id": "a"}, {"id": "b", "approaches": ["behind"]}]
    functional = describe("straight", 2, people, carriageway="one_way")
    assert {(d.entry, d.exit) for s in listed(functional) for d in s.drives} == {(0, 1)}


def test_nobody_comes_the_other_way_of_a_one_way_road(describe):
    towards = {"id": "car", "approaches": ["opposite"]}
    with pytest.raises(InfeasibleError, match="car comes the other way of a one-way road"):
        listed(describe("straight", 2, [EGO, towards], carriageway="one_way"))


def test_a_bend_has_two_sides_unless_one_is_said(describe):
    towards = {"id": "car", "approaches": ["opposite"]}
    plain = describe("straight", 2, [EGO, towards])
    either = describe("straight", 2, [EGO, towards], bend={})
    left = describe("straight", 2, [EGO, towards], bend={"side": "left"})
    assert [len(listed(f)) for f in (plain, either, left)] == [1, 2, 1]
    assert {s.assignment("ego").entry for s in listed(left)} == {0}


def test_the_ego_enters_where_the_bend_leads_to_its_side(describe):
    with pytest.raises(InfeasibleError, match="from arm 0 only"):
        listed(describe("straight", 2, [EGO | {"entries": [1]}], bend={"side": "left"}))
