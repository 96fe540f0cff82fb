"""Slow driving: a third to a half of the limit."""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft, Setup
from scegen.concretization.hazards.rule import Rule, culprits, in_line_before
from scegen.concretization.limits import SLOW_FACTOR
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

_LEAST_GAP_M = 4.0


def _prepare(scene: Setup, hazard: Hazard) -> None:
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


def _is_slow(scene: Setup, draft: DriveDraft) -> bool:
    return any(
        hazard.kind is HazardKind.SLOW_DRIVING and draft.id in hazard.by
        for hazard in scene.functional.hazards
    )


SLOW_DRIVING = Rule(prepare=_prepare)
