"""Keep those apart who have no business with each other."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from scegen.claims.boxes import Boxes
from scegen.concretization.boxes import apart, box_on
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.priorities import Manners, Waits
from scegen.motion.model import Array

_SAMPLE_S = 0.05
_MARGIN_M = 1.0
_COARSE_S = 0.4
_COARSE_M = 14.0
"""Two cars approach each other by less than this in half a coarse step."""
_STEP_S = 0.5
LONGEST_S = 40.0


def touch(first: DriveDraft, first_s: float, second: DriveDraft, second_s: float) -> bool:
    """Whether two drives with these offsets ever touch (or nearly) while both are on the road."""
    begin = max(first_s, second_s)
    end = min(first_s + float(first.course.time_s[-1]), second_s + float(second.course.time_s[-1]))
    if end <= begin:
        return False
    reach = first.body.length_m + second.body.length_m
    # Look coarsely first: most of the time everybody is far away.
    coarse = np.arange(begin, end, _COARSE_S)
    near = _distance(first, coarse - first_s, second, coarse - second_s) < reach + _COARSE_M
    if not near.any():
        return False
    times = np.concatenate([np.arange(t, t + _COARSE_S, _SAMPLE_S) for t in coarse[near]])
    near_m = apart(_boxes(first, times - first_s), _boxes(second, times - second_s), _MARGIN_M)
    return bool((near_m < _MARGIN_M).any())


def _distance(first: DriveDraft, first_s: Array, second: DriveDraft, second_s: Array) -> Array:
    """Distance of the reference points at times of either course."""
    places = []
    for draft, times in ((first, first_s), (second, second_s)):
        path = draft.laid.path
        s = np.interp(times, draft.course.time_s, draft.course.s_m)
        places.append((np.interp(s, path.s_m, path.x_m), np.interp(s, path.s_m, path.y_m)))
    (x1, y1), (x2, y2) = places
    return np.hypot(x1 - x2, y1 - y2)


def _boxes(draft: DriveDraft, times_s: Array) -> Boxes:
    s = np.interp(times_s, draft.course.time_s, draft.course.s_m)
    return box_on(draft.laid.path, draft.body, s)


def clear_offset(
    draft: DriveDraft,
    offset_s: float,
    others: Iterable[DriveDraft],
    offsets_s: Mapping[str, float],
    *,
    direction: int = 1,
    within_s: float = LONGEST_S,
    manners: Manners | None = None,
    meeting: Iterable[DriveDraft] = (),
) -> float:
    """The offset next to ``offset_s`` at which a drive touches none of the others.

    ``direction`` 1 looks later, -1 earlier, 0 both ways. Where none ``within_s`` is free, the
    offset stays. With ``manners`` it waits for its green, and nobody takes another's way, of the
    others or of those whom it is ``meeting`` and may touch.
    """
    placed = [(other, offsets_s[other.id]) for other in others]
    everybody = [*placed, *((other, offsets_s[other.id]) for other in meeting)]
    before = Waits.of([draft, *(other for other, _ in everybody)])
    for k in range(int(within_s / _STEP_S) + 1):
        signs = (direction,) if direction else (1, -1)
        for sign in signs:
            tried = offset_s + sign * k * _STEP_S
            if manners is not None:
                manners.wait(draft, tried)
                if not manners.settle(draft, tried, everybody):
                    before.restore()
                    continue
            if not any(
                touch(draft, tried, other, at) for other, at in placed
            ) and not _waiting_touch(before.changed(), draft, tried, everybody):
                return tried
            before.restore()
    if manners is not None:
        manners.wait(draft, offset_s)
    return offset_s


def _waiting_touch(
    waiting: Iterable[DriveDraft],
    draft: DriveDraft,
    offset_s: float,
    everybody: Sequence[tuple[DriveDraft, float]],
) -> bool:
    """Whether one of those who wait for a new one, or it, touches anybody meanwhile."""
    people = [(draft, offset_s), *everybody]
    late = {one.id: at for one, at in people}
    return any(
        touch(one, late[one.id], other, at)
        for one in waiting
        for other, at in people
        if other is not one
    )
