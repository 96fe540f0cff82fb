"""Standing in line before the junction, one behind the other, for good."""

from __future__ import annotations

from scegen.concretization.courses import Sort, SpeedChange
from scegen.concretization.drafts import DriveDraft, Setup
from scegen.concretization.hazards.rule import in_line_before

_QUEUE_GAP_M = 2.0
_BEFORE_LINE_M = 2.0
_STANDS_MPS2 = 5.0


def stand_in_line(scene: Setup) -> None:
    """Those who are said to stay stand before the junction, one behind the other, for good."""
    for draft in sorted(scene.drives.values(), key=lambda each: each.drive.rank):
        if not draft.stands:
            continue
        place = draft.junction_s_m - draft.body.front_m - _BEFORE_LINE_M
        for other in in_line_before(scene, draft)[-1:]:
            if other.stands:
                behind = other.body.rear_m + _QUEUE_GAP_M + draft.body.front_m
                place = _rest_m(other) - behind
        begins = place - draft.cruise_mps**2 / (2 * _STANDS_MPS2)
        draft.deeds = [SpeedChange(begins, 0.0, _STANDS_MPS2, sort=Sort.ACT)]
        draft.course_ = None


def _rest_m(draft: DriveDraft) -> float:
    return float(draft.course.s_m[-1])
