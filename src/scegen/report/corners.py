"""Bodies and things as boxes on the ground."""

from __future__ import annotations

import numpy as np

from scegen.motion.model import Array
from scegen.scenario.bodies import Body
from scegen.scenario.objects import StaticObject


def box_corners(body: Body, x_m: Array, y_m: Array, heading_rad: Array) -> Array:
    """Corners of a participant's box, shape (steps, 4, 2), from its reference point's poses."""
    ahead = np.array([body.front_m, body.front_m, -body.rear_m, -body.rear_m])
    left = np.array([1, -1, -1, 1]) * body.width_m / 2
    c, s = np.cos(heading_rad)[:, None], np.sin(heading_rad)[:, None]
    return np.stack(
        (x_m[:, None] + ahead * c - left * s, y_m[:, None] + ahead * s + left * c), axis=-1
    )


def thing_corners(thing: StaticObject) -> Array:
    """Corners of a thing's box, (4, 2)."""
    along = np.array([1, 1, -1, -1]) * thing.length_m / 2
    left = np.array([1, -1, -1, 1]) * thing.width_m / 2
    c, s = np.cos(np.deg2rad(thing.heading_deg)), np.sin(np.deg2rad(thing.heading_deg))
    return np.stack((thing.x_m + along * c - left * s, thing.y_m + along * s + left * c), axis=-1)
