"""A crosswalk over a road without a junction is one of the road, and who crosses is on it."""

import pytest

from scegen.understanding.reader import read


@pytest.mark.parametrize(
    ("text", "marked"),
    [
        ("A child runs over a zebra crossing before the ego.", {0}),
        ("A cyclist crosses at a mid-block crosswalk; the ego drives at 40 km/h.", {0}),
        ("50 m ahead of the ego lies a pedestrian crossing, and a man walks over it.", {0}),
        ("The ego approaches a crosswalk on a country road.", {0}),
        ("A child runs over the road where there is no crosswalk.", set()),
        ("A child runs over the road away from any crosswalk.", set()),
        ("A child runs over the road before the ego.", set()),
        ("The ego turns left at a crossroads; a man steps onto the crosswalk.", set()),
    ],
)
def test_it_is_a_field_of_the_road(text, marked):
    found = read(text)
    assert found.junction.crosswalks == marked
    assert any(e.field == "junction.crosswalks" for e in found.evidence) == bool(marked)


@pytest.mark.parametrize(
    "text",
    [
        "A woman crosses at a mid-block crosswalk before the crossroads as the ego comes.",
        "A van merges from the on-ramp in front of the ego at a crosswalk.",
    ],
)
def test_where_none_is_built_that_is_told(text):
    found = read(text)
    assert not found.junction.crosswalks
    assert any("crosswalk" in u.text for u in found.unsupported)
