"""Boxes of bodies on their ways, as the claims see them, and how far apart they are."""

from __future__ import annotations

from math import hypot

import numpy as np

from scegen.claims.boxes import Boxes, free, gap_m, same_way, seen
from scegen.motion.model import Array, Path
from scegen.road.geometry import Pose
from scegen.scenario.bodies import Body
from scegen.scenario.spacings import Measure

LENGTHWISE = frozenset({Measure.GAP_M, Measure.HEADWAY_S, Measure.TTC_S})
"""Measures along the road."""


def missing_m(
    measure: Measure, value: float, own: tuple[Boxes, Array], other: tuple[Boxes, Array]
) -> Array:
    """How much longer the free length between two is than a measure says (n,), m.

    Args:
        measure: one along the road.
        value: in its unit.
        own: boxes and speeds (m/s) of the one whose speed counts if they come towards each other.
        other: those of the other; of two in one direction the speed of the one behind counts.
    """
    (frame, speed), (box, others) = own, other
    gap = gap_m(frame, box)
    if measure is Measure.GAP_M:
        return gap - value
    along = same_way(frame, box)
    follows = (seen(frame, box).x > 0.0) | (along < 0.0)
    if measure is Measure.HEADWAY_S:
        return gap - value * np.where(follows, speed, others)
    closing = speed - others * along
    return gap - value * np.where(follows, closing, -closing)


def box_at(x_m: Array, y_m: Array, heading_rad: Array, body: Body, beyond_m: Array) -> Boxes:
    """Boxes whose reference points are ``beyond_m`` ahead of places, (n,) or of any one shape."""
    cos, sin = np.cos(heading_rad), np.sin(heading_rad)
    ahead = body.centre_ahead_m + beyond_m
    half = body.length_m / 2, body.width_m / 2
    return Boxes(x_m + ahead * cos, y_m + ahead * sin, cos, sin, *half)


def box_on(path: Path, body: Body, s_m: Array) -> Boxes:
    """Boxes of a body whose reference point is at places of a path, or on its prolongation."""
    rows = (np.interp(s_m, path.s_m, row) for row in (path.x_m, path.y_m, path.heading_rad))
    beyond = np.minimum(s_m, 0.0) + np.maximum(s_m - path.length_m, 0.0)
    x, y, heading = rows
    return box_at(x, y, heading, body, beyond)


def box_of(pose: Pose, body: Body) -> Boxes:
    """The box of a body whose reference point is at a pose, (1,)."""
    x, y, heading = (np.array([v]) for v in (pose.x_m, pose.y_m, pose.heading_rad))
    return box_at(x, y, heading, body, np.zeros(1))


def apart(a: Boxes, b: Boxes, within_m: float) -> Array:
    """Greatest free distance along an axis of either box; at most 0 where they touch.

    Where it is more than ``within_m`` it is inf: only those who are near are looked at.
    """
    reach = hypot(a.half_length, a.half_width) + hypot(b.half_length, b.half_width) + within_m
    dx, dy = b.x - a.x, b.y - a.y
    near = dx * dx + dy * dy <= 2 * reach * reach
    distance = np.full(near.shape, np.inf)
    if not near.any():
        return distance
    one, two = (
        boxes._replace(
            x=np.broadcast_to(boxes.x, near.shape)[near],
            y=np.broadcast_to(boxes.y, near.shape)[near],
            cos=np.broadcast_to(boxes.cos, near.shape)[near],
            sin=np.broadcast_to(boxes.sin, near.shape)[near],
        )
        for boxes in (a, b)
    )
    distance[near] = np.max([*free(one, two), *free(two, one)], axis=0)
    return np.where(distance <= within_m, distance, np.inf)


def overlap(first: Pose, first_body: Body, second: Pose, second_body: Body) -> bool:
    """Whether two bodies overlap on the ground."""
    return bool(apart(box_of(first, first_body), box_of(second, second_body), 0.0)[0] < 0.0)
