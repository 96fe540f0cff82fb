"""What sets somebody off: how far another has come, unless that tells no moment."""

from dataclasses import dataclass

import pytest

from scegen.concretization.written import as_they_come
from scegen.scenario.concrete import AtTime, Travelled


@dataclass
class Comes:
    """At a speed until it stands."""

    id: str
    mps: float
    until_s: float = 100.0

    def speed_at_mps(self, time_s):
        return self.mps if time_s < self.until_s else 0.0

    def gone_m(self, time_s):
        return self.mps * min(time_s, self.until_s)


def test_one_is_set_off_as_the_first_who_drives_on_has_come_so_far():
    found = as_they_come([Comes("slow", 1.5), Comes("ego", 10.0), Comes("x", 20.0)], 3.0)
    assert isinstance(found, Travelled)
    assert found.participant == "ego"
    assert found.distance_m == pytest.approx(30.0, abs=0.1)


def test_who_is_about_to_stand_tells_no_moment():
    found = as_they_come([Comes("ego", 10.0, until_s=3.5)], 3.0)
    assert isinstance(found, AtTime)
    assert found.time_s == pytest.approx(3.0, abs=0.01)
