"""Swerving and loss of control: two quick lane changes there and back."""

from __future__ import annotations

from scegen.motion.concretization.drafts import DriveDraft, Scene
from scegen.motion.concretization.hazards.rule import Rule, culprits
from scegen.motion.concretization.lane_choice import change_lanes, neighbour_lane
from scegen.motion.concretization.limits import ABRUPT_LANE_CHANGE_S, HARD_BRAKING_MPS2
from scegen.motion.concretization.marks import Mark
from scegen.motion.concretization.meetings import Meeting
from scegen.motion.concretization.passing import change_length_m, slowing_s_m
from scegen.motion.concretization.room import NeedsLongerArms
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind, JunctionKind

_STAYS_M = 1.0


def swerve(scene: Scene, draft: DriveDraft, kind: HazardKind) -> None:
    """Out of the lane and back before the junction, or around the middle of a plain road.

    One that leaves its lane for another danger (cuts in, strays into oncoming traffic) does both
    in one.
    """
    if draft.lane_changes:
        return
    length = change_length_m(draft.cruise_mps, ABRUPT_LANE_CHANGE_S)
    whole = 2 * length + _STAYS_M
    if scene.network.junctions:
        end = slowing_s_m(draft) - 2.0
    else:
        end = (draft.laid.path.length_m + whole) / 2
    start = end - whole
    if start < 10.0:
        raise NeedsLongerArms(15.0 - start, draft.id)
    lane = draft.entry_lane
    aside = neighbour_lane(scene, draft, oncoming=scene.road.kind is not JunctionKind.ROUNDABOUT)
    change_lanes(scene, draft, [(start, length, aside), (end - length, length, lane)], kind)


def _swerving(scene: Scene, hazard: Hazard) -> list[Meeting]:
    for draft in culprits(scene, hazard):
        swerve(scene, draft, HazardKind.SWERVING)
    return []


def _losing(scene: Scene, hazard: Hazard) -> list[Meeting]:
    for draft in culprits(scene, hazard):
        swerve(scene, draft, HazardKind.LOSS_OF_CONTROL)
    return []


def _brake(scene: Scene, hazard: Hazard) -> None:
    """Loss of control ends in hard braking to walking pace."""
    for draft in culprits(scene, hazard):
        changes = draft.lane_changes
        if not changes:
            continue
        place = draft.laid.path_s_m(changes[-1].position_m)
        rate = draft.braking_mps2(HARD_BRAKING_MPS2[0])
        draft.add_mark(Mark(place, 2.0, rate, HazardKind.LOSS_OF_CONTROL, hold_s=1.0))


SWERVING = Rule(shape=_swerving)
LOSS_OF_CONTROL = Rule(shape=_losing, act=_brake)
