"""Backing straight out, square to the road, and whom one meets there.

All is laid backwards from where the two meet: it stands so far off that it is up to speed for a
while before, and then stops short of the other's way, or is across it as both touch.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import cos, sin

import numpy as np

from scegen.concretization.amounts import change_of_speed
from scegen.concretization.backing import back_straight, reversing_mps, stand_square
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.limits import REVERSING_MPS2
from scegen.concretization.meetings import DANGER, Meeting, sampled
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
_LEAST_ACROSS = 0.7


@dataclass(frozen=True, slots=True)
class _Passage:
    """How another comes past behind one that stands square to the road.

    ``depth_m`` is how far behind that one's place its line is, ``s_m`` where it is on its path when
    it is so far to the left, and ``sense`` 1 if it comes towards the left, else -1.
    """

    depth_m: float
    s_m: Callable[[float], float]
    sense: int


def back_straight_out(scene: Setup, draft: DriveDraft, other: DriveDraft) -> Meeting | None:
    """Let it come straight back; tells when the other is there, None if that one is to brake.

    Raises:
        MotionInfeasibleError: the other does not come past behind it.
    """
    stand_square(scene, draft)
    passage, body, half_m = _passage(draft, other), draft.body, other.body.width_m / 2
    speed, stop = reversing_mps(scene, draft), _stop(scene, draft)
    braking_m, stops_s = speed**2 / (2 * stop.rate_mps2), speed / stop.rate_mps2
    wanted = scene.contact_wanted(draft.id, other.id)
    short = not wanted and (draft is scene.ego or stop.act is not None)
    nearest_m = passage.depth_m - half_m - body.rear_m
    across_m = passage.depth_m + half_m + _ACROSS_M - body.rear_m
    comes_m = passage.s_m(-passage.sense * body.width_m / 2) - other.body.front_m
    lag_s = 0.0
    if short:
        event_m, lag_s = nearest_m - _SHORT_M - braking_m, stops_s + _STOOD_S
        rests_m = event_m + braking_m
    elif wanted and _strikes(scene, draft):
        share = scene.impact_share if draft is scene.ego else 0.5
        comes_m = passage.s_m((0.5 - share) * body.width_m) - other.body.centre_ahead_m
        event_m, rests_m = nearest_m, across_m + braking_m
    else:
        event_m = _struck_m(scene, passage, draft, other, across_m)
        rests_m = event_m + _ACROSS_M + braking_m
    more_m = max(0.0, speed**2 / (2 * REVERSING_MPS2) + _HELD_S * speed - event_m)
    stand_square(scene, draft, more_m=more_m, straight_m=more_m + rests_m)
    begins_m = back_straight(scene, draft, speed, stop)
    if not (short or wanted):
        return None
    at_m = begins_m + event_m + more_m
    return Meeting(DANGER, draft.id, other.id, at_m, comes_m, lag_s, "comes past behind")


def _passage(draft: DriveDraft, other: DriveDraft) -> _Passage:
    """Where the other's line lies behind it."""
    stands = draft.laid.path.pose(draft.laid.path.backwards[0][0])
    c, s = cos(stands.heading_rad), sin(stands.heading_rad)
    place, x, y, heading = sampled(other.laid.path)
    behind = -(x - stands.x_m) * c - (y - stands.y_m) * s
    to_left = (y - stands.y_m) * c - (x - stands.x_m) * s
    across = np.sin(heading - stands.heading_rad)
    there = (behind > draft.body.rear_m) & (np.abs(across) > _LEAST_ACROSS)
    if not there.any():
        raise MotionInfeasibleError(f"{other.id} does not come past behind it", where=draft.id)
    n = int(np.where(there, np.abs(to_left), np.inf).argmin())
    left_m, slope = float(to_left[n]), float(across[n])
    along = float(np.cos(heading[n] - stands.heading_rad)) / slope
    return _Passage(
        float(behind[n]) + left_m * along,
        lambda aside_m: float(place[n]) + (aside_m - left_m) / slope,
        1 if slope > 0.0 else -1,
    )


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


def _struck_m(
    scene: Setup, passage: _Passage, draft: DriveDraft, other: DriveDraft, across_m: float
) -> float:
    """How far it has come as the other's front touches its side.

    Its middle is then where that is said on the other's width; else it is just across.
    """
    outcome = scene.functional.outcome
    if other is not scene.ego or outcome is None or outcome.impact_percent is None:
        return across_m
    left_m = (0.5 - scene.impact_share) * other.body.width_m
    return passage.depth_m + passage.sense * left_m + draft.body.centre_ahead_m
