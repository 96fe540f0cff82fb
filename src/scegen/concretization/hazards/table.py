"""Which rule makes which danger; rules are applied in this order."""

from __future__ import annotations

from scegen.concretization.hazards.aside import LOSES_CONTROL, STRAYS, TURNS_SUDDENLY
from scegen.concretization.hazards.changing_speed import CHANGES_SPEED
from scegen.concretization.hazards.cut_in import CUT_IN
from scegen.concretization.hazards.reversing import REVERSING
from scegen.concretization.hazards.rule import Rule
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

ARRIVES_TOGETHER = Rule()
"""Dangers that are who meets whom and how fast: the logical scenario has it, timing makes it."""
STANDS_OR_WALKS = Rule(meets=False)
"""Made by where somebody walks or stands, not by how anybody drives."""

RULES: dict[HazardKind, Rule] = {
    HazardKind.REVERSING: REVERSING,
    HazardKind.SUDDEN_ACCELERATION: CHANGES_SPEED,
    HazardKind.SUDDEN_TURN: TURNS_SUDDENLY,
    HazardKind.CUT_IN: CUT_IN,
    HazardKind.ONCOMING_LANE: STRAYS,
    HazardKind.SWERVING: STRAYS,
    HazardKind.LOSS_OF_CONTROL: LOSES_CONTROL,
    HazardKind.TAILGATING: ARRIVES_TOGETHER,
    HazardKind.HARD_BRAKING: CHANGES_SPEED,
    HazardKind.DELAYED_BRAKING: CHANGES_SPEED,
    HazardKind.STOPPING: CHANGES_SPEED,
    HazardKind.CROSSING_PEDESTRIAN: STANDS_OR_WALKS,
    HazardKind.CROSSING_ANIMAL: STANDS_OR_WALKS,
    HazardKind.CROSSING_CYCLIST: STANDS_OR_WALKS,
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
