"""The reference counts: arms equal, without reduction, by pattern, exact."""

from __future__ import annotations

import pytest

from scegen.enumeration import count_scenarios, enumerate_scenarios, plain_crossing
from scegen.scenario.vocabulary import ArmsMode, Reduction

TABLE = [
    ((0, 1, 2), 3, 8, 4, 4),
    ((0, 1, 2), 4, 27, 10, 27),
    ((0, 1, 2, 3), 4, 81, 15, 24),
    ((0, 1, 2, 3, 0, 1), 4, 729, 28, 324),
    ((0, 1, 2) * 3 + (0,), 3, 1024, 11, 80),
    ((0, 1, 2, 3) * 2, 4, 6561, 45, 336),
    ((0, 1, 2, 3, 4) * 2, 5, 1_048_576, 286, 20_008),
]
ROWS = [
    (entries, arms, reduction, count)
    for entries, arms, *counts in TABLE
    for reduction, count in zip(Reduction, counts, strict=True)
]


@pytest.mark.parametrize(("entries", "arms", "reduction", "count"), ROWS)
def test_counted(entries, arms, reduction, count):
    certificate = count_scenarios(
        plain_crossing(entries, arms), reduction=reduction, arms=ArmsMode.EQUAL
    )
    assert certificate.count == count
    assert certificate.total == (arms - 1) ** len(entries)
    assert certificate.complete


@pytest.mark.parametrize(
    ("entries", "arms", "reduction", "count"), [row for row in ROWS if row[3] <= 20_008]
)
def test_listed(entries, arms, reduction, count):
    listed = enumerate_scenarios(
        plain_crossing(entries, arms), reduction=reduction, arms=ArmsMode.EQUAL
    )
    assert len(listed.scenarios) == count == listed.certificate.count
    assert sum(s.class_size for s in listed.scenarios) == (arms - 1) ** len(entries)
    seen = {tuple((d.entry, d.move) for d in s.drives) for s in listed.scenarios}
    assert len(seen) == count


def test_of_a_million_a_selection_is_listed_with_the_total():
    listed = enumerate_scenarios(
        plain_crossing((0, 1, 2, 3, 4) * 2, 5),
        reduction=Reduction.NONE,
        arms=ArmsMode.EQUAL,
        limit=200,
    )
    assert len(listed.scenarios) == 200
    assert listed.certificate.count == 1_048_576
    assert "Listed are 200 of 1,048,576" in listed.notes[-1]


def test_counts_do_not_list():
    certificate = count_scenarios(plain_crossing(tuple(range(8)) * 3, 8), arms=ArmsMode.EQUAL)
    assert certificate.total == 7**24
    assert certificate.count > 7**24 // (6**8 * 8)


def test_patterns_of_ten_cars_at_five_arms():
    listed = enumerate_scenarios(
        plain_crossing((0, 1, 2, 3, 4) * 2, 5), reduction=Reduction.PATTERN, arms=ArmsMode.EQUAL
    )
    assert len({s.pattern for s in listed.scenarios}) == 286
