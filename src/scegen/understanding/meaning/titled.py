"""Doings that a title names and that nobody does: "Cut-in: target from the left, ego 90 km/h"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.chunks import Event
from scegen.understanding.draft import Entity
from scegen.understanding.meaning.movements import follow_movement
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.rows import say

_INTO_LANES = frozenset({"cut_in", "lane_change", "cut_off"})
_TURNS = frozenset({Maneuver.LEFT, Maneuver.RIGHT})


def by_the_only_one(clauses: list[Clause], context: Context) -> None:
    """Lets the only one who can have done it do what a title names.

    Args:
        clauses: what happens, in the order of the text; those of titles get who acts.
        context: the scenario in the making, all else understood.
    """
    for clause in clauses:
        event = clause.event
        free = not (clause.actors or event.subject or event.negated or event.premod_of)
        if not free:
            continue
        told_again = next((s for s in clauses if s.event.name == event.name and s.actors), None)
        if told_again is not None:  # "Cut-out to the right: the lead car cuts out": that way
            clause.actors = told_again.actors if event.name in _INTO_LANES else []
            continue
        doer = _doer(event, context)
        if doer is None:
            continue
        told = _swerves(doer, event, clauses, context)
        told = told or clause
        follow_movement(told, context)
        say(f"dangers.{told.event.name}", told, context)


def _swerves(doer: Entity, event: Event, clauses: list[Clause], context: Context) -> Clause | None:
    """``Cut-out: … the lead swerves left``: into the next lane, as the title says."""
    aside = [s for s in clauses if s.event.name == "swerve" and doer in s.actors]
    if not aside or event.name == "turn":
        return None
    aside[0].event.name = event.name
    context.draft.dangers[:] = [
        d for d in context.draft.dangers if d.kind is not HazardKind.SWERVING or d.by != [doer]
    ]
    return aside[0]


def _doer(event: Event, context: Context) -> Entity | None:
    others = [e for e in context.draft.entities if e.moving_vehicle and e.stands is None]
    if event.name == "turn":
        turning = [e for e in others if e.maneuvers & _TURNS]
        return turning[0] if len(turning) == 1 else None
    if event.name not in _INTO_LANES or context.junction.crossing:
        return None
    others = [e for e in others if not e.ego and not e.maneuvers and not context.oncoming(e)]
    words = {t.low for t in context.tokens[event.i : event.j]}
    if "out" in words:
        others = [e for e in others if context.placed(e, Approach.AHEAD)]
    elif event.name == "lane_change":
        return None
    return others[0] if len(others) == 1 else None
