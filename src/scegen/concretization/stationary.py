"""Where parked and blocking vehicles stand."""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.others import StandDraft
from scegen.concretization.passing import pass_standing
from scegen.concretization.setup import Setup
from scegen.motion.standing import standing_path
from scegen.scenario.concrete import StandingMotion
from scegen.scenario.functional import Participant
from scegen.scenario.logical import Standing
from scegen.scenario.vocabulary import DrivingSide, Maneuver, Side

_GO_ROUND = frozenset({Maneuver.LANE_CHANGE, Maneuver.OVERTAKE})
CLEAR_OF_CORNER_M = 6.0
"""From the junction to the nearest parked bumper: behind a crosswalk of 4 m set back by 1 m."""
_ROOM_TO_PULL_OUT_M = 30.0
_BETWEEN_M = 1.5
_BEFORE_PULLING_OUT_M = 7.0
"""In a row, who pulls out needs this much before it."""
BLOCKS_AT_M = 45.0
"""A vehicle that blocks its lane stands this far before the junction, so that others get round."""
BLOCKS_STRAIGHT_AT_M = 15.0


def passed_where_they_stand(scene: Setup) -> tuple[Standing, ...]:
    """Those who are said to stay in their lane while somebody from behind goes round them."""
    passers = [d for d in scene.logical.drives if d.maneuver in _GO_ROUND]
    kerb = Side(scene.functional.junction.driving_side.value)
    return tuple(
        Standing(participant=drive.participant, arm=drive.entry, side=kerb, in_lane=True)
        for drive in scene.logical.drives
        if drive.maneuver is Maneuver.STAY
        and drive.participant != scene.functional.ego.id
        and any(p.entry == drive.entry and p.rank > drive.rank for p in passers)
    )


def place_stationary(scene: Setup) -> None:
    """Line them up from the junction outwards, those that hide somebody next to the corner."""
    filled: dict[tuple[int, Side, bool], float] = {}
    for standing in (*scene.logical.standings, *passed_where_they_stand(scene)):
        participant = scene.functional.participant(standing.participant)
        key = (standing.arm, standing.side, standing.in_lane)
        body = participant.body
        inner = filled.get(key, _first_free_m(scene, standing))
        if key in filled and participant.pulls_out and towards_junction(scene, standing):
            inner += _BEFORE_PULLING_OUT_M
        towards = towards_junction(scene, standing)
        # The bumper that faces the junction: the front of one that heads for it.
        from_junction = inner + (body.front_m if towards else body.rear_m)
        filled[key] = inner + body.length_m + _BETWEEN_M
        scene.stands[participant.id] = _draft(scene, participant, standing, from_junction)


def _first_free_m(scene: Setup, standing: Standing) -> float:
    if not standing.in_lane:
        pulls_out = any(
            scene.functional.participant(other.participant).pulls_out
            for other in scene.logical.standings
            if other.arm == standing.arm
        )
        room = not scene.network.plain and pulls_out
        return _ROOM_TO_PULL_OUT_M if room else CLEAR_OF_CORNER_M
    return BLOCKS_AT_M if not scene.network.plain else BLOCKS_STRAIGHT_AT_M


def _draft(
    scene: Setup, participant: Participant, standing: Standing, from_junction_m: float
) -> StandDraft:
    motion = StandingMotion(
        arm=standing.arm,
        side=standing.side,
        from_junction_m=round(from_junction_m, 3),
        in_lane=standing.in_lane,
        strip=participant.strip,
    )
    path = standing_path(scene.network, motion, participant.body, participant.id)
    scene.note(f"{participant.id}.from_junction_m", from_junction_m, "stands clear of the corner")
    name, kind, body = participant.id, participant.kind, participant.body
    return StandDraft(name, kind, body, standing, motion, path)


def towards_junction(scene: Setup, standing: Standing) -> bool:
    """Whether one who stands on that side heads for the junction."""
    right = standing.side is Side.RIGHT
    return right == (scene.network.driving_side is DrivingSide.RIGHT)


def blocked_lane_ahead(scene: Setup, draft: DriveDraft) -> bool:
    """Whether somebody stands in a drive's lane."""
    blocking = [stand for stand in scene.stands.values() if stand.standing.in_lane]
    return any(_place_on_way(scene, draft, stand) is not None for stand in blocking)


def go_round_stationary(scene: Setup) -> None:
    """Who drives in the lane of a vehicle that blocks it goes round."""
    for stand in scene.stands.values():
        if not stand.standing.in_lane:
            continue
        for draft in scene.drives.values():
            place = _place_on_way(scene, draft, stand)
            if place is not None and not draft.lane_changes:
                pass_standing(scene, draft, place, stand.body)


def _place_on_way(scene: Setup, draft: DriveDraft, stand: StandDraft) -> float | None:
    """Where on its way a drive meets the middle of a vehicle in its lane; None if elsewhere."""
    body = stand.body
    inbound = towards_junction(scene, stand.standing)
    arm = scene.road.arms[stand.standing.arm]
    if inbound and draft.drive.entry == arm.id and draft.entry_lane == arm.lanes_in:
        ahead = stand.motion.from_junction_m - body.centre_ahead_m
        return draft.laid.turning_starts_m - ahead
    if not inbound and draft.drive.exit == arm.id and draft.exit_lane == arm.lanes_out:
        ahead = stand.motion.from_junction_m + body.centre_ahead_m
        return draft.laid.turning_ends_m + ahead
    return None
