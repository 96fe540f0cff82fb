"""Whether two oriented boxes touch: separating axes, exact for boxes, for many poses at once."""

from __future__ import annotations

from math import pi

import numpy as np
from numpy.typing import NDArray

from scegen.motion.model import Array
from scegen.road.geometry import Pose
from scegen.scenario.bodies import Body

Poses = tuple[Array, Array, Array]
"""x (m), y (m) and heading (rad) of a body's reference point, arrays of one shape."""


def overlaps(
    first: Poses, first_body: Body, second: Poses, second_body: Body, margin_m: float = 0.0
) -> NDArray[np.bool_]:
    """Whether two bodies overlap (or come closer than about ``margin_m``), pose by pose."""
    h1, h2 = first[2], second[2]
    dx = second[0] + second_body.centre_ahead_m * np.cos(h2)
    dx = dx - first[0] - first_body.centre_ahead_m * np.cos(h1)
    dy = second[1] + second_body.centre_ahead_m * np.sin(h2)
    dy = dy - first[1] - first_body.centre_ahead_m * np.sin(h1)
    touching = np.ones_like(dx, dtype=np.bool_)
    for angle in (h1, h1 + pi / 2, h2, h2 + pi / 2):
        reach = np.full_like(dx, margin_m)
        for heading, body in ((h1, first_body), (h2, second_body)):
            along = np.abs(np.cos(angle - heading)) * body.length_m / 2
            reach = reach + along + np.abs(np.sin(angle - heading)) * body.width_m / 2
        touching &= np.abs(dx * np.cos(angle) + dy * np.sin(angle)) < reach
    return touching


def overlap(first: Pose, first_body: Body, second: Pose, second_body: Body) -> bool:
    """Whether two bodies overlap on the ground."""
    poses = [
        tuple(np.array([value]) for value in (pose.x_m, pose.y_m, pose.heading_rad))
        for pose in (first, second)
    ]
    (x1, y1, h1), (x2, y2, h2) = poses
    return bool(overlaps((x1, y1, h1), first_body, (x2, y2, h2), second_body)[0])
