"""Backing straight out, square to the road, and whom one meets there.

All is laid backwards from where the two meet: it stands so far off that it is up to speed for a
while before, and then stops short of the other's way, or is across it as both touch.
"""

from __future__ import annotations

from dataclasses import replace
from math import sin

from scegen.concretization.amounts import change_of_speed
from scegen.concretization.backing import back_straight, reversing_mps, stand_square
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.limits import REVERSING_MPS2
from scegen.concretization.meetings import DANGER, Meeting, first_ground
from scegen.concretization.profile import SpeedChange
from scegen.concretization.setup import Setup
from scegen.errors import MotionInfeasibleError
from scegen.scenario.acts import SLOWING
from scegen.scenario.vocabulary import BodySide

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
    path, body, outcome = draft.path, draft.body, scene.functional.outcome
    shared = first_ground(draft, other)
    if shared is None:
        raise MotionInfeasibleError(f"{other.id} does not come past behind it", where=draft.id)
    # How far it has come when its rear is at the other's way, and beyond it; where the other comes
    # behind it then, which goes to its left or to its right.
    nearest_m, comes_m = shared.enter_m - path.backwards[0][0], shared.other_enters_m
    across_m = nearest_m + other.body.width_m + _ACROSS_M
    turn = other.path.pose(comes_m).heading_rad - path.pose(0.0).heading_rad
    left_of_middle = (0.5 - scene.impact_share) * (1 if sin(turn) > 0 else -1)
    speed, stop = reversing_mps(scene, draft), _stop(scene, draft)
    braking_m, lag_s = speed**2 / (2 * stop.rate_mps2), 0.0
    wanted = scene.contact_wanted(draft.id, other.id)
    short = not wanted and (draft is scene.ego or stop.act is not None)
    event_m, rests_m = across_m, across_m + _ACROSS_M + braking_m
    if short:
        event_m, rests_m = nearest_m - _SHORT_M - braking_m, nearest_m - _SHORT_M
        lag_s = speed / stop.rate_mps2 + _STOOD_S
    elif wanted and _strikes(scene, draft):
        # Its rear touches the other's side; where on its width is said of the ego alone.
        share = 0.5 + (left_of_middle if draft is scene.ego else 0.0)
        comes_m += share * body.width_m + other.body.front_m - other.body.centre_ahead_m
        event_m, rests_m = nearest_m, across_m + braking_m
    elif other is scene.ego and outcome is not None and outcome.impact_percent is not None:
        # The other's front touches its side, whose middle is then where that is said.
        event_m = nearest_m + (0.5 + left_of_middle) * other.body.width_m
        event_m += body.rear_m + body.centre_ahead_m
        rests_m = event_m + _ACROSS_M + braking_m
    more_m = max(0.0, speed**2 / (2 * REVERSING_MPS2) + _HELD_S * speed - event_m)
    stand_square(scene, draft, more_m=more_m, straight_m=more_m + rests_m)
    begins_m = back_straight(scene, draft, speed, stop)
    if not (short or wanted):
        return None
    at_m = begins_m + event_m + more_m
    return Meeting(DANGER, draft.id, other.id, at_m, comes_m, lag_s, "comes past behind")


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
