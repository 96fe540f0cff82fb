"""Whoever has to give way is seen to do so: it slows down or waits, and goes on after the other."""

import numpy as np
import pytest
from saying import missed, person, said

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.motion import simulate
from scegen.motion.paths import build_paths
from scegen.motion.rules.giving_way import must_give_way
from scegen.road import build_network
from scegen.scenario.concrete import Travelled

AVOIDED = {"kind": "avoided", "between": []}
SITUATIONS = {
    "yield": ("four_way", "yield", ["straight"], ["right"]),
    "right": ("four_way", "priority_to_right", ["straight"], ["right"]),
    "across": ("four_way", "priority_to_right", ["left"], ["opposite"]),
    "ring": ("roundabout", "uncontrolled", [], []),
    "all_way": ("four_way", "all_way_stop", ["straight"], ["right"]),
}


def laid(name):
    """The first of its scenarios in which one gives way to the other, as first laid."""
    kind, control, moves, approaches = SITUATIONS[name]
    people = person("ego", maneuvers=moves), person("car", approaches=approaches)
    arms = 4
    junction = {"arms": arms, "control": control, "lanes": [1] * arms}
    functional = said(kind, *people, junction=junction, outcome=AVOIDED)
    for logical in enumerate_scenarios(functional).scenarios:
        duties = must_give_way(functional, logical)
        if len(duties) == 1:
            return functional, duties[0], concretize(functional, logical, seed=1)
    raise AssertionError(name)


def played(concrete):
    return simulate(concrete, build_paths(concrete, build_network(concrete.road)))


def before_line(concrete, name):
    """Its speeds over the last 25 m before the junction, and when it goes into it."""
    trace, motion = played(concrete)[name], concrete.participant(name).motion
    way = motion.turning_starts_m - motion.start_m
    near = (trace.s_m > way - 25.0) & (trace.s_m < way)
    return trace.speed_mps[near], float(trace.time_s[int((trace.s_m >= way).argmax())])


def later(concrete, name, metres):
    """The same where somebody starts so much farther back."""
    one = concrete.participant(name)
    start = one.motion.start_m - metres
    moved = one.model_copy(update={"motion": one.motion.model_copy(update={"start_m": start})})
    # What is counted from its start is counted from there.
    people = []
    for p in (moved if p is one else p for p in concrete.participants):
        program = [
            phase.model_copy(
                update={
                    "trigger": phase.trigger.model_copy(
                        update={"distance_m": phase.trigger.distance_m + metres}
                    )
                }
            )
            if isinstance(phase.trigger, Travelled) and phase.trigger.participant == name
            else phase
            for phase in p.speed_program
        ]
        people.append(p.model_copy(update={"speed_program": tuple(program)}))
    return concrete.model_copy(
        update={"participants": tuple(people), "duration_s": concrete.duration_s + 10.0}
    )


@pytest.mark.parametrize("name", SITUATIONS)
def test_who_gives_way_slows_down_or_waits_and_nobody_waits_for_ever(name):
    functional, duty, concrete = laid(name)
    speeds, goes_s = before_line(concrete, duty.yields)
    assert speeds.min() < 0.6 * concrete.participant(duty.yields).speed_mps
    _, first_s = before_line(concrete, duty.other)
    assert 0.0 < goes_s - first_s < 15.0
    assert not missed(functional, concrete)
    assert np.all([t.s_m[-1] > 20.0 and t.speed_mps[-1] > 1.0 for t in played(concrete).values()])


@pytest.mark.parametrize("name", ["yield", "right", "ring"])
def test_who_gives_way_waits_for_the_other_and_not_for_a_time(name):
    functional, duty, concrete = laid(name)
    trigger = next(
        phase.trigger
        for phase in concrete.participant(duty.yields).speed_program
        if isinstance(phase.trigger, Travelled) and phase.trigger.participant == duty.other
    )
    assert trigger.distance_m > 0.0
    _, before_s = before_line(concrete, duty.yields)
    late = later(concrete, duty.other, 20.0)
    _, after_s = before_line(late, duty.yields)
    assert after_s > before_s + 1.0
    assert f"rule.way.{duty.yields}.{duty.other}" not in missed(functional, late)
