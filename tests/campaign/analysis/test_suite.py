"""The fewest that cover, by brute force; then room is filled; what does not fit is told."""

from collections import Counter
from itertools import combinations

import pyarrow as pa
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scegen.campaign.analysis.coverage import Coverage, Ranged, coverage
from scegen.campaign.analysis.suite import FOR_COVERAGE, FOR_DANGER, smallest, suite_of
from scegen.campaign.rows import SCHEMA, speed_cells, table_of
from scegen.campaign.store import Store
from scegen.errors import InputError

sets = st.lists(st.frozensets(st.sampled_from("abcdefg"), max_size=4), min_size=1, max_size=7)


@settings(max_examples=40)
@given(sets)
def test_no_fewer_cover_everything(held):
    chosen, proved = smallest(held)
    everything = frozenset().union(*held)
    assert frozenset().union(*(held[n] for n in chosen)) == everything
    best = min(
        size
        for size in range(len(held) + 1)
        if any(
            frozenset().union(*(held[n] for n in some)) == everything
            for some in combinations(range(len(held)), size)
        )
    )
    assert len(chosen) == best
    assert proved


def suite(held, size, danger=()):
    listed = [{"contact_s": 1.0 if n in danger else None} for n in range(len(held))]
    rows = pa.Table.from_pylist(listed, SCHEMA).to_pylist()
    held = tuple(map(frozenset, held))
    counts = Counter(cell for cells in held for cell in cells)
    return suite_of(rows, Coverage(held, counts, {}, {}, ()), size)


def test_a_suite_covers_first_and_then_takes_the_most_critical():
    found = suite(["ab", "c", "a", "b", ""], 3, danger={3, 4})
    assert [(c.row, c.reason) for c in found.chosen] == [
        (0, FOR_COVERAGE),
        (1, FOR_COVERAGE),
        (3, FOR_DANGER),
    ]
    assert not found.uncovered
    assert found.needed == 2


def test_where_there_is_no_room_it_is_told():
    found = suite(["a", "bcd"], 1)
    assert [c.row for c in found.chosen] == [1]
    assert found.uncovered == ("a",)
    assert found.needed == 2


def test_without_a_good_scenario_there_is_no_suite():
    with pytest.raises(InputError, match="no scenario"):
        suite(["", ""], 1)


def test_what_cannot_be_covered_is_told_with_its_reason(tmp_path):
    good = {"status": "made", "claims": 2, "claims_held": 2, "cells": ["x"], "covered": ["x"]}
    rows = [
        good,
        {"status": "failed", "reason": "no such road\n  longer", "cells": ["x", "y"]},
        good | {"cells": ["z"], "covered": [], "blocked_by": "too slow"},
        good | {"cells": ["w"], "covered": ["w"], "claims_held": 1, "claims_missed": ["s: no"]},
        good | {"cells": ["v"], "covered": ["v"], "checks": {"schema": "failed"},
                "check_findings": ["schema: bad"]},
    ]  # fmt: skip
    rows = table_of([row | {"junction": "t"} for row in rows]).to_pylist()
    found = coverage(Store(tmp_path), rows)
    assert found.counts == {"x": 1}
    assert found.held[0] == {"x"}
    assert not any(found.held[1:])
    assert found.why_not == {
        "y": "it cannot be made: no such road (in 1 of 1)",
        "z": "the danger does not happen: too slow (in 1 of 1)",
        "w": "not as it is said: s: no (in 1 of 1)",
        "v": "a check fails: schema: bad (in 1 of 1)",
    }


def test_parts_of_ranges_are_covered_by_good_scenarios_alone(tmp_path):
    good = {"description": "d", "junction": "t", "status": "made", "claims": 2, "claims_held": 2}
    rows = [
        good | {"ranges": {"ego.speed_mps": [5.0, 10.0], "brake.rate_mps2": [6.0, 6.0]}},
        good | {"ranges": {"ego.speed_mps": [5.0, 10.0], "brake.rate_mps2": [6.0, 6.0]}},
        good | {"ranges": {"ego.speed_mps": [10.0, 15.0]}, "claims_held": 1},
        good | {"ranges": {"ego.speed_mps": [0.0, 5.0]}, "checks": {"schema": "failed"}},
        {"description": "e", "status": "failed"},
    ]
    (found,) = coverage(Store(tmp_path), table_of(rows).to_pylist()).ranges
    assert found == Ranged("d", "ego.speed_mps", 0.0, 15.0, parts=3, covered=1)


@pytest.mark.parametrize(
    ("kph", "band"),
    [(59.9999, "60 to 80"), (60.00012, "60 to 80"), (59.9, "40 to 60"), (0, "0 to 20")],
)
def test_what_rounding_leaves_of_a_speed_lies_in_its_band(kph, band):
    row = {"junction": "four_way", "ego_speed_mps": kph / 3.6, "other_speed_mps": None}
    assert speed_cells(row) == [f"four way: ego at {band} km/h"]
