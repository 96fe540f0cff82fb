"""Coming up behind one who is slower or stands: where they would touch, if nobody braked."""

from __future__ import annotations

from scegen.concretization.courses import Sort, SpeedChange
from scegen.concretization.drafts import DriveDraft, Setup
from scegen.concretization.hazards.rule import in_line_before
from scegen.concretization.meetings import STRUCTURAL, Meeting
from scegen.concretization.passing import slowing_s_m
from scegen.scenario.vocabulary import HazardKind

_FASTER = 1.15
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


def come_up(scene: Setup) -> list[Meeting]:
    """Where those who are faster than who is ahead of them in their lane catch up with it."""
    meetings: list[Meeting] = []
    for draft in sorted(scene.drives.values(), key=lambda each: each.drive.rank):
        line = in_line_before(scene, draft)
        if not line or draft.stands:
            continue
        lead = line[-1]
        if draft.lane_changes or lead.lane_changes or draft.drive.beside or lead.drive.beside:
            continue
        slower = lead.stands or draft.cruise_mps > _FASTER * lead.cruise_mps
        if slower and not _otherwise(scene, draft, lead):
            bodies = lead.body.rear_m + draft.body.front_m
            place = min(slowing_s_m(draft), slowing_s_m(lead)) - draft.cruise_mps
            place = _rest_m(lead) - bodies if lead.stands else place
            reason = f"comes up behind {lead.id}"
            meetings.append(
                Meeting(STRUCTURAL, lead.id, draft.id, place + bodies, place, 0.0, reason)
            )
    return meetings


def _otherwise(scene: Setup, draft: DriveDraft, lead: DriveDraft) -> bool:
    """Whether a danger already says how the two come together or part."""
    if any(mark.hazard is not None for mark in (*draft.marks, *lead.marks)):
        return True
    return (
        any(
            {draft.id, lead.id} & {*hazard.by} and hazard.kind is not HazardKind.SLOW_DRIVING
            for hazard in scene.functional.hazards
        )
        and not lead.stands
    )
