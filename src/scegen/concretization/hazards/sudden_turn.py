"""Sudden turn: no slowing down until the last moment, and a fast bend.

One whose way has no bend turns the wheel all the same: into the lane beside, and back.
"""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft, Setup
from scegen.concretization.hazards.rule import Rule, culprits
from scegen.concretization.hazards.swerving import swerve
from scegen.concretization.limits import FAST_LATERAL_MPS2
from scegen.concretization.meetings import Meeting
from scegen.scenario.functional import Hazard

_BEND_RAD = 0.35


def _prepare(scene: Setup, hazard: Hazard) -> None:
    for draft in culprits(scene, hazard):
        draft.lateral_mps2 = FAST_LATERAL_MPS2
        draft.slowing_mps2 = 6.0


def _shape(scene: Setup, hazard: Hazard) -> list[Meeting]:
    return [
        meeting
        for draft in culprits(scene, hazard)
        if not _bends(draft)
        for meeting in swerve(scene, draft, hazard)
    ]


def _bends(draft: DriveDraft) -> bool:
    heading = draft.laid.path.heading_rad
    return bool(abs(heading - heading[0]).max() > _BEND_RAD)


SUDDEN_TURN = Rule(prepare=_prepare, shape=_shape)
