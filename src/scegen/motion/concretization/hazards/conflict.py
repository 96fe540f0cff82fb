"""Dangers that consist in arriving together without giving way."""

from __future__ import annotations

from scegen.motion.concretization.drafts import Scene
from scegen.motion.concretization.hazards.cut_in import come_in
from scegen.motion.concretization.hazards.rule import Rule, culprits
from scegen.motion.concretization.meetings import Meeting
from scegen.scenario.functional import Hazard


def _keep_going(scene: Scene, hazard: Hazard) -> None:
    for draft in culprits(scene, hazard):
        draft.stops_at_line = False


def _from_beside(scene: Scene, hazard: Hazard) -> list[Meeting]:
    """Where no junction is, one merges from the lane beside, unless it changes lanes anyway."""
    changes = any(draft.lane_changes for draft in culprits(scene, hazard))
    return [] if scene.network.junctions or changes else come_in(scene, hazard)


ARRIVES_TOGETHER = Rule(prepare=_keep_going, shape=_from_beside)
"""Merging conflict, unprotected left turn, red-light running, failure to yield."""

STANDS_OR_WALKS = Rule(meets=False)
"""Made by where somebody walks or stands, not by how anybody drives."""
