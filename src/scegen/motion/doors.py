"""The way of a door that opens: the arc of its middle about the hinge.

Its body is turned with its way, so that it lies along the vehicle at first and stands out from it
in the end. Numbers are those of an ordinary car's front door.
"""

from math import cos, pi, radians, sin

import numpy as np

from scegen.motion.model import Path
from scegen.motion.polyline import passed_m
from scegen.motion.standing import heads_for_junction, side_sign, standing_path
from scegen.road.model import RoadNetwork
from scegen.scenario.bodies import BODIES, Body
from scegen.scenario.concrete import SwingingMotion
from scegen.scenario.vocabulary import ParticipantKind

OPENS_RAD = radians(70.0)
"""How far it opens."""
_STEPS = 8
_BROAD_M = BODIES[ParticipantKind.DOOR].width_m
_OFF_M = 0.07
"""From the vehicle's side to the middle of the door: half its thickness, and a joint."""
_HINGE_SHARE = 0.15
"""How far before the middle of its vehicle the hinge is, as a share of the vehicle's length."""
REACH_M = _OFF_M + _BROAD_M * sin(OPENS_RAD)
"""How far it reaches out from the vehicle's side."""
WAY_M = _STEPS * _BROAD_M * sin(OPENS_RAD / _STEPS / 2)
"""How far its middle goes until it is open."""


def hinge_ahead_m(vehicle: Body) -> float:
    """How far the hinge lies before the middle of its vehicle."""
    return _HINGE_SHARE * vehicle.length_m


def door_path(network: RoadNetwork, motion: SwingingMotion) -> Path:
    """From closed to open, on the side of the traffic.

    Raises:
        MotionInfeasibleError: its vehicle stands off the road.
    """
    vehicle = motion.of
    on = standing_path(network, motion.stands, vehicle, motion.vehicle).start
    inwards = heads_for_junction(network, motion.stands)
    sign = side_sign(motion.stands.side) * (-1 if inwards else 1)
    hinge = on.shifted(
        forward_m=vehicle.centre_ahead_m + hinge_ahead_m(vehicle),
        left_m=sign * (vehicle.width_m / 2 + _OFF_M),
    )
    angles = [OPENS_RAD * n / _STEPS for n in range(_STEPS + 1)]
    half = _BROAD_M / 2
    places = [
        hinge.shifted(forward_m=-half * cos(angle), left_m=sign * half * sin(angle))
        for angle in angles
    ]
    x, y = (np.array(each) for each in zip(*((p.x_m, p.y_m) for p in places), strict=True))
    return Path(
        passed_m(x, y),
        x,
        y,
        np.array([on.heading_rad + sign * (pi / 2 - angle) for angle in angles]),
        (),
    )
