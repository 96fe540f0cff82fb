"""Dangers that consist in arriving together without giving way."""

from __future__ import annotations

from scegen.motion.concretization.drafts import Scene
from scegen.motion.concretization.hazards.rule import Rule, culprits
from scegen.scenario.functional import Hazard


def _keep_going(scene: Scene, hazard: Hazard) -> None:
    for draft in culprits(scene, hazard):
        draft.stops_at_line = False


ARRIVES_TOGETHER = Rule(prepare=_keep_going)
"""Merging conflict, unprotected left turn, red-light running, failure to yield."""

STANDS_OR_WALKS = Rule(meets=False)
"""Made by where somebody walks or stands, not by how anybody drives."""
