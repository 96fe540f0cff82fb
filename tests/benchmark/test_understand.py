"""Scores of labelled descriptions, checked on cases whose outcome is known."""

import pytest

from scegen.benchmark.tallies import Tally, total
from scegen.benchmark.understand import run
from scegen.understanding import Case, paper_cases

RIGHT = Case(
    "right",
    "A van brakes hard at a crossroads.",
    {
        "junction": ["four_way"],
        "actors": {"van": [1, 1]},
        "hazards": {"must": ["hard_braking"], "may": []},
    },
)
WRONG = Case(
    "wrong",
    "A van brakes hard at a crossroads.",
    {
        "junction": ["t"],
        "actors": {"car": [1, 2]},
        "hazards": {"must": ["speeding"], "may": []},
    },
)
ALLOWED = Case(
    "allowed",
    "A van brakes hard.",
    {"hazards": {"must": [], "may": ["hard_braking"]}},
)
REFUSED = Case(
    "refused",
    "The cat sleeps.",
    {"actors": {"car": [2, 3]}, "hazards": {"must": ["speeding"], "may": []}},
)


def test_the_paper_is_understood():
    result = run(paper_cases())
    assert (result.cases, result.understood, result.failures) == (11, 11, [])
    assert total(result.hazards).f1 == 1.0
    held, judged = result.all_fields
    assert held == judged > 40


def test_right_and_wrong_are_told_apart():
    result = run([RIGHT, WRONG])
    assert (result.cases, result.understood) == (2, 1)
    assert result.fields == {"junction": (1, 2), "actors": (1, 2), "hazards": (1, 2)}
    assert [f.case for f in result.failures] == ["wrong"]
    assert len(result.failures[0].problems) == 3
    assert result.kinds == {"van": Tally(right=1, wrong=1), "car": Tally(missed=1)}
    assert result.hazards == {
        "hard_braking": Tally(right=1, wrong=1),
        "speeding": Tally(missed=1),
    }


def test_what_is_only_allowed_counts_neither_way():
    assert run([ALLOWED]).hazards == {}
    assert run([ALLOWED]).understood == 1


def test_a_refused_text_misses_everything():
    result = run([REFUSED])
    assert result.understood == 0
    assert result.kinds == {"car": Tally(missed=2)}
    assert result.hazards == {"speeding": Tally(missed=1)}
    assert result.fields == {"actors": (0, 1), "hazards": (0, 1)}


def test_shares():
    tally = Tally(right=3, wrong=1, missed=2)
    assert tally.precision == pytest.approx(0.75)
    assert tally.recall == pytest.approx(0.6)
    assert tally.f1 == pytest.approx(2 / 3)
    assert Tally().f1 == 1.0
    assert total({"a": tally, "b": tally}) == Tally(6, 2, 4)
