"""Bodies and things as boxes on the ground."""

from __future__ import annotations

import numpy as np

from scegen.motion.model import Array, Trace
from scegen.scenario.bodies import Body
from scegen.scenario.objects import StaticObject


def box_corners(
    body: Body, x_m: Array | float, y_m: Array | float, heading_rad: Array | float
) -> Array:
    """Corners of a box, its front first, from its reference point's poses (...): (..., 4, 2)."""
    ahead = np.array([body.front_m, body.front_m, -body.rear_m, -body.rear_m])
    left = np.array([1, -1, -1, 1]) * body.width_m / 2
    x, y, heading = (np.asarray(values)[..., None] for values in (x_m, y_m, heading_rad))
    c, s = np.cos(heading), np.sin(heading)
    return np.stack((x + ahead * c - left * s, y + ahead * s + left * c), axis=-1)


def corners_at(trace: Trace, step: int) -> Array:
    """The corners (4, 2) of a participant's box at one step, its front first."""
    return box_corners(trace.body, trace.x_m[step], trace.y_m[step], trace.heading_rad[step])


def thing_corners(thing: StaticObject) -> Array:
    """Corners of a thing's box, (4, 2)."""
    return box_corners(thing.body, thing.x_m, thing.y_m, float(np.deg2rad(thing.heading_deg)))
