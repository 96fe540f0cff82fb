"""Where parked and blocking vehicles stand."""

from __future__ import annotations

from scegen.motion.concretization.drafts import DriveDraft, Scene
from scegen.motion.concretization.others import StandDraft
from scegen.motion.concretization.passing import pass_standing
from scegen.motion.standing import standing_path
from scegen.scenario.bodies import BODIES
from scegen.scenario.concrete import StandingMotion
from scegen.scenario.functional import Participant
from scegen.scenario.logical import Side, Standing
from scegen.scenario.vocabulary import DrivingSide

CLEAR_OF_CORNER_M = 6.0
"""From the junction to the nearest parked bumper: behind a crosswalk of 4 m set back by 1 m."""
_BETWEEN_M = 1.5
BLOCKS_AT_M = 45.0
"""A vehicle that blocks its lane stands this far before the junction, so that others get round."""
BLOCKS_STRAIGHT_AT_M = 15.0


def place_standers(scene: Scene) -> None:
    """Line them up from the junction outwards, those that hide somebody next to the corner."""
    filled: dict[tuple[int, Side, bool], float] = {}
    for standing in scene.logical.standings:
        participant = scene.functional.participant(standing.participant)
        key = (standing.arm, standing.side, standing.in_lane)
        body = BODIES[participant.kind]
        inner = filled.get(key, _first_free_m(scene, standing))
        towards = towards_junction(scene, standing)
        # The bumper that faces the junction: the front of one that heads for it.
        from_junction = inner + (body.front_m if towards else body.rear_m)
        filled[key] = inner + body.length_m + _BETWEEN_M
        scene.stands[participant.id] = _draft(scene, participant, standing, from_junction)


def _first_free_m(scene: Scene, standing: Standing) -> float:
    if not standing.in_lane:
        return CLEAR_OF_CORNER_M
    return BLOCKS_AT_M if scene.network.junctions else BLOCKS_STRAIGHT_AT_M


def _draft(
    scene: Scene, participant: Participant, standing: Standing, from_junction_m: float
) -> StandDraft:
    motion = StandingMotion(
        arm=standing.arm,
        side=standing.side,
        from_junction_m=round(from_junction_m, 3),
        in_lane=standing.in_lane,
    )
    path = standing_path(scene.network, motion, participant.kind, participant.id)
    scene.note(f"{participant.id}.from_junction_m", from_junction_m, "stands clear of the corner")
    return StandDraft(participant.id, participant.kind, standing, motion, path)


def towards_junction(scene: Scene, standing: Standing) -> bool:
    """Whether one who stands on that side heads for the junction."""
    right = standing.side is Side.RIGHT
    return right == (scene.network.driving_side is DrivingSide.RIGHT)


def blocked_lane_ahead(scene: Scene, draft: DriveDraft) -> bool:
    """Whether somebody stands in a drive's lane."""
    blocking = [stand for stand in scene.stands.values() if stand.standing.in_lane]
    return any(_place_on_way(scene, draft, stand) is not None for stand in blocking)


def go_round_standers(scene: Scene) -> None:
    """Who drives in the lane of a vehicle that blocks it goes round."""
    for stand in scene.stands.values():
        if not stand.standing.in_lane:
            continue
        for draft in scene.drives.values():
            place = _place_on_way(scene, draft, stand)
            if place is not None and not draft.lane_changes:
                pass_standing(scene, draft, place, BODIES[stand.kind])


def _place_on_way(scene: Scene, draft: DriveDraft, stand: StandDraft) -> float | None:
    """Where on its way a drive meets the middle of a vehicle in its lane; None if elsewhere."""
    body = BODIES[stand.kind]
    inbound = towards_junction(scene, stand.standing)
    arm = scene.road.arms[stand.standing.arm]
    if inbound and draft.drive.entry == arm.id and draft.entry_lane == arm.lanes_in:
        ahead = stand.motion.from_junction_m - body.centre_ahead_m
        return draft.laid.turning_starts_m - ahead
    if not inbound and draft.drive.exit == arm.id and draft.exit_lane == arm.lanes_out:
        ahead = stand.motion.from_junction_m + body.centre_ahead_m
        return draft.laid.turning_ends_m + ahead
    return None
