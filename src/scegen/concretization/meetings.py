"""Where the ways of two participants meet, and when they shall be there."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import cos, sin

import numpy as np

from scegen.concretization.drafts import DriveDraft
from scegen.measures.conflict_areas import least_gap_m, nearest_points
from scegen.measures.remembering import remembered
from scegen.motion.model import Array, Path

_SAMPLE_M = 1.0
_TOUCH_M = 0.8
"""Ways sampled every metre that come this close cross or merge."""
_GRAZE_M = 2.0
"""Ways that come this close without crossing still let cars touch."""
_OPPOSED_RAD = 2.6
_BACK = 0.7
"""The share of a change back after which a stray is out of the oncoming one's way."""
_LANE_M = 5.0
_CROSSES = 0.2

STRUCTURAL, DANGER, DANGER_TO_OTHERS, ORDINARY, BYSTANDER = -1, 1, 2, 3, 4
"""Priorities of meetings: what a manoeuvre's shape needs, dangers to or by the ego, dangers
between others, meetings without danger, and those who have no part in the text's dangers."""


@dataclass(frozen=True, slots=True)
class Meeting:
    """``second`` reaches ``second_s_m`` of its path ``lag_s`` after ``first`` is at ``first_s_m``.

    Meetings of lower ``priority`` are arranged first.
    """

    priority: int
    first: str
    second: str
    first_s_m: float
    second_s_m: float
    lag_s: float = 0.0
    reason: str = ""


@dataclass(frozen=True, slots=True)
class MeetingPoint:
    """Arc lengths on two paths at which they first come together; ``opposed``: head-on."""

    first_s_m: float
    second_s_m: float
    opposed: bool = False


@remembered
def sampled(path: Path) -> tuple[Array, Array, Array, Array]:
    """s, x, y and heading about every metre."""
    count = max(2, int(path.length_m / _SAMPLE_M) + 1)
    s = np.linspace(0.0, path.length_m, count)
    return (
        s,
        np.interp(s, path.s_m, path.x_m),
        np.interp(s, path.s_m, path.y_m),
        np.interp(s, path.s_m, path.heading_rad),
    )


def meeting_point(first: Path, second: Path) -> MeetingPoint | None:
    """Where two ways that start apart first cross, merge or graze each other.

    Opposed ways on one line (an oncoming lane) meet in the middle of what they share.
    """
    s1, x1, y1, h1 = sampled(first)
    s2, x2, y2, h2 = sampled(second)
    nearest, gaps = nearest_points(x1, y1, x2, y2, _GRAZE_M)
    touching = np.flatnonzero(gaps < _TOUCH_M)
    opposed = False
    if touching.size:
        i = int(touching[0])
        turn = (h1[i] - h2[nearest[i]] + np.pi) % (2 * np.pi) - np.pi
        opposed = bool(abs(turn) > _OPPOSED_RAD)
        if opposed:
            i = int(touching[touching.size // 2])
    else:
        i = int(gaps.argmin())
        if gaps[i] > _GRAZE_M:
            return None
    return MeetingPoint(float(s1[i]), float(s2[nearest[i]]), opposed)


def crossing_at(first: Path, second: Path, near: MeetingPoint) -> tuple[float, float, float]:
    """Where exactly two ways cross (arc lengths), and by which angle the second goes to the left.

    Ways that hardly cross do so where they come near.
    """
    a, b = first.pose(near.first_s_m), second.pose(near.second_s_m)
    turn = b.heading_rad - a.heading_rad
    if abs(sin(turn)) < _CROSSES:
        return near.first_s_m, near.second_s_m, turn
    dx, dy = b.x_m - a.x_m, b.y_m - a.y_m
    along = (dx * sin(b.heading_rad) - dy * cos(b.heading_rad)) / sin(turn)
    across = (dx * sin(a.heading_rad) - dy * cos(a.heading_rad)) / sin(turn)
    return near.first_s_m + along, near.second_s_m + across, turn


def nearest_s_m(path: Path, x_m: float, y_m: float) -> tuple[float, float]:
    """(arc length, distance) of the place of a path that is nearest to a point."""
    s, x, y, _ = sampled(path)
    gaps = np.hypot(x - x_m, y - y_m)
    i = int(gaps.argmin())
    return float(s[i]), float(gaps[i])


def drives_meet(first: DriveDraft, second: DriveDraft) -> MeetingPoint | None:
    """Where two drives meet that start in different lanes, as places of their reference points.

    The bodies' centres are to meet, which lie ahead of the reference points. Of two on one arm
    nobody changes lanes: they meet where one turns across the other.
    """
    if first.drive.entry == second.drive.entry:
        together = first.entry_lane == second.entry_lane
        if together or first.lane_changes or second.lane_changes:
            return None
    point = meeting_point(first.laid.path, second.laid.path)
    if point is None:
        return None
    back = _just_back(first, second) if point.opposed else None
    if back is not None:
        return MeetingPoint(*back, opposed=True)
    return MeetingPoint(
        max(0.0, point.first_s_m - first.body.centre_ahead_m),
        max(0.0, point.second_s_m - second.body.centre_ahead_m),
        point.opposed,
    )


def _just_back(first: DriveDraft, second: DriveDraft) -> tuple[float, float] | None:
    """Where two meet head-on of whom one strays: it comes back into its own lane just then."""
    for stray, other, swapped in ((first, second, False), (second, first, True)):
        changes = stray.lane_changes
        back = [b for a, b in pairwise(changes) if a.lane_after == 0 and b.lane_after > 0]
        if not back:
            continue
        place = stray.laid.path_s_m(back[0].position_m + _BACK * back[0].length_m)
        pose = stray.laid.path.pose(place + stray.body.front_m)
        met, apart = nearest_s_m(other.laid.path, pose.x_m, pose.y_m)
        if apart > _LANE_M:
            continue
        met = max(0.0, met - other.body.front_m)
        return (met, place) if swapped else (place, met)
    return None


def ways_touch(first: DriveDraft, second: DriveDraft) -> bool:
    """Whether bodies on two ways can touch: the lines come closer than half of both widths."""
    _, x1, y1, _ = sampled(first.laid.path)
    _, x2, y2, _ = sampled(second.laid.path)
    wide_m = (first.body.width_m + second.body.width_m) / 2
    return least_gap_m(x1, y1, x2, y2, wide_m) < wide_m


def shared_length_m(first: DriveDraft, second: DriveDraft) -> float:
    """How far two drives from the same arm run along the same line (0 in different lanes)."""
    s, x1, y1, _ = sampled(first.laid.path)
    x2 = np.interp(s, second.laid.path.s_m, second.laid.path.x_m)
    y2 = np.interp(s, second.laid.path.s_m, second.laid.path.y_m)
    apart = np.flatnonzero(np.hypot(x1 - x2, y1 - y2) > _GRAZE_M)
    return float(s[apart[0]]) if apart.size else float(s[-1])
