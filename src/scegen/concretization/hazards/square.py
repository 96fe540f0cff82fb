"""Backing straight out, square to the road, and whom one meets there.

It stands so far off that it is up to speed for a while before the other's way, and then stops short
of that, or is in it as both touch: about where that is said, the search does the rest.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from scegen.concretization.amounts import change_of_speed
from scegen.concretization.backing import apart_m, back_straight, reversing_mps, stand_square
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.limits import REVERSING_MPS2
from scegen.concretization.meetings import DANGER, Meeting
from scegen.concretization.profile import SpeedChange
from scegen.concretization.setup import Setup
from scegen.errors import MotionInfeasibleError
from scegen.scenario.acts import SLOWING
from scegen.scenario.outcome import BodySide

_HELD_S = 1.5
"""It is up to speed for so long, so that this can be seen."""
_SHORT_M = 0.8
"""Who stops does so this far from the other's way."""
_STOOD_S = 0.5
"""And has stood so long when the other comes behind it."""
_ACROSS_M = 0.5
"""Who comes across the other's way has its rear so far beyond it."""
_STOPS_MPS2 = 2.0


def back_straight_out(scene: Setup, draft: DriveDraft, other: DriveDraft) -> Meeting | None:
    """Let it come straight back; tells when the other is there, None if that one is to brake.

    Raises:
        MotionInfeasibleError: the other does not come past behind it.
    """
    stand_square(scene, draft)
    near_m, (comes_m, gone_m) = _passes_behind(draft, other)
    across_m = near_m + other.body.width_m + _ACROSS_M
    speed, stop = reversing_mps(scene, draft), _stop(scene, draft)
    braking_m, stops_s = speed**2 / (2 * stop.rate_mps2), speed / stop.rate_mps2
    wanted = scene.contact_wanted(draft.id, other.id)
    short = not wanted and (draft is scene.ego or stop.act is not None)
    event_m, rests_m, lag_s = across_m, across_m + _ACROSS_M + braking_m, 0.0
    if short:
        rests_m = near_m - _SHORT_M
        event_m, lag_s = rests_m - braking_m, stops_s + _STOOD_S
    elif wanted and _strikes(scene, draft):
        event_m, comes_m = near_m, (comes_m + gone_m) / 2
    more_m = max(0.0, speed**2 / (2 * REVERSING_MPS2) + _HELD_S * speed - event_m)
    stand_square(scene, draft, more_m=more_m, straight_m=more_m + rests_m)
    begins_m = back_straight(scene, draft, speed, stop)
    if not (short or wanted):
        return None
    at_m = begins_m + event_m + more_m
    return Meeting(DANGER, draft.id, other.id, at_m, comes_m, lag_s, "comes past behind")


def _passes_behind(draft: DriveDraft, other: DriveDraft) -> tuple[float, tuple[float, float]]:
    """How far one goes back until it touches another, and where that one is the first and last."""
    s, its, room_m = apart_m(draft, other)
    begins_s = draft.laid.path.backwards[0][0]
    room_m[s < begins_s] = np.inf
    touch = room_m < 0.0
    if not touch.any():
        raise MotionInfeasibleError(f"{other.id} does not come past behind it", where=draft.id)
    last = int(touch.any(axis=1).argmax()) - 1
    places = its[touch.any(axis=0)]
    near_m = float(s[last] + room_m[last].min()) - begins_s
    return near_m, (float(places[0]), float(places[-1]))


def _stop(scene: Setup, draft: DriveDraft) -> SpeedChange:
    """How it comes to rest: by the act that is said, or as usual."""
    said = next((act for act in scene.speed_acts(draft.id) if act.kind in SLOWING), None)
    if said is None:
        return SpeedChange(0.0, draft.braking_mps2(_STOPS_MPS2))
    speed = reversing_mps(scene, draft)
    return replace(change_of_speed(scene, said, draft.body, speed, speed), target_mps=0.0)


def _strikes(scene: Setup, draft: DriveDraft) -> bool:
    """Whether its rear touches the other's side; else the other's front touches its own."""
    struck = scene.functional.outcome.struck if scene.functional.outcome is not None else None
    sides = {BodySide.LEFT, BodySide.RIGHT}
    return struck not in sides if draft is scene.ego else struck in sides
