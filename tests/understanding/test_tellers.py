"""Who tells it walks, cycles or drives."""

import pytest

from scegen.understanding import read


def people(text):
    return {(p.kind.value, p.role.value, *sorted(p.approaches)) for p in read(text).participants}


@pytest.mark.parametrize(
    "text",
    [
        "I was walking over the zebra crossing when a car came from the left.",
        "I was on foot, crossing the street, and a car came from the left.",
        "I stepped off the kerb into the road. From the left came a car at 50 km/h.",
        "Pushing a pram, I crossed the road, and a car came from the left.",
        "A pedestrian crosses the road. A car comes from the left.",
    ],
)
def test_on_foot_one_sees_the_ego_on_the_other_side(text):
    assert people(text) == {("pedestrian", "other", "right"), ("car", "ego")}
    assert read(text).junction.kind.value == "straight"


@pytest.mark.parametrize(
    "text",
    [
        "I was cycling along the road when a van overtook me.",
        "I rode along the road and a van overtook me.",
        "Along the road a van overtook me, and its mirror nearly touched my handlebar.",
    ],
)
def test_who_cycles_is_an_ego_on_a_bicycle(text):
    assert people(text) == {("bicycle", "ego"), ("van", "other", "behind")}


@pytest.mark.parametrize(
    "text",
    [
        "I was driving along the road when a van overtook me.",
        "I walked to my car and drove off. A van overtook me.",
        "The ego drives along. I stepped on the brake because a van overtook me.",
    ],
)
def test_who_drives_is_no_walker(text):
    assert {(kind, role) for kind, role, *_ in people(text)} == {("car", "ego"), ("van", "other")}


@pytest.mark.parametrize(
    "text",
    [
        "The ego turned left at an intersection while I, on foot, was crossing the street.",
        "I walked over the zebra crossing and the ego did not stop.",
    ],
)
def test_who_walks_beside_an_ego_that_is_named_is_somebody_else(text):
    assert {who[:2] for who in people(text)} == {("pedestrian", "other"), ("car", "ego")}


def test_who_cycles_beside_an_ego_that_is_named_is_somebody_else():
    text = "On my bike I was riding straight on when the ego turned left across my way."
    assert {who[:2] for who in people(text)} == {("bicycle", "other"), ("car", "ego")}
