"""Plans of lights: what they show when, and how long between two greens."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st
from saying import person, said

from scegen.enumeration import enumerate_scenarios
from scegen.motion.rules.intergreen import all_red_s, amber_s
from scegen.motion.rules.lights import green_phases, light_runners, must_obey
from scegen.road import build_network, plan_road
from scegen.scenario.junction import Junction
from scegen.scenario.signals import SignalGroup, SignalPlan, SignalState
from scegen.units import speed_mps


@given(
    cycle=st.floats(20, 90),
    starts=st.floats(0, 1),
    green=st.floats(0.1, 0.6),
    time_s=st.floats(0, 300),
)
def test_the_last_change_is_what_is_shown(cycle, starts, green, time_s):
    group = SignalGroup(id=1, arms={0}, green_from_s=starts * cycle, green_s=green * cycle)
    plan = SignalPlan(cycle_s=cycle, amber_s=3.0, groups=[group])
    changes = list(plan.changes(group, 300.0))
    assert [time for time, _ in changes] == sorted(time for time, _ in changes)
    near = min(abs(time - time_s) for time, _ in changes)
    last = [state for time, state in changes if time <= time_s][-1]
    assert near < 2e-3 or last is plan.state(group, time_s)


def test_green_goes_to_amber_to_red_to_green():
    group = SignalGroup(id=1, arms={0}, green_from_s=12.0, green_s=8.0)
    plan = SignalPlan(cycle_s=30.0, amber_s=3.0, groups=[group])
    shown = [state for _, state in plan.changes(group, 100.0)]
    order = [SignalState.GREEN, SignalState.AMBER, SignalState.RED]
    for before, after in pairwise(shown):
        assert after is order[(order.index(before) + 1) % 3]


@given(time_s=st.floats(0, 300))
def test_lights_that_do_not_work_are_dark_all_the_time(time_s):
    group = SignalGroup(id=1, arms={0}, green_from_s=12.0, green_s=8.0)
    plan = SignalPlan(cycle_s=30.0, amber_s=3.0, groups=[group], working=False)
    assert plan.state(group, time_s) is SignalState.OFF
    assert list(plan.changes(group, time_s)) == [(0.0, SignalState.OFF)]


@pytest.mark.parametrize(("kph", "seconds"), [(30, 3), (50, 3), (60, 4), (70, 5), (100, 5)])
def test_amber_is_longer_where_traffic_is_faster(kph, seconds):
    assert amber_s(speed_mps(kph, "km/h")) == seconds


def test_a_wide_junction_takes_longer_to_clear():
    times = [
        all_red_s(
            build_network(plan_road(Junction(kind="four_way", arms=4, lanes=[n] * 4))), p, 3.0
        )
        for n in (1, 3)
        for p in [(0, 1, 0, 1)]
    ]
    assert 1.0 <= times[0] < times[1] < 8.0


def running(approach, **fields):
    people = person("ego", maneuvers=["straight"]), person("car", approaches=[approach])
    hazard = {"kind": "red_light_running", "by": ["car"], "to": ["ego"]}
    functional = said(
        "four_way", *people, junction={"control": "signals"}, hazards=[hazard], **fields
    )
    return functional, enumerate_scenarios(functional).scenarios[0]


def test_who_runs_a_light_is_the_only_one():
    functional, logical = running("left")
    assert light_runners(functional, logical) == {"car"}
    assert must_obey(functional, logical) == {"ego"}
    assert green_phases(functional, logical) == (0, 1, 0, 1)


def test_who_runs_a_light_before_one_who_faces_it_has_red_for_itself():
    functional, logical = running("opposite")
    phases = green_phases(functional, logical)
    assert phases[logical.drives[0].entry] != phases[logical.drives[1].entry]


def test_what_is_said_to_happen_wins_over_the_light():
    people = person("ego", maneuvers=["straight"]), person("car", approaches=["left"])
    functional = said(
        "four_way",
        *people,
        junction={"control": "signals"},
        outcome={"kind": "collision", "between": ["ego", "car"]},
    )
    logical = enumerate_scenarios(functional).scenarios[0]
    assert must_obey(functional, logical) == {"ego"}
    assert not light_runners(functional, logical)
