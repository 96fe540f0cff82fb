"""Reversing: backing up towards another, or out in front of it, or straight out of a bay.

One that reverses waits for the other, which has to brake late. Straight out, all is laid backwards
from where the two meet: it stands so far off that it is up to speed for a while before, and then
stops short of the other's way, or is across it as both touch.
"""

from collections.abc import Iterator
from dataclasses import replace
from math import copysign, hypot, sin

from scegen.concretization.amounts import change_of_speed
from scegen.concretization.backing import (
    back_out,
    back_straight,
    back_up,
    brakes_from,
    reversing_mps,
    stand_square,
)
from scegen.concretization.boxes import apart, box_at
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.encounters import culprits, same_arm, victims
from scegen.concretization.limits import REVERSING_MPS2
from scegen.concretization.meetings import (
    DANGER,
    Meeting,
    MeetingPoint,
    crossing_at,
    nearest_s_m,
    sampled,
)
from scegen.concretization.profile import SpeedChange
from scegen.concretization.setup import Setup, require_room
from scegen.concretization.tale import SIDEWAYS
from scegen.concretization.written import as_they_come
from scegen.errors import MotionInfeasibleError
from scegen.scenario.acts import SLOWING
from scegen.scenario.concrete import ArrivalBelow, Trigger
from scegen.scenario.functional import Hazard
from scegen.scenario.logical import Reverses
from scegen.scenario.outcome import BodySide
from scegen.scenario.vocabulary import HazardKind

_BRAKING_MPS2 = 6.0
_GAP_M = 0.5
"""Who brakes for one that reverses comes to rest this far from where it touches it."""
_SEEN_S = 1.0
"""It brakes so long after the other has begun to reverse, at least."""
_INTRUDED_S = 0.5
"""And so long after the other has come into its way."""
_BEGINS_M = 0.3
_LEAST_RUN_UP_M = 15.0
_HELD_S = 1.5
"""It is up to speed for so long, so that this can be seen."""
_SHORT_M = 0.8
"""Who stops does so this far from the other's way."""
_STOOD_S = 0.5
"""And has stood so long when the other comes behind it."""
_ACROSS_M = 0.5
"""Who comes across the other's way has its rear so far beyond it."""
_STOPS_MPS2 = 2.0
_LEAST_ACROSS = 0.7


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
            draft.from_arm = draft.drive.entry
            draft.drive = draft.drive.but(entry=other.drive.entry, rank=other.drive.rank - 1)
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
        else:
            back_up(scene, draft, other or scene.walks.get(walk or ""))
        if other is not None and not other.stands:
            meetings.append(_braked_for(draft, other))
    return meetings


def _braked_for(draft: DriveDraft, other: DriveDraft) -> Meeting:
    """The one is so far when the other has to brake."""
    (s, *own), (its, *theirs) = sampled(draft.path), sampled(other.path)
    begins_s, ends_s = draft.path.backwards[0]
    back = (s >= begins_s) & (s <= ends_s)
    x, y, heading = (row[back, None] for row in own)
    x2, y2, heading2 = theirs
    mine = box_at(x, y, heading, draft.body)
    meets = apart(mine, box_at(x2, y2, heading2, other.body), 0.0) < 0.0
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


def as_it_comes(draft: DriveDraft, other: DriveDraft, moment_s: float) -> Trigger:
    """It goes back when the other is so many seconds short of where it brakes, late."""
    at_s = other.course.s_at(moment_s - other.offset_s)
    square, speed = draft.drive.reverses is Reverses.SQUARE, other.course.speed_at(at_s)
    brakes_s = 0.0 if square else _braked_for(draft, other).second_s_m
    if at_s >= brakes_s or speed < 1.0:
        return as_they_come([other], moment_s)
    here, there = other.path.pose(at_s), other.path.pose(brakes_s)
    time_s = hypot(there.x_m - here.x_m, there.y_m - here.y_m) / speed
    place_m = round(brakes_s - other.start_m, 3)
    return ArrivalBelow(participant=other.id, place_m=place_m, time_s=round(time_s, 3))


