"""Who comes out backwards, and whose sides are told as its driver sees them."""

from __future__ import annotations

import pytest

from scegen.scenario.acts import ActKind
from scegen.scenario.vocabulary import Role
from scegen.understanding.reader import read


@pytest.mark.parametrize(
    "seen",
    [
        "as seen by a driver who faces forward",
        "as a driver facing forward sees it",
        "from the view of a driver who looks forwards",
    ],
)
def test_a_driver_who_looks_forward_is_the_egos(seen):
    text = (
        f"The ego backs out of a garage at 5 km/h. A car comes from the right, {seen}, at 30 km/h."
    )
    (car,) = (each for each in read(text).participants if each.role is not Role.EGO)
    assert car.speed_mps.middle == pytest.approx(30 / 3.6)


@pytest.mark.parametrize("how", ["leaves a parking bay backwards", "pulls out of a bay tail first"])
def test_who_leaves_backwards_reverses(how):
    assert ActKind.REVERSE in {act.kind for act in read(f"The ego {how} at 6 km/h.").acts}
