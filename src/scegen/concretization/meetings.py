"""Where the ways of two participants meet, and when they shall be there."""

from dataclasses import dataclass
from itertools import pairwise
from math import cos, sin
from typing import TypeAlias

import numpy as np

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.others import WalkDraft
from scegen.measures.grounds import Ground, grounds
from scegen.measures.remembering import remembered
from scegen.motion.model import Array, Path

_SAMPLE_M = 1.0
_OPPOSED = -0.85
"""The cosine between those who meet head-on is less."""
_CROSSES = 0.2
_STEP_M, _AGAIN = 0.05, 5

STRUCTURAL, DANGER, DANGER_TO_OTHERS, ORDINARY, BYSTANDER = -1, 1, 2, 3, 4
"""Priorities of meetings: what a manoeuvre's shape needs, dangers to or by the ego, dangers
between others, meetings without danger, and those who have no part in the text's dangers."""


Way: TypeAlias = DriveDraft | WalkDraft
"""One who has a way and goes along it."""


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

    def other_than(self, name: str) -> set[str]:
        """Whom one meets; nobody if it is not one of the two."""
        pair = {self.first, self.second}
        return pair - {name} if name in pair else set()


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
    return s, *path.places(s)


def first_ground(one: Way, other: Way) -> Ground | None:
    """The first that two who start apart share; None if their ways do not touch."""
    return next(iter(grounds(one.path, one.body, other.path, other.body)), None)


def meeting_point(first: Way, second: Way) -> MeetingPoint | None:
    """Where two ways first cross or merge: amid the ground that they share."""
    ground = first_ground(first, second)
    if ground is None:
        return None
    one = (ground.enter_m + min(ground.leave_m, first.path.length_m)) / 2
    two = (ground.other_enters_m + min(ground.other_leaves_m, second.path.length_m)) / 2
    one, two = one + first.body.centre_ahead_m, two + second.body.centre_ahead_m
    turn = first.path.pose(one).heading_rad - second.path.pose(two).heading_rad
    return MeetingPoint(one, two, opposed=cos(turn) < _OPPOSED)


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


def before_front_m(
    first: Path, second: Path, near: MeetingPoint, reach_m: float, aside_m: float
) -> float:
    """Where on the second way, which crosses the first, one is so far before it and to its left.

    Before one that bends its nose points elsewhere than its way goes.
    """
    s = np.arange(max(0.0, near.first_s_m - 2 * reach_m), near.first_s_m, _STEP_M)
    x, y, heading = first.places(s)
    middle = crossing_at(first, second, near)
    way, to_left = middle[1], 1 if sin(middle[2]) > 0 else -1
    for _ in range(_AGAIN):
        there = second.pose(way)
        dx, dy = there.x_m - x, there.y_m - y
        ahead = dx * np.cos(heading) + dy * np.sin(heading)
        at = int(np.abs(ahead - reach_m).argmin())
        left = float(dy[at] * np.cos(heading[at]) - dx[at] * np.sin(heading[at]))
        way += to_left * (aside_m - left)
    return way


def nearest_s_m(path: Path, x_m: float, y_m: float) -> tuple[float, float]:
    """(arc length, distance) of the place of a path that is nearest to a point."""
    s, x, y, _ = sampled(path)
    gaps = np.hypot(x - x_m, y - y_m)
    i = int(gaps.argmin())
    return float(s[i]), float(gaps[i])


def drives_meet(first: DriveDraft, second: DriveDraft) -> MeetingPoint | None:
    """Where two drives meet that start in different lanes, as places of their reference points.

    The bodies' centres are to meet, which lie ahead of the reference points; of one who strays and
    comes back the other comes onto the ground as it has just left it. Of two on one arm nobody
    changes lanes: they meet where one turns across the other.
    """
    if first.drive.entry == second.drive.entry:
        together = first.entry_lane == second.entry_lane
        if together or first.lane_changes or second.lane_changes:
            return None
    point, ground = meeting_point(first, second), first_ground(first, second)
    if point is None or ground is None:
        return None
    if point.opposed and _comes_back(first):
        return MeetingPoint(ground.leave_m, ground.other_enters_m, opposed=True)
    if point.opposed and _comes_back(second):
        return MeetingPoint(ground.enter_m, ground.other_leaves_m, opposed=True)
    return MeetingPoint(
        max(0.0, point.first_s_m - first.body.centre_ahead_m),
        max(0.0, point.second_s_m - second.body.centre_ahead_m),
        point.opposed,
    )


def _comes_back(draft: DriveDraft) -> bool:
    """Whether one leaves the lane of the oncoming again."""
    return any(a.lane_after == 0 < b.lane_after for a, b in pairwise(draft.lane_changes))
