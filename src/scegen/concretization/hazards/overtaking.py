"""Overtaking: out, past and in again on the approach, clearly faster than the other."""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft, Setup
from scegen.concretization.hazards.rule import Rule, pairs, same_arm
from scegen.concretization.lane_choice import lanes_in
from scegen.concretization.meetings import Meeting
from scegen.concretization.passing import FASTER, pass_drive
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind


def overtake_speeds(scene: Setup, passer: DriveDraft, passed: DriveDraft) -> None:
    """Make the passer clearly faster: slow the other down rather than break the limit."""
    if passer.cruise_mps >= FASTER * passed.cruise_mps:
        return
    slower = passer.cruise_mps / FASTER
    scene.note(f"{passed.id}.speed_mps", slower, f"is overtaken by {passer.id}", passed.cruise_mps)
    passed.cruise_mps = slower


def _couples(scene: Setup, hazard: Hazard) -> list[tuple[DriveDraft, DriveDraft]]:
    couples = [(c, v) for c, v in pairs(scene, hazard) if same_arm(c, v)]
    if couples:
        return couples[:1]
    culprits = {c.id: c for c, _ in pairs(scene, hazard)}
    return [
        (c, d)
        for c in culprits.values()
        for d in scene.drives.values()
        if d is not c and same_arm(c, d)
    ][:1]


def _prepare(scene: Setup, hazard: Hazard) -> None:
    for passer, passed in _couples(scene, hazard):
        overtake_speeds(scene, passer, passed)


def _shape(scene: Setup, hazard: Hazard) -> list[Meeting]:
    meetings: list[Meeting] = []
    for passer, passed in _couples(scene, hazard):
        if passer.lane_changes:
            continue
        oncoming = lanes_in(scene, passer) == 1
        meetings += pass_drive(
            scene,
            passer,
            passed,
            oncoming=oncoming,
            comes_back=True,
            hazard=HazardKind.OVERTAKING,
        )
    return meetings


OVERTAKING = Rule(prepare=_prepare, shape=_shape)
