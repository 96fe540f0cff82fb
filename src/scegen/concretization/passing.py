"""Passing another: pull out, draw level at a chosen place, pull in again."""

from __future__ import annotations

from math import pi, sqrt

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.lane_choice import change_lanes, entry_lanes, lanes_in, neighbour_lane
from scegen.concretization.limits import LANE_CHANGE_S, LATERAL_MPS2
from scegen.concretization.meetings import STRUCTURAL, Meeting
from scegen.concretization.setup import Setup, require_room
from scegen.scenario.bodies import Body
from scegen.scenario.vocabulary import HazardKind

FASTER = 1.5
"""One who overtakes drives this much faster than the one overtaken (own choice)."""
_BEHIND_M = 3.0
_AHEAD_M = 6.0
_BEFORE_TURNING_M = 3.0
_OF_GRIP = 0.8
_BEFORE_JUNCTION_M = 5.0


def change_length_m(speed_mps: float, seconds: float = LANE_CHANGE_S) -> float:
    """Length of a lane change of that duration, at least 8 m."""
    return max(8.0, speed_mps * seconds)


def calm_change_length_m(passer: DriveDraft, width_m: float) -> float:
    """Length of a change of lane that asks for no more than 4 m/s2 sideways, or what grip allows.

    Long enough for the speed at which one cruises, and no shorter than one takes in towns.
    """
    sideways = min(LATERAL_MPS2, _OF_GRIP * passer.grip_mps2)
    least = pi * passer.cruise_mps * sqrt(width_m / (2 * sideways))
    return max(change_length_m(min(passer.cruise_mps, 10.0)), least)


def slowing_s_m(draft: DriveDraft) -> float:
    """Where a drive begins to slow down for its turn, or its arm ends."""
    places = [mark.s_m for mark in draft.road_changes()]
    return min([draft.junction_s_m - _BEFORE_JUNCTION_M, *places])


def be_faster(scene: Setup, passer: DriveDraft, passed: DriveDraft) -> None:
    """Make the passer clearly faster: slow the other down rather than break the limit."""
    if passer.cruise_mps < FASTER * passed.cruise_mps:
        slower = passer.cruise_mps / FASTER
        reason = f"is overtaken by {passer.id}"
        scene.note(f"{passed.id}.speed_mps", slower, reason, passed.cruise_mps)
        passed.cruise_mps = slower


def pass_drive(
    scene: Setup, passer: DriveDraft, passed: DriveDraft, *, comes_back: bool
) -> list[Meeting]:
    """``passer`` overtakes ``passed`` on their common entry arm.

    Returns the meeting side by side.

    Raises:
        NeedsLongerArms: the arm is too short for it.
    """
    strays = HazardKind.ONCOMING_LANE in scene.kinds_by(passer.id)
    oncoming = lanes_in(scene, passer) == 1 or strays
    if strays:
        for draft in (passer, passed):
            if not draft.lane_changes:
                draft.entry_lane = min(entry_lanes(scene, draft))
                draft.lay(scene.network)
    lanes = entry_lanes(scene, passer)
    if comes_back or passed.entry_lane in lanes:
        passer.entry_lane = passed.entry_lane
    aside = neighbour_lane(scene, passer, oncoming=oncoming)
    back = passer.entry_lane in lanes and (comes_back or aside not in lanes)
    relative = max(passer.cruise_mps - passed.cruise_mps, 1.0)
    half = (passer.body.length_m + passed.body.length_m) / 2
    latest = min(slowing_s_m(passer), slowing_s_m(passed)) - _BEFORE_TURNING_M
    change = change_length_m(passer.cruise_mps)
    after = passer.cruise_mps * (half + _AHEAD_M) / relative + change if back else 0.0
    middle = latest - after
    out = middle - passer.cruise_mps * (half + _BEHIND_M) / relative - change
    require_room(passer.id, out, 0.0, 15.0)
    changes = [(out, change, aside)]
    if back:
        changes.append((latest - change, change, passer.entry_lane))
    change_lanes(scene, passer, changes)
    difference = passer.body.centre_ahead_m - passed.body.centre_ahead_m
    return [
        Meeting(STRUCTURAL, passed.id, passer.id, middle + difference, middle, 0.0, "side by side")
    ]


def pass_standing(
    scene: Setup, passer: DriveDraft, middle_m: float, body: Body, *, over_m: float | None = None
) -> None:
    """``passer`` goes round what stands in its lane, its centre at ``middle_m`` of the way.

    It changes lanes out and back over ``over_m`` each, or as its speed in towns asks for.

    Raises:
        NeedsLongerArms: there is no room before or behind it.
    """
    lane = passer.entry_lane
    aside = neighbour_lane(scene, passer, oncoming=True)
    change = over_m or change_length_m(min(passer.cruise_mps, 10.0))
    half = (passer.body.length_m + body.length_m) / 2
    centre = middle_m - passer.body.centre_ahead_m
    out = centre - half - _BEHIND_M - change
    require_room(passer.id, out, passer.body.rear_m + 2.0, 12.0)
    back = (centre + half + _BEHIND_M, change, lane)
    change_lanes(scene, passer, [(out, change, aside), back])
