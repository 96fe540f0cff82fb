"""Bodies as seen from one another: where a box lies in another's frame, and how far is free."""

from typing import NamedTuple

import numpy as np

from scegen.claims.series import clipped, greatest
from scegen.claims.view import View, kept
from scegen.measures.contact import first_touches
from scegen.motion.batch.arrays import COS, SIN, Bools, Floats, Ints, X, Y
from scegen.scenario.bodies import Body
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Side

_HALVINGS = 5
"""Of a time step, to find the moment of touch: 0.05 s at 20 m/s is then known to 3 cm."""

_BESIDE_M, _SAME_WAY, _MUCH_M = 7.0, 0.92, 1e3
"""Who goes the same way beside another: so near to its line, with this cosine between them."""


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


@kept
def boxes(view: View, name: str, steps: int | None = None) -> Boxes:
    """The box of an entity over time, or its first steps (c, t), in the frame of the road."""
    track = view.laid[:, view.index[name], :, :steps]
    return around(view.body(name), *(track[:, row] for row in (X, Y, COS, SIN)))


def box_at(view: View, name: str, step: Ints | int) -> Boxes:
    """The box of an entity at a step of each candidate (c,), in the frame of the road."""
    at = clipped(np.asarray(step), 0, view.steps - 1)

    def make() -> Boxes:
        rows = np.arange(view.count) if np.ndim(at) else slice(None)
        track = view.laid[rows, view.index[name], :, at]
        return around(view.body(name), *(track[:, row] for row in (X, Y, COS, SIN)))

    return make() if np.ndim(at) else view.once(("box", name, int(at)), make)


def around(body: Body, x: Floats, y: Floats, cos: Floats, sin: Floats) -> Boxes:
    """The boxes of a body around its reference points."""
    ahead = body.centre_ahead_m
    half_length, half_width = body.length_m / 2, body.width_m / 2
    return Boxes(x + ahead * cos, y + ahead * sin, cos, sin, half_length, half_width)


def offset(frame: Boxes, other: Boxes) -> tuple[Floats, Floats]:
    """The other's centre in the frame of the first: ahead and to the left (m)."""
    dx, dy = other.x - frame.x, other.y - frame.y
    return dx * frame.cos + dy * frame.sin, dy * frame.cos - dx * frame.sin


def to_side(side: Side | None, left_m: Floats) -> Floats:
    """How far to a side something is that is so far to the left; to either, if none is named."""
    if side is None:
        return np.abs(left_m)
    return left_m if side is Side.LEFT else -left_m


def same_way(frame: Boxes, other: Boxes) -> Floats:
    """Cosine of the angle between the headings: 1 if they go the same way."""
    return frame.cos * other.cos + frame.sin * other.sin


def seen(frame: Boxes, other: Boxes) -> Seen:
    """The other box in the frame of the first."""
    x, y = offset(frame, other)
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


def counting_mps(
    measure: Measure, own: tuple[Boxes, Floats], other: tuple[Boxes, Floats]
) -> Floats:
    """The speed by which the free length between two makes a headway, or a time to collision.

    Both with their speeds (m/s). Of two in one direction that of the one behind counts, or how much
    faster it is; of two who come towards each other the own one, or both.
    """
    (frame, speed), (box, others) = own, other
    along = same_way(frame, box)
    follows = (seen(frame, box).x > 0.0) | (along < 0.0)
    if measure is Measure.HEADWAY_S:
        return np.where(follows, speed, others)
    closing = speed - others * along
    return np.where(follows, closing, -closing)


def free_width_m(frame: Boxes, other: Boxes) -> Floats:
    """Free width across the frame's heading; negative where the one is in front of the other."""
    clear = free(frame, other)
    return np.maximum(clear.left, clear.right)


def course(frame: Boxes, other: Boxes) -> Floats:
    """Direction of the other's heading from the frame's, counter-clockwise positive, rad."""
    sin = frame.cos * other.sin - frame.sin * other.cos
    angle: Floats = np.arctan2(sin, same_way(frame, other))
    return angle


@kept
def passes(view: View, name: str, other: str) -> tuple[Floats, Floats]:
    """By how much somebody comes from wholly behind another to wholly ahead, and when (c,).

    Side by side on one road; minus the longest way there is where it does not come near so.
    """
    frame, box = boxes(view, other), boxes(view, name)
    half, (x, y) = frame.half_length + box.half_length, offset(frame, box)
    beside = (np.abs(y) < _BESIDE_M) & (same_way(frame, box) > _SAME_WAY)
    behind = np.maximum.accumulate(np.where(beside, -half - x, -_MUCH_M), axis=1)
    most, step = greatest(np.minimum(behind, np.where(beside, x - half, -_MUCH_M)))
    return most, view.time_of(step)


class Contact(NamedTuple):
    """The first contact of two: whether there is one, when, and both boxes then (c,)."""

    happens: Bools
    time_s: Floats
    first: Boxes
    second: Boxes


@kept
def contact(view: View, first: str, second: str) -> Contact:
    """The first contact of two, placed within its time step."""
    time_s = view.of_pair("contact_s", first, second)
    happens = ~np.isnan(time_s)
    step = view.step_of(time_s)
    pair = np.array([view.index[first], view.index[second]])
    found = first_touches(view.traces.tracks, view.scene.bodies, pair, step, _HALVINGS)
    time_s = np.where(happens, (step - 1 + found[:, 0]) * view.dt_s, np.nan)
    touching = []
    for name, at in ((first, 1), (second, 5)):
        x, y, cos, sin = found[:, at : at + 4].T
        touching.append(box_at(view, name, 0)._replace(x=x, y=y, cos=cos, sin=sin))
    return Contact(happens, time_s, *touching)
