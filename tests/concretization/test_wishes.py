"""Choices that break the least of what is wished, against trying all of them."""

from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.concretization.wishes import Wish, least_broken

NAMES = ["a", "b", "c"]


@st.composite
def problems(draw):
    options = {name: draw(st.permutations(range(draw(st.integers(1, 3))))) for name in NAMES}
    wishes = []
    for _ in range(draw(st.integers(0, 5))):
        one, two = draw(st.permutations(NAMES))[:2]
        apart = draw(st.integers(-2, 2))
        weight = draw(st.sampled_from([0.5, 1.0, 10.0, 100.0]))
        wishes.append(Wish((one, two), weight, lambda a, b, n=apart: a - b == n, "apart"))
    return options, wishes


def every(options):
    return (dict(zip(options, chosen, strict=True)) for chosen in product(*options.values()))


@given(problems())
def test_none_breaks_less(problem):
    options, wishes = problem

    def broken(chosen):
        return sum(wish.weight for wish in wishes if not wish.met(chosen))

    _, chosen = least_broken(options, wishes)
    assert broken(chosen) == pytest.approx(min(map(broken, every(options))))


@given(problems())
def test_what_can_be_met_is_met_by_some_choice(problem):
    options, wishes = problem
    for wish in wishes:
        assert wish.can_be_met(options) is any(map(wish.met, every(options)))


def test_where_all_is_equal_the_first_options_are_taken():
    assert least_broken({"a": "xyz", "b": "pq"}, [])[1] == {"a": "x", "b": "p"}
