"""Going back to a lane: after overtaking, or into that of somebody else."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding.meaning import conflicts, lane_moves
from scegen.understanding.meaning.context import Context, Scene

_HASTY = frozenset({"early", "soon", "closely", "close", "tightly"})


def pull_back(scene: Scene, context: Context) -> None:
    """``overtakes the ego and moves back in too early``: a cut-in.

    Args:
        scene: what happens.
        context: the scenario in the making.
    """
    lanes = [p for p in scene.places() if p.kind == "lane"]
    if any(e.ego for p in lanes if p.owner is not None for e in p.owner.entities):
        conflicts.lane_change(scene, context)  # "moves back into the ego's lane"
        lane_moves.lane_change(scene, context)
        return
    others = [e for e in scene.drivers if not e.ego and Maneuver.OVERTAKE in e.maneuvers]
    last = context.tokens[scene.event.j - 1].low
    in_front = any(p.word.cat == "locus" and p.value == "ahead" for p in scene.event.pps)
    hasty = any(context.tokens[m.j - 1].low in _HASTY for m in scene.event.mods)
    lane = any(p.kind == "lane" for p in scene.places())  # "returned to its lane too soon"
    if others and (in_front or ((last == "in" or lane) and hasty) or scene.sudden is not None):
        context.draft.hazard(HazardKind.CUT_IN, scene.words, others)
