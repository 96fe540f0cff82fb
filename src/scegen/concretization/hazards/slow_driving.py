"""Slow driving: a third to a half of the limit."""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft, Scene
from scegen.concretization.hazards.rule import Rule, culprits, in_line_before, same_arm
from scegen.concretization.limits import SLOW_FACTOR, STOPPING_MPS2
from scegen.scenario.concrete import DistanceBelow, SpeedPhase
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

_LEAST_GAP_M = 4.0


def _prepare(scene: Scene, hazard: Hazard) -> None:
    for draft in culprits(scene, hazard):
        wanted = float(scene.rng.uniform(*SLOW_FACTOR)) * scene.limit_mps
        low, high = scene.allowed(f"{draft.id}.speed_mps", (wanted, wanted))
        speed = min(max(wanted, low), high, SLOW_FACTOR[1] * scene.limit_mps)
        scene.note(
            f"{draft.id}.speed_mps", speed, "slow driving: obstructs others", draft.cruise_mps
        )
        draft.cruise_mps = speed
    for draft in sorted(culprits(scene, hazard), key=lambda slow: slow.drive.rank):
        ahead = [d for d in in_line_before(scene, draft) if _is_slow(scene, d)]
        if ahead:
            # A line of slow ones drives as fast as its first.
            draft.cruise_mps = ahead[-1].cruise_mps


def _is_slow(scene: Scene, draft: DriveDraft) -> bool:
    return any(
        hazard.kind is HazardKind.SLOW_DRIVING and draft.id in hazard.by
        for hazard in scene.functional.hazards
    )


def _comes_up_behind(slow: DriveDraft, other: DriveDraft) -> bool:
    """Whether another stays or ends behind the slow one in its lane, and is faster."""
    if (
        not same_arm(slow, other)
        or other is slow
        or other.reactions
        or other.comes_up
        or other.deeds
    ):
        return False
    if other.cruise_mps <= slow.cruise_mps:
        return False
    if other.lane_changes:
        ends_there = other.lane_changes[-1].lane_after == slow.entry_lane
        return ends_there and other.entry_lane != slow.entry_lane
    return other.entry_lane == slow.entry_lane and slow.drive.rank < other.drive.rank


def _react(scene: Scene, hazard: Hazard) -> None:
    """Who comes up behind in the same lane slows down to the same speed, late."""
    for slow in culprits(scene, hazard):
        for other in scene.drives.values():
            if not _comes_up_behind(slow, other):
                continue
            bodies = slow.body.rear_m + other.body.front_m
            rate = other.braking_mps2(STOPPING_MPS2)
            braking = (other.cruise_mps - slow.cruise_mps) ** 2 / (2 * rate)
            other.reactions.append(
                SpeedPhase(
                    trigger=DistanceBelow(
                        participant=slow.id, distance_m=bodies + braking + _LEAST_GAP_M
                    ),
                    target_speed_mps=slow.cruise_mps,
                    rate_mps2=rate,
                    hazard=HazardKind.SLOW_DRIVING,
                )
            )
            other.reacts_at_s_m = slow.junction_s_m


SLOW_DRIVING = Rule(prepare=_prepare, react=_react)
