"""Which rule makes which danger; rules are applied in this order."""

from __future__ import annotations

from scegen.concretization.hazards.aside import (
    CROSSES,
    LOSES_CONTROL,
    OVERTAKES,
    STRAYS,
    TURNS_SUDDENLY,
)
from scegen.concretization.hazards.changing_speed import CHANGES_SPEED
from scegen.concretization.hazards.cut_in import CUT_IN
from scegen.concretization.hazards.pace import KEEPS_PACE, TAILGATES
from scegen.concretization.hazards.reversing import REVERSING
from scegen.concretization.hazards.rule import Rule
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

ARRIVES_TOGETHER = Rule()
"""Merging conflict, unprotected left turn, red-light running, failure to yield."""
STANDS_OR_WALKS = Rule(meets=False)
"""Made by where somebody walks or stands, not by how anybody drives."""

RULES: dict[HazardKind, Rule] = {
    HazardKind.REVERSING: REVERSING,
    HazardKind.SPEEDING: KEEPS_PACE,
    HazardKind.SLOW_DRIVING: KEEPS_PACE,
    HazardKind.SUDDEN_ACCELERATION: CHANGES_SPEED,
    HazardKind.SUDDEN_TURN: TURNS_SUDDENLY,
    HazardKind.OVERTAKING: OVERTAKES,
    HazardKind.CUT_IN: CUT_IN,
    HazardKind.ONCOMING_LANE: STRAYS,
    HazardKind.SWERVING: STRAYS,
    HazardKind.LOSS_OF_CONTROL: LOSES_CONTROL,
    HazardKind.TAILGATING: TAILGATES,
    HazardKind.HARD_BRAKING: CHANGES_SPEED,
    HazardKind.DELAYED_BRAKING: CHANGES_SPEED,
    HazardKind.STOPPING: CHANGES_SPEED,
    HazardKind.MERGING_CONFLICT: ARRIVES_TOGETHER,
    HazardKind.UNPROTECTED_LEFT_TURN: ARRIVES_TOGETHER,
    HazardKind.RED_LIGHT_RUNNING: ARRIVES_TOGETHER,
    HazardKind.FAILURE_TO_YIELD: ARRIVES_TOGETHER,
    HazardKind.CROSSING_PEDESTRIAN: STANDS_OR_WALKS,
    HazardKind.CROSSING_ANIMAL: STANDS_OR_WALKS,
    HazardKind.CROSSING_CYCLIST: CROSSES,
    HazardKind.OCCLUSION: STANDS_OR_WALKS,
    HazardKind.OBSTACLE: STANDS_OR_WALKS,
}


def ordered_rules(hazards: tuple[Hazard, ...]) -> list[tuple[Rule, Hazard]]:
    """The rules of some hazards, in the order of the table.

    Kinds without a rule of their own come last: their acts and ways make them, in time.
    """
    order = {kind: place for place, kind in enumerate(RULES)}
    ranked = sorted(hazards, key=lambda hazard: order.get(hazard.kind, len(order)))
    return [(RULES.get(hazard.kind, ARRIVES_TOGETHER), hazard) for hazard in ranked]
