"""Targets are read or refused with the reason."""

import pytest

from scegen.criticality.target import parse_target
from scegen.errors import InputError


def test_words_and_bands():
    assert parse_target("near-miss").contact is False
    assert parse_target(" Collision ").contact is True
    band = parse_target("pet=0.3..1.0").choices[0][0]
    assert (band.measure, band.low, band.high) == ("pet", 0.3, 1.0)
    assert parse_target("pet=-1..1").contact is None
    assert parse_target("headway=0..1").contact is False


@pytest.mark.parametrize(
    "text",
    ["", "crash", "pet", "pet=1", "pet=0..0", "pet=1..0.5", "pet=1..1e9", "ttc=..", "x=0..1"],
)
def test_others_are_refused(text):
    with pytest.raises(InputError) as refusal:
        parse_target(text)
    assert "--target" in refusal.value.render()
