"""Several things in somebody's way lie one behind the other."""

from math import hypot

import pytest
from saying import made, person, said


@pytest.mark.parametrize("kind", ["straight", "t"])
def test_all_that_lies_in_the_way_is_there_and_apart(kind):
    things = [("crate", "box"), ("tyre", "tyre")]
    told = said(
        kind,
        person("ego", speed=50, maneuvers=["straight"], entries=[0]),
        objects=[{"id": name, "kind": what, "in_way_of": "ego"} for name, what in things],
        hazards=[{"kind": "obstacle", "by": ["crate", "tyre"], "to": ["ego"]}],
    )
    first, second = made(told).concrete.objects
    apart_m = hypot(first.x_m - second.x_m, first.y_m - second.y_m)
    assert apart_m > (first.length_m + second.length_m) / 2
