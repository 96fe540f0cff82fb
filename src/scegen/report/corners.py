"""Bodies and things as boxes on the ground."""

from __future__ import annotations

import numpy as np

from scegen.motion.footprints import box_corners
from scegen.motion.model import Array, Trace
from scegen.scenario.objects import StaticObject


def corners_at(trace: Trace, step: int) -> Array:
    """The corners (4, 2) of a participant's box at one step, its front first."""
    return box_corners(trace.body, trace.x_m[step], trace.y_m[step], trace.heading_rad[step])


def thing_corners(thing: StaticObject) -> Array:
    """Corners of a thing's box, (4, 2)."""
    return box_corners(thing.body, thing.x_m, thing.y_m, float(np.deg2rad(thing.heading_deg)))
