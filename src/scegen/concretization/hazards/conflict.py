"""Dangers that consist in arriving together without giving way."""

from __future__ import annotations

from scegen.concretization.drafts import Scene
from scegen.concretization.hazards.cut_in import come_in, on_arm
from scegen.concretization.hazards.rule import Rule, culprits, pairs, same_arm
from scegen.concretization.hazards.swerving import swerve
from scegen.concretization.lane_choice import lanes_in
from scegen.concretization.meetings import Meeting, drives_meet
from scegen.errors import MotionInfeasibleError
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import Maneuver


def _keep_going(scene: Scene, hazard: Hazard) -> None:
    for draft in culprits(scene, hazard):
        draft.stops_at_line = False


def _from_beside(scene: Scene, hazard: Hazard) -> list[Meeting]:
    """Where no junction is, one merges from the lane beside, unless it changes lanes anyway."""
    changes = any(draft.lane_changes for draft in culprits(scene, hazard))
    if scene.network.junctions or changes:
        return []
    for culprit, victim in pairs(scene, hazard):
        if same_arm(culprit, victim) and lanes_in(scene, culprit) == 1:
            raise MotionInfeasibleError(
                f"the road has one lane per direction: no lane from which {culprit.id} could come "
                f"into that of {victim.id}",
                where=culprit.id,
                hint="Say that the road has more lanes, or where else it comes from.",
            )
    return come_in(scene, hazard)


ARRIVES_TOGETHER = Rule(prepare=_keep_going, shape=_from_beside)
"""Merging conflict, unprotected left turn, red-light running, failure to yield."""


def _across(scene: Scene, hazard: Hazard) -> list[Meeting]:
    """A rider ahead who does not turn off comes over from the kerb, in front of one behind it."""
    meetings: list[Meeting] = []
    for rider, other in pairs(scene, hazard):
        if not same_arm(rider, other) or rider.lane_changes or other.lane_changes:
            continue
        if drives_meet(rider, other) is not None or rider.drive.turn is not Maneuver.STRAIGHT:
            continue
        if lanes_in(scene, rider) > 1:
            meetings += on_arm(scene, rider, other, hazard.kind)
        else:
            meetings += swerve(scene, rider, hazard)
    return meetings


CROSSES = Rule(shape=_across, meets=False)
"""Somebody rides across another's way: as one who crosses, or coming over from ahead."""

STANDS_OR_WALKS = Rule(meets=False)
"""Made by where somebody walks or stands, not by how anybody drives."""
