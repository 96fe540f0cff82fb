"""Bodies as seen from one another: where a box lies in another's frame, and how far is free."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scegen.claims.view import View
from scegen.motion.batch.arrays import COS, SIN, Bools, Floats, Ints, X, Y

_HALVINGS = 7
"""Of a time step, to find the moment of touch: 0.05 s at 20 m/s is then known to 1 cm."""


class Boxes(NamedTuple):
    """Boxes from above, elementwise: centre, direction of the heading, half sides (m)."""

    x: Floats
    y: Floats
    cos: Floats
    sin: Floats
    half_length: float
    half_width: float


class Seen(NamedTuple):
    """A box in the frame of another: its centre (x ahead, y to the left) and its limits, m."""

    x: Floats
    y: Floats
    rear: Floats
    front: Floats
    right: Floats
    left: Floats


class Free(NamedTuple):
    """Free distance of a box from each side of one's own; negative within, m."""

    front: Floats
    rear: Floats
    left: Floats
    right: Floats


def boxes(view: View, name: str) -> Boxes:
    """The box of an entity over time (c, t)."""

    def make() -> Boxes:
        body = view.body(name)
        cos, sin = view.row(name, COS), view.row(name, SIN)
        x = view.row(name, X) + body.centre_ahead_m * cos
        y = view.row(name, Y) + body.centre_ahead_m * sin
        return Boxes(x, y, cos, sin, body.length_m / 2, body.width_m / 2)

    return view.once(("boxes", name), make)


def box_at(view: View, name: str, step: Ints | int) -> Boxes:
    """The box of an entity at a step of each candidate (c,)."""
    all_of = boxes(view, name)
    rows = np.arange(view.count)
    at = np.clip(step, 0, view.steps - 1)
    x, y, cos, sin = (series[rows, at] for series in all_of[:4])
    return Boxes(x, y, cos, sin, all_of.half_length, all_of.half_width)


def seen(frame: Boxes, other: Boxes) -> Seen:
    """The other box in the frame of the first."""
    dx, dy = other.x - frame.x, other.y - frame.y
    x = dx * frame.cos + dy * frame.sin
    y = dy * frame.cos - dx * frame.sin
    cos = np.abs(frame.cos * other.cos + frame.sin * other.sin)
    sin = np.abs(frame.cos * other.sin - frame.sin * other.cos)
    along = other.half_length * cos + other.half_width * sin
    across = other.half_length * sin + other.half_width * cos
    return Seen(x, y, x - along, x + along, y - across, y + across)


def free(frame: Boxes, other: Boxes) -> Free:
    """Free distances of the other box from the sides of the first."""
    at = seen(frame, other)
    return Free(
        at.rear - frame.half_length,
        -frame.half_length - at.front,
        at.right - frame.half_width,
        -frame.half_width - at.left,
    )


def gap_m(frame: Boxes, other: Boxes) -> Floats:
    """Free length along the frame's heading; negative where the two are level."""
    clear = free(frame, other)
    return np.maximum(clear.front, clear.rear)


def apart(a: Boxes, b: Boxes) -> Floats:
    """Greatest free distance along an axis of either box; at most 0 where they touch."""
    distance: Floats = np.max([*free(a, b), *free(b, a)], axis=0)
    return distance


def course(frame: Boxes, other: Boxes) -> Floats:
    """Direction of the other's heading from the frame's, counter-clockwise positive, rad."""
    cos = frame.cos * other.cos + frame.sin * other.sin
    sin = frame.cos * other.sin - frame.sin * other.cos
    angle: Floats = np.arctan2(sin, cos)
    return angle


class Contact(NamedTuple):
    """The first contact of two: whether there is one, when, and both boxes then (c,)."""

    happens: Bools
    time_s: Floats
    first: Boxes
    second: Boxes


def contact(view: View, first: str, second: str) -> Contact:
    """The first contact of two, placed within its time step."""
    key = ("contact", first, second)
    return view.once(key, lambda: _contact(view, first, second))


def _contact(view: View, first: str, second: str) -> Contact:
    time_s = view.of_pair("contact_s", first, second)
    happens = ~np.isnan(time_s)
    step = np.rint(np.where(happens, time_s, 0.0) / view.dt_s).astype(np.int64)
    before = np.maximum(step - 1, 0)
    a, b = ((box_at(view, name, before), box_at(view, name, step)) for name in (first, second))
    low, high = np.zeros(view.count), np.ones(view.count)
    for _ in range(_HALVINGS):
        share = (low + high) / 2
        touch = apart(_between(*a, share), _between(*b, share)) <= 0.0
        high, low = np.where(touch, share, high), np.where(touch, low, share)
    share = np.where(step > 0, high, 1.0)
    time_s = np.where(happens, (step - 1 + share) * view.dt_s, np.nan)
    return Contact(happens, time_s, _between(*a, share), _between(*b, share))


def _between(before: Boxes, after: Boxes, share: Floats) -> Boxes:
    """The box part of the way from one place to the next."""
    x, y, cos, sin = (p + share * (q - p) for p, q in zip(before[:4], after[:4], strict=True))
    length = np.hypot(cos, sin)
    return Boxes(x, y, cos / length, sin / length, after.half_length, after.half_width)
