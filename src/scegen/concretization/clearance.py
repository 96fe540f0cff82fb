"""Keep those apart who have no business with each other."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.priorities import Manners, Waits
from scegen.measures.nearing import Timetable, come_near

_MARGIN_M = 1.0
_STEP_S = 0.5
LONGEST_S = 40.0


def touch(
    first: DriveDraft, first_s: float, second: DriveDraft, second_s: float, begins_s: float
) -> bool:
    """Whether two drives with these offsets ever touch (or nearly) from a time on."""
    one, two = _table(first, first_s), _table(second, second_s)
    ends_s = min(float(table.time_s[-1]) + table.late_s for table in (one, two))
    backing = [late for d, late in ((first, first_s), (second, second_s)) if d.backs_out]
    return come_near(one, two, max([begins_s, *backing]), ends_s, _MARGIN_M)


def _table(draft: DriveDraft, late_s: float) -> Timetable:
    """When it is where if it is so late."""
    course, path, body = draft.course, draft.laid.path, draft.body
    half = body.length_m / 2, body.width_m / 2
    way = path.s_m, path.x_m, path.y_m, path.heading_rad
    speeds = float(course.speed_mps[0]), course.fastest_mps
    return Timetable(course.time_s, course.s_m, *speeds, late_s, *way, body.centre_ahead_m, *half)


def clear_offset(
    draft: DriveDraft,
    offset_s: float,
    others: Iterable[DriveDraft],
    offsets_s: Mapping[str, float],
    begins_s: float,
    *,
    direction: int = 1,
    within_s: float = LONGEST_S,
    manners: Manners | None = None,
    meeting: Iterable[DriveDraft] = (),
) -> float:
    """The offset next to ``offset_s`` at which a drive touches none of the others from a time on.

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
                touch(draft, tried, other, at, begins_s) for other, at in placed
            ) and not _waiting_touch(before.changed(), draft, tried, everybody, begins_s):
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
    begins_s: float,
) -> bool:
    """Whether one of those who wait for a new one, or it, touches anybody meanwhile."""
    people = [(draft, offset_s), *everybody]
    late = {one.id: at for one, at in people}
    return any(
        touch(one, late[one.id], other, at, begins_s)
        for one in waiting
        for other, at in people
        if other is not one
    )
