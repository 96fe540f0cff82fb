"""Who turns into a road that another drives along at a steady speed, and who is hit at rest."""

import pytest
from saying import KMH, missed
from told import first

from scegen.understanding import read


@pytest.mark.parametrize(
    "text",
    [
        "A hatchback turns right out of a side street on the right; we go straight on at 90 km/h.",
        "A taxi coming the other way makes a U-turn ahead of the ego, which drives at 90 km/h.",
    ],
)
def test_who_joins_gets_as_fast_and_nobody_touches_anybody(text):
    functional = read(text)
    concrete = first(functional)
    assert not missed(functional, concrete)
    (other,) = (p for p in concrete.participants if p is not concrete.ego)
    assert other.speed_program[-1].target_speed_mps == pytest.approx(90 * KMH, abs=1e-3)


def test_who_stops_in_the_junction_is_hit_when_at_rest():
    functional = read(
        "Our car goes straight on and stops in the middle of the junction; a van from the left, "
        "straight on as well, rams its left side."
    )
    concrete = first(functional)
    assert not missed(functional, concrete)
    assert concrete.ego.speed_program[-1].target_speed_mps == 0.0
