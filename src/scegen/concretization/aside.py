"""Moves to the side at a junction: how long they are, where they are over, who is near then.

A move is told from where it is over: just before the drive slows down for its turn.
"""

from scegen.concretization.amounts import gripped_s, overlapping_m
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.limits import CUT_IN_HEADWAY_S, LANE_CHANGE_S, LATE_BRAKING_MPS2
from scegen.concretization.meetings import STRUCTURAL, Meeting, nearest_s_m
from scegen.concretization.setup import Setup, require_room
from scegen.concretization.tale import outward
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import MOST_OFFSET_M, LaneChange
from scegen.scenario.roadway import LANE_WIDTH_M
from scegen.scenario.spacings import START, Measure
from scegen.scenario.vocabulary import Maneuver, Side

_BEHIND_M = 3.0
"""The room that one who goes round somebody has before it pulls out."""
_LEAST_M = 8.0
_BEFORE_TURNING_M, _BEFORE_JUNCTION_M = 3.0, 5.0
_LEAST_RUN_UP_M, _SPARE_M = 5.0, 10.0
_MUCH_FASTER_MPS, _GAP_M = 3.5, 1.5
_SAME_LINE_M = 2.0


def change_length_m(draft: DriveDraft, usual_s: float = LANE_CHANGE_S) -> float:
    """How long a change of lane is: as quick as is usual, if the grip allows it."""
    lasts_s = max(usual_s, gripped_s(LANE_WIDTH_M, draft.grip_mps2))
    return max(_LEAST_M, draft.speed_mps * lasts_s)


def over_by_m(*drafts: DriveDraft) -> float:
    """Where moves are over: before any of them slows down for its turn, or its arm ends."""
    places = [mark.s_m for draft in drafts for mark in draft.road_changes()]
    ends = [draft.junction_s_m - _BEFORE_JUNCTION_M for draft in drafts]
    return min([*ends, *places]) - _BEFORE_TURNING_M


def keep_aside(scene: Setup) -> None:
    """Let those keep beside the middle of their lane of whom the text says how far aside they are.

    Of two, the ego keeps the middle of its own. Bodies that are said to overlap only in part where
    they touch do so to the outer side where none is said.
    """
    for said in scene.functional.spacings:
        who, other = (scene.drives.get(name) for name in (said.participant, said.reference))
        if said.measure is Measure.LATERAL_OFFSET_M and said.at == START and who and other:
            _put_aside(scene, who, other, said.value.middle)
        elif said.measure is Measure.OVERLAP_PERCENT and who and other:
            side = said.side or (Side.LEFT if who is scene.ego else Side.RIGHT)
            apart_m = overlapping_m(said.value.middle, who.body, other.body)
            _put_aside(scene, who, other, apart_m if side is Side.LEFT else -apart_m)
    outcome = scene.functional.outcome
    if outcome is not None and outcome.impact_percent is not None:
        left_m = scene.struck_left_m(scene.ego.body)
        for name in sorted({*outcome.between} & {*scene.drives} - {scene.ego.id}):
            _put_aside(scene, scene.drives[name], scene.ego, left_m)


def _put_aside(scene: Setup, who: DriveDraft, other: DriveDraft, left_m: float) -> None:
    """Of two who come on one arm, one keeps so far to the left of the other's line."""
    if who.drive.entry != other.drive.entry:
        return
    if who is scene.ego and other is not who:
        who, other, left_m = other, who, -left_m
    lanes = outward(scene.functional, Side.LEFT) * (other.entry_lane - who.entry_lane)
    aside_m = left_m + lanes * scene.road.arms[who.drive.entry].lane_width_m
    who.offset_m = max(-MOST_OFFSET_M, min(aside_m, MOST_OFFSET_M))


def close_before(
    scene: Setup, draft: DriveDraft, other: DriveDraft, station_m: float
) -> list[Meeting]:
    """At a station of its drive, one is close before another; who is much faster brakes late.

    Not if the other does not come along there.
    """
    place_m = draft.laid.path_s_m(station_m)
    pose = draft.path.pose(place_m)
    there_m, apart_m = nearest_s_m(other.path, pose.x_m, pose.y_m)
    if apart_m > _SAME_LINE_M:
        return []
    closing = other.course.speed_at(there_m) - draft.course.speed_at(place_m)
    if closing < _MUCH_FASTER_MPS:
        headway = float(scene.rng.uniform(*CUT_IN_HEADWAY_S))
        gap = headway * other.speed_mps
        reason = f"comes into its lane {headway:.2f} s ahead"
    else:
        gap = _GAP_M + closing**2 / (2 * LATE_BRAKING_MPS2)
        reason = f"comes up behind {draft.id}"
    met = max(0.0, there_m - gap - draft.body.rear_m - other.body.front_m)
    return [Meeting(STRUCTURAL, draft.id, other.id, place_m, met, 0.0, reason)]


def pass_standing(scene: Setup, passer: DriveDraft, middle_m: float, body: Body) -> None:
    """``passer`` goes round what stands in its lane, its centre at ``middle_m`` of the way.

    Who is to change lanes does not come back, if the lane beside leads where it goes.

    Raises:
        NeedsLongerArms: there is no room before it.
    """
    change = change_length_m(passer)
    clear = (passer.body.length_m + body.length_m) / 2 + _BEHIND_M
    middle = middle_m - passer.body.centre_ahead_m
    lane = passer.entry_lane - 1  # maybe that of the oncoming
    moves = [(middle - clear - change, lane)]
    if passer.drive.maneuver is not Maneuver.LANE_CHANGE or lane not in scene.entry_lanes(passer):
        moves.append((middle + clear, passer.entry_lane))
    require_room(passer.id, moves[0][0], _LEAST_RUN_UP_M, _SPARE_M)
    length_m = round(change, 3)
    passer.lane_changes = [
        LaneChange(position_m=round(max(0.0, at_m), 3), length_m=length_m, lane_after=after)
        for at_m, after in moves
    ]
    passer.lay(scene.network)
