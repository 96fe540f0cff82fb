"""Distances are distances, contacts come first, near-duplicates are found."""

import numpy as np
import pyarrow as pa
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scegen.campaign.analysis.features import NUMBERS, WORDS, Features, criticality
from scegen.campaign.rows import SCHEMA

values = st.one_of(st.none(), st.floats(0, 100))
rows = st.lists(
    st.fixed_dictionaries(
        {
            **{
                name: st.sampled_from(["a", "b", None]) for name in ("junction", "conflict", "seen")
            },
            **dict.fromkeys(("pet_s", "ttc_s", "drac_mps2", "distance_m", "contact_s"), values),
        }
    ),
    min_size=1,
    max_size=12,
)


def table(listed):
    return pa.Table.from_pylist(listed, SCHEMA).to_pylist()


@given(rows)
def test_a_distance_is_one(listed):
    features = Features.of(table(listed))
    far = np.array([features.distances(row) for row in range(len(listed))])
    assert (far >= 0).all()
    assert (far <= 1).all()
    assert (np.diag(far) == 0).all()
    assert far == pytest.approx(far.T)
    for n, one in enumerate(listed):
        for m, other in enumerate(listed):
            if all(one.get(name) == other.get(name) for name in (*WORDS, *NUMBERS)):
                assert far[n, m] == 0


@given(rows)
def test_more_danger_is_more_critical(listed):
    before = criticality(table(listed))
    assert ((before >= 0) & (before <= 1)).all()
    closer = [
        row | {n: row[n] / 2 for n in ("ttc_s", "pet_s", "distance_m") if row[n] is not None}
        for row in listed
    ]
    assert (criticality(table(closer)) >= before).all()
    touching = [row | {"contact_s": 1.0} for row in listed]
    assert (criticality(table(touching)) == 1).all()


def test_one_that_only_closes_in_is_less_critical_than_one_that_comes_near_too():
    misses, near = {"ttc_s": 0.5, "pet_s": 6.0}, {"ttc_s": 0.8, "pet_s": 0.4}
    first, second = criticality(table([misses, near]))
    assert first < second


def test_nearly_the_same_ones_are_a_group():
    base = {"junction": "t", "pet_s": 1.0}
    listed = [base, base | {"pet_s": 9.0}, base | {"pet_s": 1.001}, base | {"junction": "y"}]
    assert Features.of(table(listed)).alike() == [[0, 2]]


def test_the_most_different_ones_are_far_from_all_before():
    listed = [{"junction": "t", "pet_s": x} for x in (0.0, 0.1, 5.0, 10.0)]
    assert Features.of(table(listed)).most_different(3, 0) == [0, 3, 2]
