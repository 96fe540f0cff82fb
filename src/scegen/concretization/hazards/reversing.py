"""Reversing: backing up towards another, or backing out in front of it; the other brakes, late.

One that reverses waits for the other: it goes when that one is so many seconds short of where it
will have to brake.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
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
from scegen.concretization.hazards.square import back_straight_out
from scegen.concretization.meetings import DANGER, Meeting
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


def _each(scene: Setup) -> Iterator[tuple[Hazard, DriveDraft, DriveDraft | None]]:
    """Who reverses, and towards whom: the first who drives.

    Raises:
        MotionInfeasibleError: those who are named only stand.
    """
    every = scene.of_kind(HazardKind.REVERSING)
    for hazard, draft in ((each, draft) for each in every for draft in culprits(scene, each)):
        if hazard.to and scene.stands.keys() >= {*hazard.to}:
            raise MotionInfeasibleError(
                f"reversing towards {', '.join(hazard.to)}, who is parked, is not supported: one "
                "that reverses does so towards somebody who drives, walks or rides across",
                where=draft.id,
                hint="Name another as the one that suffers it, or let it drive.",
            )
        yield hazard, draft, next(iter(victims(scene, hazard, draft)), None)


def prepare_to_reverse(scene: Setup) -> None:
    """Who comes out backwards enters, as it were, ahead of the other, as who reverses there is.

    Raises:
        MotionInfeasibleError: it is beside or behind the other, or does something else as well.
    """
    for _, draft, other in _each(scene):
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
        beside = draft.id == other.drive.beside or other.id == draft.drive.beside
        if same_arm(draft, other) and (beside or draft.drive.rank > other.drive.rank):
            raise MotionInfeasibleError(
                f"drives {'beside' if beside else 'behind'} {other.id}: reversing moves it away",
                where=draft.id,
                hint=f"Let it be ahead of {other.id}, or come from another arm.",
            )


def reverse(scene: Setup) -> list[Meeting]:
    """The ways of those who go back, and whom they meet there.

    With nobody who drives, that is who crosses behind it: one who suffers it, or in whose way it is
    by another danger.
    """
    meetings: list[Meeting] = []
    for hazard, draft, other in _each(scene):
        if draft.reversal is not None:
            continue
        crossing = [n for h in scene.functional.hazards if draft.id in h.to for n in h.by]
        if draft.drive.reverses is Reverses.SQUARE and other is not None:
            met = back_straight_out(scene, draft, other)
            meetings.append(met or _braked_for(draft, other))
            continue
        walk = next((n for n in (*hazard.to, *crossing) if n in scene.walks), None)
        if other is not None and draft.drive.reverses not in {None, Reverses.BACKS_UP}:
            back_out(scene, draft)
        elif other is None and walk is not None:
            back_up_to(scene, draft, scene.walks[walk])
        else:
            back_up(scene, draft, other)
        if other is not None and not other.stands:
            meetings.append(_braked_for(draft, other))
    return meetings


def _braked_for(draft: DriveDraft, other: DriveDraft) -> Meeting:
    """The one is so far when the other has to brake."""
    s, its, touching = in_each_others_way(draft, other)
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
    brakes_s = brakes_from(other, stops_s, other.braking_mps2(_BRAKING_MPS2), 0.0)
    require_room(other.id, brakes_s, _LEAST_RUN_UP_M)
    reason = "reversing: brakes when it comes back"
    return Meeting(DANGER, draft.id, other.id, event_s, brakes_s, 0.0, reason)


def go_back_as_they_come(scene: Setup, meetings: Sequence[Meeting]) -> None:
    """It begins to reverse when the other is so many seconds short of where they meet."""
    for met in meetings:
        draft, other = scene.drives[met.first], scene.drives[met.second]
        square = draft.drive.reverses is Reverses.SQUARE
        # What either does by then may have changed how late the other can brake.
        brakes_s = (met if square else _braked_for(draft, other)).second_s_m
        begins_s, _ = draft.laid.path.backwards[0]
        goes_s = draft.course.time_at(begins_s + _BEGINS_M) - _SEEN_BY_THEN_S
        at_s = other.course.s_at(goes_s + draft.offset_s - other.offset_s)
        speed = other.course.speed_at(at_s)
        if at_s >= brakes_s or speed < 1.0:
            continue
        here, there = other.laid.path.pose(at_s), other.laid.path.pose(brakes_s)
        away_m = hypot(there.x_m - here.x_m, there.y_m - here.y_m)
        place_m, time_s = round(brakes_s - other.start_m, 3), round(away_m / speed, 3)
        waits = ArrivalBelow(participant=other.id, place_m=place_m, time_s=time_s)
        draft.marks = [
            replace(mark, then=replace(mark.then, trigger=waits))
            if mark.then is not None and mark.then.hazard is HazardKind.REVERSING
            else mark
            for mark in draft.marks
        ]
