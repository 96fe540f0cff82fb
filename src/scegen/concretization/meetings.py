"""Where the ways of two participants meet, and when they shall be there."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import cos
from typing import Protocol

import numpy as np

from scegen.concretization.drafts import DriveDraft
from scegen.measures.conflict_areas import least_gap_m
from scegen.measures.grounds import Ground, grounds
from scegen.measures.remembering import remembered
from scegen.motion.model import Array, Path
from scegen.scenario.bodies import Body

_SAMPLE_M = 1.0
_OPPOSED = -0.85
"""The cosine between those who meet head-on is less."""

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


class OnItsWay(Protocol):
    """One with a body and a way, however it moves on it."""

    body: Body

    @property
    def path(self) -> Path:
        """Its way as a line."""


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


def nearest_s_m(path: Path, x_m: float, y_m: float) -> tuple[float, float]:
    """(arc length, distance) of the place of a path that is nearest to a point."""
    s, x, y, _ = sampled(path)
    gaps = np.hypot(x - x_m, y - y_m)
    i = int(gaps.argmin())
    return float(s[i]), float(gaps[i])


def first_ground(one: OnItsWay, other: OnItsWay) -> Ground | None:
    """The first ground that the bodies of two use on their ways; None if they share none."""
    return next(iter(grounds(one.path, one.body, other.path, other.body)), None)


def drives_meet(first: DriveDraft, second: DriveDraft) -> MeetingPoint | None:
    """Where two drives meet that start in different lanes, as places of their reference points.

    That is amid the ground that they share; of one who strays and comes back the other comes onto
    it as it has just left it. Of two on one arm nobody changes lanes: they meet where one turns
    across the other.
    """
    if first.drive.entry == second.drive.entry:
        together = first.entry_lane == second.entry_lane
        if together or first.lane_changes or second.lane_changes:
            return None
    one, two = first.path, second.path
    ground = first_ground(first, second)
    if ground is None:
        return None
    first_s_m = (ground.enter_m + min(ground.leave_m, one.length_m)) / 2
    second_s_m = (ground.other_enters_m + min(ground.other_leaves_m, two.length_m)) / 2
    turn = one.pose(first_s_m).heading_rad - two.pose(second_s_m).heading_rad
    opposed = cos(turn) < _OPPOSED
    if opposed and _comes_back(first):
        first_s_m, second_s_m = ground.leave_m, ground.other_enters_m
    elif opposed and _comes_back(second):
        first_s_m, second_s_m = ground.enter_m, ground.other_leaves_m
    return MeetingPoint(first_s_m, second_s_m, opposed)


def _comes_back(draft: DriveDraft) -> bool:
    """Whether one leaves the lane of the oncoming again."""
    return any(a.lane_after == 0 < b.lane_after for a, b in pairwise(draft.lane_changes))


def ways_touch(first: DriveDraft, second: DriveDraft) -> bool:
    """Whether bodies on two ways can touch: the lines come closer than half of both widths."""
    _, x1, y1, _ = sampled(first.path)
    _, x2, y2, _ = sampled(second.path)
    wide_m = (first.body.width_m + second.body.width_m) / 2
    return least_gap_m(x1, y1, x2, y2, wide_m) < wide_m
