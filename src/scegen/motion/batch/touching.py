"""Whether two oriented boxes touch.

Source: separating axis theorem for convex polygons (Gottschalk, Lin, Manocha: OBBTree, 1996).
"""

from typing import NamedTuple

from scegen.motion.batch.arrays import COS, SIN, ContactTable, Floats, X, Y
from scegen.motion.batch.kernels import inner_kernel


class Box(NamedTuple):
    """Centre (m, world), cosine and sine of the heading, half sides (m)."""

    x: float
    y: float
    cos: float
    sin: float
    half_length: float
    half_width: float


@inner_kernel
def place_in(frame: Box, box: Box) -> tuple[float, float]:
    """Where a box's centre lies in the frame of another: ahead and to the left (m)."""
    dx, dy = box.x - frame.x, box.y - frame.y
    return dx * frame.cos + dy * frame.sin, dy * frame.cos - dx * frame.sin


@inner_kernel
def boxes_touch(a: Box, b: Box) -> bool:
    """Whether two boxes share a point: no side of either separates them."""
    dx, dy = b.x - a.x, b.y - a.y
    c = abs(a.cos * b.cos + a.sin * b.sin)
    s = abs(a.cos * b.sin - a.sin * b.cos)
    if abs(dx * a.cos + dy * a.sin) > a.half_length + b.half_length * c + b.half_width * s:
        return False
    if abs(dy * a.cos - dx * a.sin) > a.half_width + b.half_length * s + b.half_width * c:
        return False
    if abs(dx * b.cos + dy * b.sin) > b.half_length + a.half_length * c + a.half_width * s:
        return False
    return bool(abs(dy * b.cos - dx * b.sin) <= b.half_width + a.half_length * s + a.half_width * c)


@inner_kernel
def collided(contacts: ContactTable, tracks: Floats, i: int, t: int) -> bool:
    """Whether participant i touches the one at step t that a collision with brings it to rest."""
    j = contacts.other[i]
    return boxes_touch(_box(contacts, tracks, i, t), _box(contacts, tracks, j, t))


@inner_kernel
def _box(contacts: ContactTable, tracks: Floats, i: int, t: int) -> Box:
    cos, sin = tracks[i, COS, t], tracks[i, SIN, t]
    ahead = contacts.ahead_m[i]
    x, y = tracks[i, X, t] + ahead * cos, tracks[i, Y, t] + ahead * sin
    return Box(x, y, cos, sin, contacts.half_length_m[i], contacts.half_width_m[i])