def back_straight_out(scene: Setup, draft: DriveDraft, other: DriveDraft) -> Meeting | None:
    """Let it come straight back; tells when the other is there, None if that one is to brake.

    Raises:
        MotionInfeasibleError: the other does not come past behind it.
    """
    stand_square(scene, draft)
    (depth_m, place_m, left), body = _passage(draft, other), draft.body
    half_m = other.body.width_m / 2
    speed, stop = reversing_mps(scene, draft), SpeedChange(0.0, draft.braking_mps2(_STOPS_MPS2))
    said = next((act for act in scene.speed_acts(draft.id) if act.kind in SLOWING), None)
    if said is not None:
        stop = replace(change_of_speed(scene, said, body, speed, speed), target_mps=0.0)
    braking_m, stops_s = speed**2 / (2 * stop.rate_mps2), speed / stop.rate_mps2
    wanted = scene.contact_wanted(draft.id, other.id)
    short = not wanted and (draft is scene.ego or stop.act is not None)
    nearest_m = depth_m - half_m - body.rear_m
    across_m = depth_m + half_m + _ACROSS_M - body.rear_m
    comes_m = place_m - body.width_m / 2 / abs(left) - other.body.front_m
    outcome, lag_s = scene.functional.outcome, 0.0
    # Its rear touches the other's side, or else the other's front touches its own.
    aside = outcome is not None and outcome.struck in {BodySide.LEFT, BodySide.RIGHT}
    strikes = aside != (draft is scene.ego)
    if short:
        event_m, lag_s = nearest_m - _SHORT_M - braking_m, stops_s + _STOOD_S
        rests_m = event_m + braking_m
    elif wanted and strikes:
        left_m = scene.struck_left_m(body) if draft is scene.ego else 0.0
        comes_m = place_m + left_m / left
        comes_m -= other.body.centre_ahead_m
        event_m, rests_m = nearest_m, across_m + braking_m
    else:
        event_m = _struck_m(scene, (depth_m, left), draft, other, across_m)
        rests_m = event_m + _ACROSS_M + braking_m
    more_m = max(0.0, speed**2 / (2 * REVERSING_MPS2) + _HELD_S * speed - event_m)
    stand_square(scene, draft, more_m=more_m, straight_m=more_m + rests_m)
    begins_m = back_straight(scene, draft, speed, stop)
    if not (short or wanted):
        return None
    at_m = begins_m + event_m + more_m
    return Meeting(DANGER, draft.id, other.id, at_m, comes_m, lag_s, "comes past behind")


def _passage(draft: DriveDraft, other: DriveDraft) -> tuple[float, float, float]:
    """How another comes past behind one that stands square to the road.

    How far behind that one's place its line is, where on its path it is just behind it, and how far
    it comes to the left by the metre.
    """
    path, way = draft.path, other.path
    begins_s = path.backwards[0][0]
    stands = path.pose(begins_s)
    near_m, _ = nearest_s_m(way, stands.x_m, stands.y_m)
    line_s, place_m, turn = crossing_at(path, way, MeetingPoint(begins_s, near_m))
    if line_s > begins_s - draft.body.rear_m or abs(sin(turn)) < _LEAST_ACROSS:
        raise MotionInfeasibleError(f"{other.id} does not come past behind it", where=draft.id)
    return begins_s - line_s, place_m, sin(turn)


def _struck_m(
    scene: Setup, line: tuple[float, float], draft: DriveDraft, other: DriveDraft, across_m: float
) -> float:
    """How far it has come as the other's front touches its side.

    Its middle is then where that is said on the other's width; else it is just across.
    """
    outcome = scene.functional.outcome
    if other is not scene.ego or outcome is None or outcome.impact_percent is None:
        return across_m
    depth_m, left = line
    return (
        depth_m + scene.struck_left_m(other.body) * copysign(1.0, left) + draft.body.centre_ahead_m
    )
