"""Braking in the wrong place: hard braking, braking too late, stopping in the way."""

from __future__ import annotations

from dataclasses import replace

from scegen.concretization.amounts import SLOWING
from scegen.concretization.drafts import DriveDraft, Scene
from scegen.concretization.hazards.rule import (
    Rule,
    culprits,
    event_s_m,
    in_line_before,
    victims,
)
from scegen.concretization.limits import HARD_BRAKING_MPS2, STOPPING_MPS2
from scegen.concretization.marks import Mark
from scegen.concretization.meetings import drives_meet, meeting_point
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

_HARD_HOLD_S = 1.5
_STOP_HOLD_S = 3.0
_SAME_STOP_M = 15.0
_LATE = 0.5
"""One who brakes late begins with half of the braking distance left."""
_CLEAR_OF_WALKER_M = 2.0
_CLEAR_OF_OTHER_M = 3.0
"""From the front bumper of one who stops to the line of another's way: half a width and 2 m."""
_LEAST_STOP_M = 20.0
_IN_LINE_M = 3.0
_AFTER_WALKER_S = 0.5


def _stopping_by_itself(scene: Scene, hazard: Hazard) -> list[DriveDraft]:
    """Those who cause it, but for those who stop to reverse, or as the text says."""
    return [
        draft
        for draft in culprits(scene, hazard)
        if draft.reversal is None and not any(a.kind in SLOWING for a in scene.speed_acts(draft.id))
    ]


def _rest_m(draft: DriveDraft, mark: Mark) -> float:
    """Where one who brakes from a mark comes to rest."""
    return mark.s_m + draft.course.speed_at(mark.s_m) ** 2 / (2 * mark.rate_mps2)


def _stop_at(
    draft: DriveDraft, stop_s_m: float, rate: float, kind: HazardKind, hold: float
) -> None:
    """Come to rest at a place, wait, go on; one who stops near it anyway waits longer there."""
    for index, mark in enumerate(draft.marks):
        if mark.hold_s is not None and abs(_rest_m(draft, mark) - stop_s_m) < _SAME_STOP_M:
            draft.marks[index] = replace(mark, hold_s=max(mark.hold_s, hold))
            draft.course_ = None
            return
    speed = draft.course.speed_at(max(1.0, stop_s_m - 5.0))
    start = stop_s_m - speed**2 / (2 * rate)
    speed = draft.course.speed_at(max(1.0, start))
    start = max(3.0, stop_s_m - speed**2 / (2 * rate) - 0.1)
    draft.add_mark(Mark(start, 0.0, rate, kind, hold_s=hold))


def stops_for_walkers(scene: Scene, draft: DriveDraft) -> tuple[float, float] | None:
    """Where the reference point must rest for those who cross, and how long until they have."""
    stops = []
    for walk in scene.walks.values():
        point = meeting_point(draft.laid.path, walk.path)
        if point is not None:
            place = point.first_s_m - draft.body.front_m - _CLEAR_OF_WALKER_M
            clear = point.second_s_m + draft.body.width_m / 2 + 1.0 - walk.motion.setback_m
            stops.append((place, clear / walk.speed_mps))
    if not stops:
        return None
    return min(place for place, _ in stops), max(clear for _, clear in stops)


def _hard(scene: Scene, hazard: Hazard) -> None:
    for draft in _stopping_by_itself(scene, hazard):
        rate = draft.braking_mps2(float(scene.rng.uniform(*HARD_BRAKING_MPS2)))
        walkers = stops_for_walkers(scene, draft)
        hold = _HARD_HOLD_S
        if walkers is not None and walkers[0] > _LEAST_STOP_M:
            stop, clear = walkers
            # One behind another that stops for them stops behind it.
            stopping = {other.id for other in culprits(scene, hazard)}
            stop -= sum(
                other.body.length_m + _IN_LINE_M
                for other in in_line_before(scene, draft)
                if other.id in stopping
            )
            braking = draft.course.speed_at(stop - 5.0) / rate
            hold = max(hold, clear - braking + _AFTER_WALKER_S)
        else:
            stop = event_s_m(scene, draft, hazard)
            if draft is scene.ego and draft.rests_at_m is None:
                # The ego brakes to avoid, the others brake in its way.
                stop -= draft.body.length_m / 2 + _CLEAR_OF_OTHER_M
        _stop_at(draft, stop, rate, HazardKind.HARD_BRAKING, hold)


def _late(scene: Scene, hazard: Hazard) -> None:
    for draft in _stopping_by_itself(scene, hazard):
        rate = draft.braking_mps2(HARD_BRAKING_MPS2[0])
        event = event_s_m(scene, draft, hazard)
        for victim in victims(scene, hazard, draft) if draft.rests_at_m is None else ():
            point = drives_meet(draft, victim)
            event = point.first_s_m if point is not None else event
        speed = draft.course.speed_at(event - draft.cruise_mps)
        left = _LATE if draft.rests_at_m is None else 1.0
        start = max(3.0, event - left * speed**2 / (2 * rate))
        draft.add_mark(Mark(start, 0.0, rate, HazardKind.DELAYED_BRAKING, hold_s=_HARD_HOLD_S))


def _stopping(scene: Scene, hazard: Hazard) -> None:
    for draft in _stopping_by_itself(scene, hazard):
        rate = draft.braking_mps2(STOPPING_MPS2)
        event = event_s_m(scene, draft, hazard)
        _stop_at(draft, event, rate, HazardKind.STOPPING, _STOP_HOLD_S)


HARD_BRAKING = Rule(act=_hard)
DELAYED_BRAKING = Rule(act=_late)
STOPPING = Rule(act=_stopping)
