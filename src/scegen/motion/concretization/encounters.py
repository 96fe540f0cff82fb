"""Which drives shall arrive together: causes and sufferers of dangers, then all the ego meets."""

from __future__ import annotations

from scegen.motion.concretization.drafts import DriveDraft, Scene
from scegen.motion.concretization.hazards.rule import Rule, event_s_m, pairs, same_arm
from scegen.motion.concretization.limits import CLOSE_FOLLOWING_S, PASSING_LAG_S
from scegen.motion.concretization.meetings import (
    BYSTANDER,
    DANGER,
    DANGER_TO_OTHERS,
    ORDINARY,
    Meeting,
    drives_meet,
)
from scegen.scenario.functional import Hazard

_SHORT_OF_REST_M = 0.5


def conflict_meetings(
    scene: Scene, rules: list[tuple[Rule, Hazard]], arranged: list[Meeting]
) -> list[Meeting]:
    """Meetings by priority: dangers to or by the ego, between others, then all others' with it.

    Where the text names dangers, vehicles without a part in them pass a little after the ego.
    ``arranged`` are meetings that manoeuvres need already.
    """
    meetings: list[Meeting] = []
    involved = {frozenset((m.first, m.second)) for m in arranged}
    named: set[str] = set()
    for rule, hazard in rules:
        named |= {*hazard.by, *hazard.to}
        if not rule.meets:
            continue
        for cause, sufferer in pairs(scene, hazard):
            key = frozenset((cause.id, sufferer.id))
            if key not in involved:
                priority = DANGER if scene.ego.id in key else DANGER_TO_OTHERS
                reason = f"{hazard.kind}: arrives together"
                if same_arm(cause, sufferer):
                    found = [_close(scene, hazard, cause, sufferer, priority)]
                else:
                    found = _meeting(priority, cause, sufferer, 0.0, reason)
                meetings += found
                if found:
                    involved.add(key)
    for draft in scene.drives.values():
        if draft is scene.ego or frozenset((draft.id, scene.ego.id)) in involved:
            continue
        bystander = bool(scene.functional.hazards) and draft.id not in named
        priority = BYSTANDER if bystander else ORDINARY
        lag = PASSING_LAG_S if bystander else 0.0
        meetings += _meeting(priority, scene.ego, draft, lag, "arrives together")
    return meetings


def _meeting(
    priority: int, first: DriveDraft, second: DriveDraft, lag_s: float, reason: str
) -> list[Meeting]:
    point = drives_meet(first, second)
    if point is None:
        return []
    first_s = arrival_s_m(first, point.first_s_m)
    second_s = arrival_s_m(second, point.second_s_m)
    return [Meeting(priority, first.id, second.id, first_s, second_s, lag_s, reason)]


def arrival_s_m(draft: DriveDraft, meeting_s_m: float) -> float:
    """Where a drive is when it counts as arrived: at the meeting, or at rest just before it.

    One who brakes to a stop before the meeting is not to be met after going on again.
    """
    place = meeting_s_m
    for mark in draft.marks:
        if mark.hold_s is not None and mark.s_m < meeting_s_m:
            rest = mark.s_m + draft.course.speed_at(mark.s_m) ** 2 / (2 * mark.rate_mps2)
            place = min(place, max(mark.s_m, rest - _SHORT_OF_REST_M))
    return place


def _close(
    scene: Scene, hazard: Hazard, cause: DriveDraft, sufferer: DriveDraft, priority: int
) -> Meeting:
    """On one arm: level in neighbouring lanes, close behind each other in one."""
    place = max(5.0, event_s_m(scene, cause, hazard))
    marks = [mark.s_m for mark in cause.marks if mark.hazard is hazard.kind]
    place = min([place, *marks])
    if cause.entry_lane != sufferer.entry_lane:
        return Meeting(priority, cause.id, sufferer.id, place, place, 0.0, f"{hazard.kind}: level")
    lead, follow = cause, sufferer
    if sufferer.drive.rank < cause.drive.rank:
        lead, follow = sufferer, cause
    bodies = lead.body.rear_m + follow.body.front_m
    return Meeting(
        priority,
        lead.id,
        follow.id,
        place,
        place - bodies,
        CLOSE_FOLLOWING_S,
        f"{hazard.kind}: close behind",
    )
