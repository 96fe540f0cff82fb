"""Dangers that consist in arriving together without giving way."""

from __future__ import annotations

from scegen.concretization.drafts import Setup
from scegen.concretization.hazards.cut_in import on_arm
from scegen.concretization.hazards.rule import Rule, pairs, same_arm
from scegen.concretization.hazards.swerving import swerve
from scegen.concretization.lane_choice import lanes_in
from scegen.concretization.meetings import Meeting, drives_meet
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import Maneuver

ARRIVES_TOGETHER = Rule()
"""Merging conflict, unprotected left turn, red-light running, failure to yield."""


def _across(scene: Setup, hazard: Hazard) -> list[Meeting]:
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
