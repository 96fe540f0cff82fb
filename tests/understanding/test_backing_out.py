"""Who comes out backwards, and whose sides are told as its driver sees them."""

from __future__ import annotations

import pytest

from scegen.scenario.acts import ActKind
from scegen.scenario.roadway import Strip
from scegen.scenario.vocabulary import Approach, Role
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


@pytest.mark.parametrize(
    "comes",
    [
        "a car that passes behind it, at right angles, from the left",
        "a car that comes from the driver's left-hand side",
        "a car that passes behind it, at 25 km/h, from the left-hand side of the forward-facing "
        "ego driver",
    ],
)
@pytest.mark.parametrize("out", ["Backing out of a bay", "Reversing straight out of a parking bay"])
def test_who_backs_out_of_a_bay_is_in_it_at_first(out, comes):
    found = read(f"{out}, the ego bumps into {comes}.")
    assert found.ego.strip is Strip.PARKING
    assert [p.approaches for p in found.participants if p is not found.ego] == [{Approach.LEFT}]


def test_before_somebody_on_foot_it_only_backs_up():
    assert read("The ego backs out of a bay. A child walks behind it.").ego.strip is None
