"""Tailgating: a time gap of 0.4 to 0.8 s at the leader's speed, and braking as late."""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft, Setup
from scegen.concretization.hazards.rule import Rule, pairs, same_arm
from scegen.concretization.limits import TAILGATING_HEADWAY_S
from scegen.concretization.meetings import STRUCTURAL, Meeting
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

_LEAST_GAP_M = 2.0
_NOTICES = 0.9
"""The follower reacts when a tenth of the free gap is gone."""
_SLOWER_START_S = 0.8
_PLACE = 0.5


def _couples(scene: Setup, hazard: Hazard) -> list[tuple[DriveDraft, DriveDraft]]:
    return [(c, v) for c, v in pairs(scene, hazard) if same_arm(c, v)][:1]


def _shape(scene: Setup, hazard: Hazard) -> list[Meeting]:
    meetings = []
    for follower, leader in _couples(scene, hazard):
        headway = float(scene.rng.uniform(*TAILGATING_HEADWAY_S))
        follower.entry_lane = leader.entry_lane
        comes_up = _comes_up_fast(scene, follower, leader)
        if not comes_up:
            follower.cruise_mps = leader.cruise_mps
        follower.lateral_mps2 = leader.lateral_mps2
        follower.lay(scene.network)
        gap = max(_LEAST_GAP_M, headway * leader.cruise_mps)
        bodies = leader.body.rear_m + follower.body.front_m
        place = leader.junction_s_m * _PLACE
        scene.note(f"{follower.id}.headway_s", headway, f"tailgating {leader.id}")
        meetings.append(
            Meeting(
                STRUCTURAL - 1,
                leader.id,
                follower.id,
                place,
                place - gap - bodies,
                0.0,
                f"tailgating at {headway:.2f} s",
            )
        )
    return meetings


def _comes_up_fast(scene: Setup, follower: DriveDraft, leader: DriveDraft) -> bool:
    """Whether the follower is said to be speeding, and the leader is not."""
    speeding = [h.by for h in scene.functional.hazards if h.kind is HazardKind.SPEEDING]
    fast = any(follower.id in by for by in speeding)
    alone = not any(leader.id in by for by in speeding)
    return fast and alone and follower.cruise_mps > leader.cruise_mps


TAILGATING = Rule(shape=_shape, meets=False)
