"""Who drives ahead of whom: where a leader's rear lies along its follower's path.

Paths are fixed, so the question is answered once per pair and position of the leader, not once
per candidate and step.
"""

from collections.abc import Sequence
from math import nan
from typing import NamedTuple

import numpy as np

from scegen.measures.bodies import Body, body_of
from scegen.measures.nearest import on_to
from scegen.measures.remembering import remembered
from scegen.motion.batch.arrays import Floats, Ints, S
from scegen.motion.batch.kernels import kernel
from scegen.motion.model import Path

SPACING_M = 0.5
"""Distance between the leader's positions in the table; interpolated linearly between."""
_ON_PATH_M = 0.5
"""How far from the tangent's foot the nearest point of a path may lie: farther is beyond its end.
"""
SAME_WAY_RAD = np.pi / 4
"""A body ahead counts as leader while its heading differs by less: else it is cross traffic."""


class FollowTable(NamedTuple):
    """``first[p, 0]`` is where the rows for "the first of pair p follows the second" begin.

    ``first[p, 1]`` the other way round; -1 where the paths never share a corridor. Row n belongs
    to the leader at ``n * SPACING_M`` along its path: ``rear_m`` is the station of its rearmost
    point along the follower's path (m), nan where its box lies outside the follower's corridor.
    """

    first: Ints
    rear_m: Floats


def follow_table(
    paths: Sequence[Path], bodies: Floats, pairs: Sequence[tuple[int, int]]
) -> FollowTable:
    """The table for these pairs, both ways round."""
    first = np.full((len(pairs), 2), -1, dtype=np.int64)
    parts: list[Floats] = []
    size = 0
    for p, (a, b) in enumerate(pairs):
        for way, (follower, leader) in enumerate(((a, b), (b, a))):
            rear = rear_stations(
                paths[follower], paths[leader], body_of(bodies, follower), body_of(bodies, leader)
            )
            if np.isfinite(rear).any():
                first[p, way] = size
                parts.append(rear)
                size += len(rear)
    return FollowTable(first, np.concatenate(parts) if parts else np.empty(0))


@remembered
def rear_stations(follower: Path, leader: Path, own: Body, other: Body) -> Floats:
    """Station of the leader's rear on the follower's path, by position of the leader.

    The leader's box is projected onto the tangent of the follower's path at the nearest point
    with a similar heading; the corridor is as wide as the follower.
    """
    rows = int(np.ceil(leader.length_m / SPACING_M)) + 2
    if follower.length_m == 0.0:
        return np.full(rows, nan)
    at = np.minimum(np.arange(rows) * SPACING_M, leader.length_m)
    x, y, heading = leader.places(at)
    x, y = x + other.ahead_m * np.cos(heading), y + other.ahead_m * np.sin(heading)

    s = np.linspace(0.0, follower.length_m, int(np.ceil(follower.length_m / 0.25)) + 1)
    fx, fy, way = follower.places(s)
    step_m = follower.length_m / max(len(s) - 1, 1)
    # Whoever is farther from the path than this is not in its corridor.
    reach = np.hypot(
        _ON_PATH_M, own.half_width_m + np.hypot(other.half_length_m, other.half_width_m)
    )
    nearest, away = _nearest(x, y, heading, fx, fy, way, step_m, float(reach) + step_m)
    way = way[nearest]
    turn = np.abs((heading - way + np.pi) % (2 * np.pi) - np.pi)
    dx, dy = x - fx[nearest], y - fy[nearest]
    ahead = dx * np.cos(way) + dy * np.sin(way)
    aside = np.abs(dy * np.cos(way) - dx * np.sin(way))

    length, width = other.half_length_m, other.half_width_m
    reach = length * np.cos(turn) + width * np.sin(turn)
    half_breadth = length * np.sin(turn) + width * np.cos(turn)
    inside = aside < own.half_width_m + half_breadth
    # Beyond either end of the follower's path there is nothing to project on.
    on_path = (np.abs(ahead) <= _ON_PATH_M) & np.isfinite(away)
    return np.where(inside & on_path, s[nearest] + ahead - reach, nan)


@kernel
def _nearest(
    x: Floats,
    y: Floats,
    heading: Floats,
    fx: Floats,
    fy: Floats,
    way: Floats,
    step_m: float,
    reach_m: float,
) -> tuple[Ints, Floats]:
    """For each pose the nearest point of a path with a similar heading, and its squared distance.

    The distance is inf, the point the first, where no such point is within reach. Points that
    follow one another are at most ``step_m`` apart: none is looked at that cannot be nearer than
    the nearest so far, and the one that was nearest to the pose before is looked at first.
    """
    index = np.zeros(x.shape[0], dtype=np.int64)
    away = np.full(x.shape[0], np.inf)
    reach = reach_m * reach_m
    last = -1
    for n in range(x.shape[0]):
        if last >= 0:
            turn = (heading[n] - way[last] + np.pi) % (2 * np.pi) - np.pi
            if abs(turn) <= SAME_WAY_RAD:
                dx, dy = x[n] - fx[last], y[n] - fy[last]
                # An earlier point that is as near is to be found, too.
                away[n], index[n] = np.nextafter(dx * dx + dy * dy, np.inf), last
        m = 0
        while m < fx.shape[0]:
            dx, dy = x[n] - fx[m], y[n] - fy[m]
            squared = dx * dx + dy * dy
            least = min(away[n], reach)
            if squared < least:
                turn = (heading[n] - way[m] + np.pi) % (2 * np.pi) - np.pi
                if abs(turn) <= SAME_WAY_RAD:
                    away[n], index[n] = squared, m
                m += 1
            else:
                m += on_to(squared, least, step_m)
        last = index[n] if away[n] < np.inf else -1
    return index, away


@kernel
def write_gaps(
    follower: Floats, leader: Floats, front_m: float, rear_m: Floats, first: int, gaps: Floats
) -> bool:
    """Write the gap (m) from the follower's front to the leader's rear for the first steps.

    nan where there is no leader in the corridor ahead. Returns whether there is one at any step; if
    not, the gaps may be left as they are. ``front_m`` is the distance from the follower's reference
    point to its front. ``rear_m`` are the rows of the table, ``first`` is the first one for this
    pair and direction, -1 for none. ``gaps`` is the output, of as many steps as it has room for.
    """
    some = False
    if first >= 0:
        for t in range(gaps.shape[0]):
            at = leader[S, t] / SPACING_M
            n = int(at)
            low, high = rear_m[first + n], rear_m[first + n + 1]
            gap = low + (at - n) * (high - low) - follower[S, t] - front_m
            if gap >= 0.0:
                gaps[t] = gap
                some = True
            else:
                gaps[t] = nan
    return some


@kernel
def gaps_behind(
    tracks: Floats, follower: int, leader: int, front_m: float, rear_m: Floats, first: int
) -> Floats:
    """The gap at every step, m, nan without a leader in the corridor ahead: [candidate, time].

    The arguments are those of :func:`write_gaps`, for one pair of every candidate.
    """
    out = np.full((tracks.shape[0], tracks.shape[3]), nan)
    for c in range(tracks.shape[0]):
        write_gaps(tracks[c, follower], tracks[c, leader], front_m, rear_m, first, out[c])
    return out
