"""Whatever is proposed, what goes on is inside its bounds, can be driven, and is accounted for."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scegen.criticality.proposals.driving import hindrances
from scegen.criticality.proposals.parameters import Parameter
from scegen.criticality.proposals.proposal import Proposal
from scegen.criticality.proposals.validating import VALIDATOR, Validator
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import from_data, to_json

PARAMETERS = tuple(
    Parameter(name, value, "m", low, high, "a number", column)
    for column, (name, value, low, high) in enumerate(
        [("a", 5.0, 0.0, 10.0), ("b", 2.0, 1.0, 3.0), ("c", -1.0, -4.0, 4.0)]
    )
)
ORIGIN = np.array([p.value for p in PARAMETERS])


def crowded(x):
    """Two who must keep apart, as an example of a bound that only holds together."""
    return frozenset({"a and b collide"} if x[0] + x[1] > 9.0 else set())


def validator(hindrances=crowded):
    return Validator(PARAMETERS, ORIGIN, hindrances)


def rng(seed=0):
    return np.random.Generator(np.random.PCG64(seed))


def proposal(parameter, value, reason="because"):
    return Proposal(parameter=parameter, value=value, reason=reason)


ANY_VALUE = st.one_of(
    st.floats(),
    st.floats(-5, 12),
    st.integers(),
    st.integers(10**400, 10**401),
    st.text(max_size=20),
    st.booleans(),
    st.none(),
    st.lists(st.integers(), max_size=3),
)


@st.composite
def anything(draw, names=("a", "b", "c", "d")):
    name = draw(st.one_of(st.sampled_from(names), st.text(max_size=20)))
    return proposal(name, draw(ANY_VALUE), draw(st.text(min_size=1, max_size=30)))


@settings(max_examples=300)
@given(st.lists(anything(), max_size=8), st.integers(0, 5))
def test_the_outcome_is_valid_whatever_is_proposed(proposals, seed):
    changes, rows = validator().validate(proposals, "x", rng(seed))
    assert len(changes) == len(rows) == len(proposals)
    final = rows[-1] if changes else ORIGIN
    assert not crowded(final)
    for p in PARAMETERS:
        assert p.low <= final[p.column] <= p.high
    for change in changes:
        assert (change.by == VALIDATOR) == (change.rejected is not None)
        assert change.parameter.isprintable()
        assert change.reason.isprintable()
    again, same = validator().validate(proposals, "x", rng(seed))
    assert again == changes
    assert (same == rows).all()


@settings(max_examples=100)
@given(st.lists(anything(), max_size=8))
def test_what_is_valid_stands_as_it_was_proposed(proposals):
    judged = validator().judge(proposals)
    changes, rows = validator().validate(proposals, "x", rng())
    columns = {p.name: p.column for p in PARAMETERS}
    for p, why, change, row in zip(proposals, judged, changes, rows, strict=True):
        if why is None:
            assert row[columns[p.parameter]] == float(p.value)
            assert change.after == round(float(p.value), 3)
            assert change.by == "x"
        else:
            assert change.rejected.why == why


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("d", 1.0, "no such parameter"),
        ("a", "fast", "not a number"),
        ("a", "4", "not a number"),
        ("a", True, "not a number"),
        ("a", None, "not a number"),
        ("a", math.nan, "not a finite number"),
        ("a", math.inf, "not a finite number"),
        ("a", 10**400, "not a finite number"),
        ("a", 10.5, "outside 0 to 10 m"),
        ("b", 0.0, "outside 1 to 3 m"),
        ("a", 9.0, "a and b collide"),
    ],
)
def test_what_is_rejected_and_why(name, value, words):
    (change,), _ = validator().validate([proposal(name, value)], "x", rng())
    assert words in change.rejected.why
    assert change.rejected.by == "x"
    assert change.by == VALIDATOR
    if name == "d":
        assert change.after is None
    else:
        assert change.after != value
        assert "random" in change.reason
        assert "because" in change.reason


def test_values_at_their_bounds_are_inside():
    judged = validator().judge([proposal("a", 0), proposal("b", 3.0), proposal("c", -4.0)])
    assert judged == [None, None, None]


def test_of_two_values_the_first_stands():
    twice = [proposal("a", 1.0), proposal("a", 2.0)]
    (first, second), _ = validator().validate(twice, "x", rng())
    assert first.after == 1.0
    assert second.after is None
    assert "was set to 1 before" in second.rejected.why


def test_values_that_only_work_together_are_let_through():
    # b alone would be too much; with less of a it is not
    verdicts = validator(lambda x: frozenset({"too much"} if x[0] + x[1] > 7.5 else set()))
    assert verdicts.judge([proposal("b", 3.0), proposal("a", 1.0)]) == [None, None]
    assert verdicts.judge([proposal("b", 3.0)])[0].startswith("does not work")


def test_the_one_that_spoils_it_is_named_and_the_others_stand():
    judged = validator().judge([proposal("c", 0.0), proposal("a", 8.0), proposal("b", 1.5)])
    assert judged[0] is None
    assert "with the values before it: a and b collide" in judged[1]
    assert judged[2] is None


def test_where_nothing_valid_is_found_the_value_stays():
    stuck = validator(lambda x: frozenset({"no"} if x[0] != 5.0 else set()))
    (change,), (row,) = stuck.validate([proposal("a", 99.0)], "x", rng())
    assert change.after is None
    assert row[0] == 5.0
    assert "left as it was" in change.reason


def test_other_seeds_draw_other_values():
    drawn = {validator().validate([proposal("a", -1)], "x", rng(s))[1][0, 0] for s in range(5)}
    assert len(drawn) == 5


@pytest.mark.parametrize("name", ["two cars", "walker", "queue"])
def test_real_scenarios_can_be_built_whatever_is_proposed(ready, says, name):
    search = ready[name]
    parameters = search.situation().parameters
    names = tuple(p.name for p in parameters)
    assert len(set(names)) == len(names)

    @settings(max_examples=25)
    @given(st.lists(wild(parameters), max_size=6), st.integers(0, 3))
    def law(proposals, seed):
        result = search.advise(says(*proposals), seed)
        again = search.advise(says(*proposals), seed)
        assert result.concrete == again.concrete
        assert result.advice == again.advice
        x = search.problem.space.origin if result.lead is None else result.lead.x
        assert (search.problem.space.low <= x).all()
        assert (x <= search.problem.space.high).all()
        known = hindrances(search.problem, search.problem.space.origin)
        assert hindrances(search.problem, x) <= known
        search.examine(result.concrete)
        data = result.concrete.model_dump(mode="json")
        assert from_data(ConcreteScenario, data, where="x") == result.concrete
        assert to_json(result.concrete)

    law()


def wild(parameters):
    """Values in and beyond the bounds of real parameters."""
    return st.sampled_from(parameters).flatmap(
        lambda p: st.builds(
            proposal,
            st.just(p.name),
            st.one_of(
                st.floats(p.low, p.high),
                st.sampled_from([p.low, p.high]),
                st.floats(p.low - 50, p.high + 50),
                ANY_VALUE,
            ),
        )
    )


def test_nobody_is_put_into_somebody(ready, says):
    search = ready["queue"]
    situation = search.situation()
    place = situation.parameter("car_1.start_m").value
    (change,) = search.advise(says(proposal("car_2.start_m", place))).advice.changes
    assert "car_1 and car_2 overlap at the start" in change.rejected.why
    assert change.by == VALIDATOR
    assert abs(change.after - place) > 4.0


def test_provenance_tells_the_way_from_the_first_value_to_the_last(ready, says):
    search = ready["two cars"]
    speed = next(p for p in search.situation().parameters if p.name == "car_2.speed_mps")
    value = round((speed.low + speed.high) / 2, 3)
    asked = says(
        proposal("car_2.speed_mps", value, "it is to be quicker"),
        proposal("car_1.speed_mps", 500.0, "very quick"),
        proposal("car_9.speed_mps", 5.0, "another one"),
    )
    result = search.advise(asked)
    fresh = result.concrete.provenance[len(search.concrete.provenance) :]
    by = {c.parameter: c for c in fresh}
    assert (by["car_2.speed_mps"].by, by["car_2.speed_mps"].after) == ("somebody", value)
    assert by["car_2.speed_mps"].reason == "it is to be quicker"
    replaced = by["car_1.speed_mps"]
    assert replaced.by == VALIDATOR
    assert replaced.after == result.concrete.participant("car_1").speed_mps
    assert (replaced.rejected.by, replaced.rejected.value) == ("somebody", "500")
    assert by["car_9.speed_mps"].after is None
    assert by["car_9.speed_mps"].rejected.why == "there is no such parameter"
    assert (result.advice.accepted, result.advice.replaced, result.advice.dropped) == (1, 1, 1)
