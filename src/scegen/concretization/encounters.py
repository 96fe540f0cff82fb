"""Which drives shall arrive together: causes and sufferers of dangers, then all the ego meets."""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.limits import (
    APPROACH_S,
    CLOSE_FOLLOWING_S,
    PASSING_LAG_S,
    TAILGATING_HEADWAY_S,
)
from scegen.concretization.meetings import (
    BYSTANDER,
    DANGER,
    DANGER_TO_OTHERS,
    ORDINARY,
    STRUCTURAL,
    Meeting,
    drives_meet,
)
from scegen.concretization.parties import event_s_m, pairs, same_arm
from scegen.concretization.setup import Setup
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

_EARLIER_S = 3.0
_LEAST_PLACE_M = 20.0
_HALF_WAY = 0.6


def conflict_meetings(scene: Setup, arranged: list[Meeting]) -> list[Meeting]:
    """Meetings by priority: dangers to or by the ego, between others, then all others' with it.

    Where the text names dangers, vehicles without a part in them pass a little after the ego.
    ``arranged`` are meetings that manoeuvres need already.
    """
    meetings = _side_by_side(scene)
    involved = {frozenset((m.first, m.second)) for m in (*arranged, *meetings)}
    named: set[str] = set()
    for hazard in scene.functional.hazards:
        named |= {*hazard.by, *hazard.to}
        for cause, sufferer in pairs(scene, hazard):
            key = frozenset((cause.id, sufferer.id))
            if key not in involved and not scene.runs_into_standing(cause.id):
                priority = DANGER if scene.ego.id in key else DANGER_TO_OTHERS
                reason = f"{hazard.kind}: arrives together"
                if same_arm(cause, sufferer) and drives_meet(cause, sufferer) is None:
                    found = [_close(scene, hazard, cause, sufferer, priority)]
                else:
                    found = _meeting(priority, cause, sufferer, 0.0, reason)
                meetings += found
                if found:
                    involved.add(key)
    return [*meetings, *_ordinary(scene, involved, named)]


def _ordinary(scene: Setup, involved: set[frozenset[str]], named: set[str]) -> list[Meeting]:
    """The first of each queue that the ego's way meets; the others queue up."""
    meetings: list[Meeting] = []
    ego = scene.ego.id
    # A queue of which one meets the ego in danger is placed by that one.
    taken = {
        (d.drive.entry, d.entry_lane)
        for d in scene.drives.values()
        if frozenset((d.id, ego)) in involved
    }
    for draft in sorted(scene.drives.values(), key=lambda d: d.drive.rank):
        queue = (draft.drive.entry, draft.entry_lane)
        if draft.id == ego or queue in taken:
            continue
        collide = scene.contact_wanted(ego, draft.id)
        bystander = bool(scene.functional.hazards) and draft.id not in named and not collide
        priority = DANGER if collide else BYSTANDER if bystander else ORDINARY
        lag = PASSING_LAG_S if bystander else 0.0
        point = drives_meet(scene.ego, draft)
        if point is not None and point.opposed:
            continue  # an overtaker in the oncoming lane: nobody said that it is met there
        found = _meeting(priority, scene.ego, draft, lag, "arrives together")
        if found:
            meetings += found
            taken.add(queue)
    return meetings


def _meeting(
    priority: int, first: DriveDraft, second: DriveDraft, lag_s: float, reason: str
) -> list[Meeting]:
    point = drives_meet(first, second)
    if point is None:
        return []
    places = point.first_s_m, point.second_s_m
    return [Meeting(priority, first.id, second.id, *places, lag_s, reason)]


def _close(
    scene: Setup, hazard: Hazard, cause: DriveDraft, sufferer: DriveDraft, priority: int
) -> Meeting:
    """On one arm: level in neighbouring lanes, close behind each other in one."""
    place = max(5.0, event_s_m(scene, cause, hazard))
    place = min([place, *(mark.s_m for mark in cause.marks if mark.hazard is hazard.kind)])
    if cause.entry_lane != sufferer.entry_lane:
        return Meeting(priority, cause.id, sufferer.id, place, place, 0.0, f"{hazard.kind}: level")
    lead, follow = cause, sufferer
    if sufferer.drive.rank < cause.drive.rank:
        lead, follow = sufferer, cause
    reason = f"{hazard.kind}: close behind"
    headway_s = CLOSE_FOLLOWING_S
    if hazard.kind is HazardKind.TAILGATING:
        headway_s = sum(TAILGATING_HEADWAY_S) / 2
        if not scene.has_said_speed(follow.id):
            follow.cruise_mps = lead.cruise_mps
    if lead.cruise_mps > follow.cruise_mps:
        # They draw apart: nearest where the leader starts, about this far before the junction.
        begins = lead.junction_s_m - lead.cruise_mps * (APPROACH_S + _EARLIER_S)
        place, priority = max(_LEAST_PLACE_M, begins), STRUCTURAL
    bodies = lead.body.rear_m + follow.body.front_m
    return Meeting(priority, lead.id, follow.id, place, place - bodies, headway_s, reason)


def _side_by_side(scene: Setup) -> list[Meeting]:
    """Those who travel beside another are level with it half way along the arm.

    Where one turns across the other, they are so there.
    """
    found = []
    # The second in the same lane drives in a line with the first.
    taken: set[tuple[str, int]] = set()
    for draft in scene.drives.values():
        beside = scene.drives.get(draft.drive.beside or "")
        if beside is None or (beside.id, draft.entry_lane) in taken:
            continue
        taken.add((beside.id, draft.entry_lane))
        point = drives_meet(beside, draft)
        place = draft.junction_s_m * _HALF_WAY
        priority, places, words = STRUCTURAL + 1, (place, place), "side by side"
        if point is not None:
            priority, places = DANGER, (point.first_s_m, point.second_s_m)
            words += ", one turns across the other"
        found.append(Meeting(priority, beside.id, draft.id, *places, 0.0, words))
    return found
