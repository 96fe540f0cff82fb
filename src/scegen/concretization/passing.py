"""Out of the lane and back at a junction: past another, round what stands there, or for no reason.

A move is told from where it is over.
"""

from __future__ import annotations

from math import pi, sqrt

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.limits import LANE_CHANGE_S, LATERAL_MPS2
from scegen.concretization.meetings import STRUCTURAL, Meeting
from scegen.concretization.setup import Setup, require_room
from scegen.errors import MotionInfeasibleError
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import LaneChange
from scegen.scenario.vocabulary import HazardKind

_FASTER = 1.5
"""One who overtakes drives this much faster than the one overtaken (own choice)."""
_BEHIND_M, _AHEAD_M = 3.0, 6.0
BEFORE_TURNING_M = 3.0
_OF_GRIP = 0.8
_BEFORE_JUNCTION_M = 5.0
_LEAST_RUN_UP_M, _SPARE_M = 5.0, 10.0


def change_length_m(speed_mps: float, seconds: float = LANE_CHANGE_S) -> float:
    """Length of a lane change of that duration, at least 8 m."""
    return max(8.0, speed_mps * seconds)


def calm_change_length_m(scene: Setup, passer: DriveDraft) -> float:
    """Length of a change of lane that asks for no more than 4 m/s2 sideways, or what grip allows.

    Long enough for the speed at which one cruises, and no shorter than one takes in towns.
    """
    sideways = min(LATERAL_MPS2, _OF_GRIP * passer.grip_mps2)
    width_m = scene.road.arms[passer.drive.entry].lane_width_m
    least = pi * passer.cruise_mps * sqrt(width_m / (2 * sideways))
    return max(change_length_m(min(passer.cruise_mps, 10.0)), least)


def over_by_m(*drafts: DriveDraft | None) -> float:
    """Where moves are over: before any of them slows down for its turn, or its arm ends."""
    places = [mark.s_m for draft in drafts if draft for mark in draft.road_changes()]
    ends = [draft.junction_s_m - _BEFORE_JUNCTION_M for draft in drafts if draft]
    return min([*ends, *places]) - BEFORE_TURNING_M


def neighbour_lane(scene: Setup, draft: DriveDraft, *, oncoming: bool) -> int:
    """The lane into which a drive pulls out: towards the centre line, else outwards.

    ``oncoming`` allows (and where there is one lane, chooses) the oncoming lane.

    Raises:
        MotionInfeasibleError: there is only one lane and the oncoming one is not allowed.
    """
    if draft.entry_lane > 1 or oncoming:
        return draft.entry_lane - 1
    if scene.lanes_in(draft) > 1:
        return 2
    raise MotionInfeasibleError(
        f"arm {draft.drive.entry} has one lane: there is no lane to change into", where=draft.id
    )


def move_aside(
    scene: Setup,
    draft: DriveDraft,
    lane: int,
    *,
    ends_m: float,
    over_m: float,
    stays_m: float | None = None,
    hazard: HazardKind | None = None,
    offset_m: float = 0.0,
) -> float:
    """Lay a drive anew with a change of lane over ``over_m``, and back again after ``stays_m``.

    All is over at station ``ends_m``. It goes ``offset_m`` left of the middle of that lane. Returns
    the station at which it begins.

    Raises:
        NeedsLongerArms: the arm is too short for a run-up.
    """
    moves = [(ends_m - over_m, draft.entry_lane if stays_m is not None else lane)]
    if stays_m is not None:
        moves.insert(0, (ends_m - 2 * over_m - stays_m, lane))
    require_room(draft.id, moves[0][0], _LEAST_RUN_UP_M, _SPARE_M)
    draft.lane_changes += [
        LaneChange(
            position_m=round(max(0.0, position_m), 3),
            length_m=round(over_m, 3),
            lane_after=after,
            offset_m=0.0 if n else offset_m,
            hazard=hazard,
        )
        for n, (position_m, after) in enumerate(moves)
    ]
    draft.lay(scene.network)
    return moves[0][0]


def pass_drive(
    scene: Setup, passer: DriveDraft, passed: DriveDraft, *, comes_back: bool
) -> list[Meeting]:
    """``passer`` overtakes ``passed`` on their entry arm: that one is slow, rather than it fast.

    Returns the meeting side by side.

    Raises:
        NeedsLongerArms: the arm is too short for it.
    """
    slower = passer.cruise_mps / _FASTER
    if passed.cruise_mps > slower:
        before = passed.cruise_mps
        scene.note(f"{passed.id}.speed_mps", slower, f"is overtaken by {passer.id}", before)
        passed.cruise_mps = slower
    strays = HazardKind.ONCOMING_LANE in scene.kinds_by(passer.id)
    for draft in (passer, passed) if strays else ():
        if not draft.lane_changes:
            draft.take_lane(scene.network, min(scene.entry_lanes(draft)))
    lanes = scene.entry_lanes(passer)
    if comes_back or passed.entry_lane in lanes:
        passer.entry_lane = passed.entry_lane
    aside = neighbour_lane(scene, passer, oncoming=strays or scene.lanes_in(passer) == 1)
    back = passer.entry_lane in lanes and (comes_back or aside not in lanes)
    per_m = passer.cruise_mps / max(passer.cruise_mps - passed.cruise_mps, 1.0)
    half = (passer.body.length_m + passed.body.length_m) / 2
    before, after = per_m * (half + _BEHIND_M), per_m * (half + _AHEAD_M)
    ends, change = over_by_m(passer, passed), change_length_m(passer.cruise_mps)
    middle = ends - after - change if back else ends
    stays = before + after if back else None
    over = ends if back else middle - before
    move_aside(scene, passer, aside, ends_m=over, over_m=change, stays_m=stays)
    level = middle + passer.body.centre_ahead_m - passed.body.centre_ahead_m
    return [Meeting(STRUCTURAL, passed.id, passer.id, level, middle, 0.0, "side by side")]


def pass_standing(scene: Setup, passer: DriveDraft, middle_m: float, body: Body) -> None:
    """``passer`` goes round what stands in its lane, its centre at ``middle_m`` of the way.

    Raises:
        NeedsLongerArms: there is no room before it.
    """
    change = calm_change_length_m(scene, passer)
    clear = (passer.body.length_m + body.length_m) / 2 + _BEHIND_M
    ends = middle_m - passer.body.centre_ahead_m + clear + change
    lane = neighbour_lane(scene, passer, oncoming=True)
    move_aside(scene, passer, lane, ends_m=ends, over_m=change, stays_m=2 * clear)
