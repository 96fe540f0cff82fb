"""How tight a bend is, and how far it leads round, where the description does not say.

Sources: [AASHTO] A Policy on Geometric Design of Highways and Streets (2011), table 3-7: the least
radius for a speed, with the side friction that drivers accept and a superelevation of 6 %;
[UN79] UN R79: no more than 3 m/s2 sideways while a lane is kept. Both quoted from memory.
"""

from bisect import bisect_left
from math import ceil, degrees, pi

from pydantic import Field

from scegen.scenario.model import FrozenModel
from scegen.scenario.vocabulary import Side

COMFORTABLE_LATERAL_MPS2 = 3.0  # [UN79]
_SIDE_FRICTION = ((30, 0.28), (40, 0.23), (50, 0.19), (60, 0.17), (70, 0.15), (80, 0.14),
                  (90, 0.13), (100, 0.12), (110, 0.11), (120, 0.09), (130, 0.08))  # fmt: skip
"""By the speed in km/h [AASHTO]."""
RADII_M = (20.0, 5000.0)
"""The tightest and the widest bend of a road."""
_SUPERELEVATION = 0.06
_PER_RADIUS = 127.0
"""(km/h)^2 per m and g: 3.6^2 * 9.81."""
_ROUND_M = 10.0
_LASTS_S = 10.0
_MOST_RAD = pi / 2


class Bend(FrozenModel):
    """A bend: to which side the road leads as the ego drives it, and its centre line's radius.

    ``side`` None: either; ``radius_m`` None: what is usual for the speed limit.
    """

    side: Side | None = None
    radius_m: float | None = Field(default=None, ge=RADII_M[0], le=RADII_M[1])

    def radius_at_m(self, limit_mps: float) -> float:
        """Its radius on a road with this limit."""
        return self.radius_m or usual_radius_m(limit_mps)

    def turn_deg(self, limit_mps: float) -> float:
        """By how much the road turns, to the left positive, seen by who enters at arm 0.

        So far that one at the limit is in it for some time, at most by a right angle.
        """
        turn = min(_LASTS_S * limit_mps / self.radius_at_m(limit_mps), _MOST_RAD)
        return round(degrees(turn), 1) * (-1 if self.side is Side.RIGHT else 1)


def usual_radius_m(speed_mps: float) -> float:
    """The tightest bend that is built for a speed."""
    speed = speed_mps * 3.6
    speeds = [known for known, _ in _SIDE_FRICTION]
    friction = _SIDE_FRICTION[min(bisect_left(speeds, speed - 0.01), len(speeds) - 1)][1]
    radius = speed**2 / (_PER_RADIUS * (_SUPERELEVATION + friction))
    return max(ceil(radius / _ROUND_M) * _ROUND_M, 30.0)
