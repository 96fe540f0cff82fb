"""Reversing: backing up towards another, or backing out in front of it; the other brakes, late.

One that reverses waits for the other: it goes when that one is so many seconds short of where it
will have to brake.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot

from scegen.concretization.backing import (
    back_out,
    back_up,
    back_up_to,
    brakes_from,
    in_each_others_way,
)
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.hazards.parties import culprits, same_arm, victims
from scegen.concretization.lane_choice import entry_lanes
from scegen.concretization.meetings import DANGER, Meeting, sampled
from scegen.concretization.others import WalkDraft
from scegen.concretization.setup import Setup, require_room
from scegen.concretization.tale import SIDEWAYS
from scegen.errors import MotionInfeasibleError
from scegen.scenario.concrete import ArrivalBelow
from scegen.scenario.functional import Hazard
from scegen.scenario.logical import Reverses
from scegen.scenario.vocabulary import HazardKind

_BRAKING_MPS2 = 6.0
_GAP_M = 0.5
"""Who brakes for one that reverses comes to rest this far from where it touches it."""
_SEEN_S = 1.0
"""It brakes so long after the other has begun to reverse, at least."""
_INTRUDED_S = 0.5
"""And so long after the other has come into its way."""
_BEGINS_M = 0.3
_SEEN_BY_THEN_S = 0.6
"""Time to get so far from standing."""
_LEAST_RUN_UP_M = 15.0


def _sufferer(scene: Setup, hazard: Hazard, draft: DriveDraft) -> DriveDraft | None:
    """Towards whom it reverses: the first who drives.

    Raises:
        MotionInfeasibleError: those who are named only stand.
    """
    others = victims(scene, hazard, draft)
    if hazard.to and all(name in scene.stands for name in hazard.to):
        raise MotionInfeasibleError(
            f"reversing towards {', '.join(hazard.to)}, who is parked, is not supported: one that "
            "reverses does so towards somebody who drives, walks or rides across",
            where=draft.id,
            hint="Name another as the one that suffers it, or let it drive.",
        )
    return others[0] if others else None


def _crosser(scene: Setup, hazard: Hazard, draft: DriveDraft) -> WalkDraft | None:
    """Who crosses behind it: one who suffers it, or in whose way it is by another danger."""
    crossing = [
        name for other in scene.functional.hazards if draft.id in other.to for name in other.by
    ]
    names = [name for name in (*hazard.to, *crossing) if name in scene.walks]
    return scene.walks[names[0]] if names else None


def prepare_to_reverse(scene: Setup, hazard: Hazard) -> None:
    """Who comes out backwards enters, as it were, ahead of the other, in its lane."""
    for draft in culprits(scene, hazard):
        other = _sufferer(scene, hazard, draft)
        if draft.drive.maneuver in SIDEWAYS:
            raise MotionInfeasibleError(
                f"reversing and {draft.drive.maneuver.value.replace('_', ' ')} in one drive are "
                "not supported together",
                where=draft.id,
                hint="Leave one of both out.",
            )
        if other is None:
            continue
        if draft.drive.reverses is Reverses.OUT_OF_ARM:
            update = {"entry": other.drive.entry, "rank": other.drive.rank - 1}
            draft.from_arm = draft.drive.entry
            draft.drive = draft.drive.model_copy(update=update)
        if same_arm(draft, other):
            _check_order(draft, other)
            _one_lane(scene, draft, other)


def _check_order(draft: DriveDraft, other: DriveDraft) -> None:
    """On one arm, who reverses is ahead."""
    beside = draft.id == other.drive.beside or other.id == draft.drive.beside
    if beside or draft.drive.rank > other.drive.rank:
        raise MotionInfeasibleError(
            f"drives {'beside' if beside else 'behind'} {other.id}: reversing moves it away",
            where=draft.id,
            hint=f"Let it be ahead of {other.id}, or come from another arm.",
        )


def _one_lane(scene: Setup, draft: DriveDraft, other: DriveDraft) -> None:
    own = entry_lanes(scene, draft)
    lanes = [lane for lane in entry_lanes(scene, other) if lane in own]
    if draft.from_arm is not None:
        routes = scene.network.routes.get((draft.drive.entry, draft.from_arm), ())
        lanes = [lane for lane in lanes if any(r.entry_lane == lane for r in routes)]
    if not lanes:
        raise MotionInfeasibleError(
            f"no lane of arm {draft.drive.entry} leads both {draft.id} and {other.id} where they "
            "go, so the one cannot reverse towards the other",
            where=draft.id,
        )
    lane = other.entry_lane if other.entry_lane in lanes else lanes[0]
    draft.entry_lane = other.entry_lane = lane


def reverse(scene: Setup, hazard: Hazard) -> list[Meeting]:
    """The ways of those who go back, and whom they meet there."""
    meetings: list[Meeting] = []
    for draft in culprits(scene, hazard):
        other = _sufferer(scene, hazard, draft)
        if draft.reversal is not None:
            continue
        comes_out = draft.drive.reverses not in {None, Reverses.BACKS_UP}
        walk = _crosser(scene, hazard, draft) if other is None else None
        if comes_out and other is not None:
            back_out(scene, draft)
        elif walk is not None:
            back_up_to(scene, draft, walk)
        else:
            back_up(scene, draft, other)
        if other is not None:
            event_s, brakes_s = _encounter(draft, other)
            reason = "reversing: brakes when it comes back"
            meetings.append(Meeting(DANGER, draft.id, other.id, event_s, brakes_s, 0.0, reason))
    return meetings


def _encounter(draft: DriveDraft, other: DriveDraft) -> tuple[float, float]:
    """Where the one is when the other has to brake, and where that one is then."""
    touching = in_each_others_way(draft.laid.path, draft.body, other.laid.path, other.body)
    s, its = sampled(draft.laid.path)[0], sampled(other.laid.path)[0]
    begins_s, ends_s = draft.laid.path.backwards[0]
    back = (s >= begins_s) & (s <= ends_s)
    meets = touching[back]
    if not meets.any():
        raise MotionInfeasibleError(
            f"does not come into the way of {other.id} where it reverses", where=draft.id
        )
    stops_s = float(its[int(meets.any(axis=0).argmax())]) - _GAP_M - 1.0
    intrudes_s = max(begins_s + _BEGINS_M, float(s[back][int(meets.any(axis=1).argmax())]))
    course = draft.course
    sees_s = course.time_at(begins_s + _BEGINS_M) + _SEEN_S
    event_s = course.s_at(max(sees_s, course.time_at(intrudes_s) + _INTRUDED_S))
    rate = other.braking_mps2(_BRAKING_MPS2)
    brakes_s = brakes_from(other, stops_s, rate, 0.0)
    require_room(other.id, brakes_s, _LEAST_RUN_UP_M)
    return event_s, brakes_s


def go_back_as_they_come(scene: Setup, hazard: Hazard) -> None:
    """It goes when the other comes."""
    for draft in culprits(scene, hazard):
        other = _sufferer(scene, hazard, draft)
        if other is not None and draft.reversal is not None:
            _wait_for(draft, other, _encounter(draft, other)[1])


def _wait_for(draft: DriveDraft, other: DriveDraft, brakes_s: float) -> None:
    """Begin to reverse when the other is so many seconds short of where it brakes."""
    index, mark, back = next(
        (n, mark, mark.then)
        for n, mark in enumerate(draft.marks)
        if mark.then is not None and mark.then.hazard is HazardKind.REVERSING
    )
    begins_s, _ = draft.laid.path.backwards[0]
    goes_s = draft.course.time_at(begins_s + _BEGINS_M) - _SEEN_BY_THEN_S
    at_s = other.course.s_at(goes_s + draft.offset_s - other.offset_s)
    speed = other.course.speed_at(at_s)
    if at_s >= brakes_s or speed < 1.0:
        return
    here, there = other.laid.path.pose(at_s), other.laid.path.pose(brakes_s)
    away_m = hypot(there.x_m - here.x_m, there.y_m - here.y_m)
    waits = ArrivalBelow(
        participant=other.id,
        place_m=round(brakes_s - other.start_m, 3),
        time_s=round(away_m / speed, 3),
    )
    draft.marks[index] = replace(mark, then=replace(back, trigger=waits))
