"""How late two drives may be against each other: what their ways share forbids some differences.

Ground that two cross is one's alone, and one of two on one line stays ahead. So everything that
keeps two apart is a range of differences that is taken: no contact, a headway, right of way.
"""

from collections.abc import Iterable
from math import inf
from typing import NamedTuple

import numpy as np

from scegen.concretization.courses import Course
from scegen.concretization.drafts import DriveDraft
from scegen.measures.grounds import Ground, grounds
from scegen.measures.remembering import remembered
from scegen.motion.model import Array, Path
from scegen.scenario.bodies import Body

_STEP_M, _ASIDE_M, _NEAR_M = 2.0, 2.0, 1.0
_BEYOND_M = 100.0
"""Farther behind the junction whoever comes up with another brakes for it."""


class Line(NamedTuple):
    """A line that two drive along, by places of the one and of the other.

    By how much the other must be later from there on to stay behind, and by how much earlier to
    stay ahead.
    """

    one_m: Array
    other_m: Array
    later_s: Array
    earlier_s: Array


def touches(one: DriveDraft, others: Iterable[DriveDraft], room_s: float, begins_s: float) -> bool:
    """Whether a drive as late as it is ever touches any of the others, or comes so near in time.

    The scenario begins at ``begins_s``: nobody is in anybody's way before.
    """
    return any(_touch(one, two, room_s, begins_s) for two in others if two is not one)


def _touch(one: DriveDraft, two: DriveDraft, room_s: float, begins_s: float) -> bool:
    # What is known of two is kept in one order only.
    first, second = (one, two) if one.id < two.id else (two, one)
    first_s, second_s = first.offset_s, second.offset_s
    if any(
        first_s + shared.enter_m < second_s + shared.other_leaves_m + room_s
        and second_s + shared.other_enters_m < first_s + shared.leave_m + room_s
        for shared in grounds_s(first, second)
    ):
        return True
    for line in _lines(first, second):
        # The one behind starts somewhere on the line; what lies before that is nothing to it.
        here = _index(line.one_m, first.course.s_at(begins_s - first_s))
        there = _index(line.other_m, second.course.s_at(begins_s - second_s))
        later_s = second_s - first_s
        if later_s < line.later_s[there] + room_s and -later_s < line.earlier_s[here] + room_s:
            return True
    return False


def same_lane(first: DriveDraft, second: DriveDraft) -> bool:
    """Whether two drives start on the same arm in the same lane."""
    return (
        first.drive.entry == second.drive.entry
        and first.entry_lane == second.entry_lane
        and first.id != second.id
    )


def _when_s(course: Course, place_m: float) -> float:
    return course.time_at(place_m) if place_m < course.ends_m + _NEAR_M else inf


def _index(places_m: Array, place_m: float) -> int:
    """That of the first place not before one; of the last place if there is none."""
    return min(int(np.searchsorted(places_m, place_m)), len(places_m) - 1)


def grounds_s(one: DriveDraft, other: DriveDraft) -> tuple[Ground, ...]:
    """The grounds of two in times, each on its own clock; inf where one never gets."""
    a, b = one.course, other.course
    shared = grounds(one.path, one.body, other.path, other.body)
    return tuple(Ground(*map(_when_s, (a, a, b, b), ground)) for ground in shared)


def _lines(one: DriveDraft, other: DriveDraft) -> tuple[Line, ...]:
    """From where they merge, or their arm begins, until they part or are well past the junction."""
    a, b = one.body, other.body
    begins = [(0.0, 0.0)] if one.drive.entry == other.drive.entry else []
    begins += [
        (ground.enter_m + a.front_m, ground.other_enters_m + b.front_m)
        for ground in grounds(one.path, a, other.path, b)
    ]
    ends_m = one.laid.path_s_m(one.laid.turning_ends_m) + _BEYOND_M
    driven = one.path, a, one.course, other.path, b, other.course
    return _along(*driven, tuple(begins), ends_m)


@remembered
def _along(
    one: Path, body: Body, a: Course, other: Path, other_body: Body, b: Course,
    begins_m: tuple[tuple[float, float], ...], ends_m: float,
) -> tuple[Line, ...]:  # fmt: skip
    found = []
    for one_m, other_m in begins_m:
        length = min(_along_m(one, one_m, other, other_m), ends_m - one_m)
        if length > 0.0:
            s = np.append(np.arange(0.0, length, _STEP_M), length)
            mine, its = one_m + s, other_m + s
            later = a.times_at(mine + body.rear_m) - b.times_at(its - other_body.front_m)
            earlier = b.times_at(its + other_body.rear_m) - a.times_at(mine - body.front_m)
            # The greatest from each on.
            late, early = (np.maximum.accumulate(v[::-1])[::-1] for v in (later, earlier))
            found.append(Line(mine, its, late, early))
    return tuple(found)


@remembered
def _along_m(first: Path, first_m: float, second: Path, second_m: float) -> float:
    """How far two ways run along one line from two places on; 0 if they do not."""
    s = np.arange(0.0, min(first.length_m - first_m, second.length_m - second_m), _STEP_M)
    x, y = (
        np.interp(first_m + s, first.s_m, mine) - np.interp(second_m + s, second.s_m, its)
        for mine, its in ((first.x_m, second.x_m), (first.y_m, second.y_m))
    )
    apart = np.flatnonzero(np.hypot(x, y) > _ASIDE_M)
    return float(s[apart[0]] if apart.size else s[-1] if s.size else 0.0)
