"""Sudden turn: no slowing down until the last moment, and a fast bend."""

from __future__ import annotations

from scegen.motion.concretization.drafts import Scene
from scegen.motion.concretization.hazards.rule import Rule, culprits
from scegen.motion.concretization.limits import FAST_LATERAL_MPS2
from scegen.scenario.functional import Hazard


def _prepare(scene: Scene, hazard: Hazard) -> None:
    for draft in culprits(scene, hazard):
        draft.lateral_mps2 = FAST_LATERAL_MPS2
        draft.slowing_mps2 = 6.0
        draft.stops_at_line = False


SUDDEN_TURN = Rule(prepare=_prepare)
