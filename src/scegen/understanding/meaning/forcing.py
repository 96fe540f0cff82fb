"""Dangers from forcing others to react."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding.semantics.context import Clause, Context

_ABRUPT = frozenset({HazardKind.CUT_IN, HazardKind.SWERVING, HazardKind.ONCOMING_LANE,
                     HazardKind.MERGING_CONFLICT})  # fmt: skip
"""What forces others already, so that nothing more needs to be said."""


def cause(clause: Clause, context: Context) -> None:
    """A parked vehicle that makes others react stands in their way; who changes lanes cuts in."""
    _cut_in(clause, context)
    _turn_across(clause, context)
    parked = [e for e in clause.actors if e.still]
    if parked:
        context.draft.hazard(HazardKind.OBSTACLE, clause.words, parked)
    let = clause.event.lemma == "let"
    walkers = [e for e in clause.targets if not e.is_vehicle]
    if let and walkers and not clause.event.negated:
        context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, clause.words, walkers)


def _cut_in(clause: Clause, context: Context) -> None:
    """``changes lanes, forcing a van to brake``: close before it."""
    by = [e for e in clause.drivers if e.maneuvers == {Maneuver.LANE_CHANGE} and not e.ego]
    known = {e.index for d in context.draft.dangers if d.kind in _ABRUPT for e in d.by}
    forced = [e for e in clause.targets if e.moving_vehicle]
    if by and forced and not known & {e.index for e in by} and not clause.event.passive:
        context.draft.hazard(HazardKind.CUT_IN, clause.words, by, forced)


def _turn_across(clause: Clause, context: Context) -> None:
    """``an oncoming truck turns left, forcing the ego to brake``: across its way."""
    across = Maneuver(context.across)
    by = [e for e in clause.drivers if e.maneuvers == {across} and context.oncoming(e)]
    known = any(d.kind is HazardKind.UNPROTECTED_LEFT_TURN for d in context.draft.dangers)
    forced = [e for e in clause.targets if e.moving_vehicle]
    if by and forced and not known and not clause.event.passive:
        context.draft.hazard(HazardKind.UNPROTECTED_LEFT_TURN, clause.words, by, forced)
