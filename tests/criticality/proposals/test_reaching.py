"""What a proposer is told of a parameter is what happens when it is changed."""

import numpy as np
import pytest

from scegen.criticality.proposals.driving import hindrances


@pytest.fixture(params=["two cars", "walker", "queue"])
def search(request, ready):
    return ready[request.param]


def with_value(problem, parameter, value):
    x = problem.space.origin.copy()
    x[parameter.column] = value
    return x


def test_the_ends_of_a_reach_can_be_driven(search):
    situation, problem = search.situation(), search.problem
    known = hindrances(problem, problem.space.origin)
    found = situation.explore()
    for parameter in situation.parameters:
        reach = found.reaches[parameter.name]
        assert parameter.low <= reach.low <= parameter.value <= reach.high <= parameter.high
        for value in (reach.low, reach.high):
            assert hindrances(problem, with_value(problem, parameter, value)) <= known


def test_what_ends_before_its_bounds_says_why(search):
    situation = search.situation()
    found = situation.explore()
    for parameter in situation.parameters:
        reach = found.reaches[parameter.name]
        whole = (reach.low, reach.high) == pytest.approx((parameter.low, parameter.high))
        assert whole == (not reach.stops)


def test_a_unit_of_speed_is_worth_the_time_that_is_told(ready):
    search = ready["two cars"]
    situation, problem = search.situation(), search.problem
    (encounter,) = situation.encounters
    parameter = situation.parameter("car_2.speed_mps")
    reach = situation.explore().reaches[parameter.name]
    changed = parameter.value + 0.25
    x = np.array([problem.space.origin, with_value(problem, parameter, changed)])
    place = encounter.passages[[encounter.first, encounter.second].index("car_2")].enters_m
    view = problem.view(problem.space.candidates(x))
    comes = (view.place_m("car_2") >= place).argmax(axis=1) * view.dt_s
    assert reach.sooner_s * 0.25 == pytest.approx(comes[0] - comes[1], abs=view.dt_s)


def test_exploring_costs_the_search_nothing(search):
    before = search.problem.evaluations
    search.situation().explore()
    assert search.problem.evaluations == before
