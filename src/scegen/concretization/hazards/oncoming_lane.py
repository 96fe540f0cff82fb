"""Oncoming lane: strays over the centre line and comes back before the junction."""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft, Setup
from scegen.concretization.hazards.rule import Rule, culprits
from scegen.concretization.hazards.swerving import meet_at_centre_line, stray
from scegen.concretization.lane_choice import entry_lanes
from scegen.concretization.limits import ABRUPT_LANE_CHANGE_S, LANE_CHANGE_S
from scegen.concretization.meetings import Meeting
from scegen.concretization.passing import change_length_m
from scegen.concretization.stationary import blocked_lane_ahead
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

_STAYS_S = 2.0
_ABRUPT = frozenset({HazardKind.SWERVING, HazardKind.LOSS_OF_CONTROL, HazardKind.SUDDEN_TURN})


def _over_the_line(scene: Setup, draft: DriveDraft) -> None:
    draft.entry_lane = min(entry_lanes(scene, draft))
    quick = any(h.kind in _ABRUPT and draft.id in h.by for h in scene.functional.hazards)
    change = change_length_m(draft.cruise_mps, ABRUPT_LANE_CHANGE_S if quick else LANE_CHANGE_S)
    stray(scene, draft, 0, change, _STAYS_S * draft.cruise_mps, HazardKind.ONCOMING_LANE)


def _shape(scene: Setup, hazard: Hazard) -> list[Meeting]:
    for draft in culprits(scene, hazard):
        if not draft.lane_changes and not blocked_lane_ahead(scene, draft):
            meet_at_centre_line(scene, hazard, draft)
            _over_the_line(scene, draft)
    return []


ONCOMING_LANE = Rule(shape=_shape)
