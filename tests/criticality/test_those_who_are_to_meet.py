"""Whom a description makes meet does meet: proved from nothing but what it says, in any seed."""

import pytest
from meetings import MEETINGS
from told import made


@pytest.mark.parametrize("seed", [0, 3])
@pytest.mark.parametrize("name", sorted(MEETINGS))
def test_the_danger_is_reached(name, seed):
    functional = MEETINGS[name]
    _, proof = made(functional, seed)
    assert proof.blocked_by is None
    assert proof.in_band
    assert [h.kind for h in proof.hazards if not h.happened] == []
    assert len(proof.hazards) == len(functional.hazards)
    assert "ego" in proof.pair


def test_the_same_seed_gives_the_same_scenario():
    for name in ("right hook", "a parked car pulls out", "comes up behind a queue that stands"):
        assert made(MEETINGS[name], 5)[0] == made(MEETINGS[name], 5)[0]
