"""Going back to a lane: after overtaking, or into that of somebody else."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding.meaning import conflicts, lane_moves
from scegen.understanding.semantics.context import Clause, Context

_HASTY = frozenset({"early", "soon", "closely", "close", "tightly"})


def pull_back(clause: Clause, context: Context) -> None:
    """``overtakes the ego and moves back in too early``: a cut-in.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    lanes = [p for p in clause.places() if p.kind == "lane"]
    if any(e.ego for p in lanes if p.owner is not None for e in p.owner.entities):
        conflicts.lane_change(clause, context)  # "moves back into the ego's lane"
        lane_moves.lane_change(clause, context)
        return
    others = [e for e in clause.drivers if not e.ego and Maneuver.OVERTAKE in e.maneuvers]
    last = context.tokens[clause.event.j - 1].low
    in_front = any(p.word.cat == "locus" and p.value == "ahead" for p in clause.event.pps)
    hasty = any(context.tokens[m.j - 1].low in _HASTY for m in clause.event.mods)
    lane = any(p.kind == "lane" for p in clause.places())  # "returned to its lane too soon"
    if others and (in_front or ((last == "in" or lane) and hasty) or clause.sudden is not None):
        context.draft.hazard(HazardKind.CUT_IN, clause.words, others)
